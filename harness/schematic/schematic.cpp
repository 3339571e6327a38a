#include "harness/schematic/schematic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "harness/schematic/boundary.hpp"

namespace signorini {

namespace {

/// The model, drawn by its own function.
struct DrawModel {
  Drawing& drawing;
  const Problem& problem;

  std::string operator()(const std::monostate& /*matrices*/) const { return draw_body(drawing, problem); }
  std::string operator()(const Chain& chain) const { return draw_chain(drawing, problem, chain); }
  std::string operator()(const Bar& bar) const { return draw_bar(drawing, problem, bar); }
  std::string operator()(const Beam& beam) const { return draw_beams(drawing, problem, beam); }
  std::string operator()(const BlockMesh& mesh) const { return draw_block(drawing, problem, mesh); }
  std::string operator()(const std::shared_ptr<const SolidMesh>& mesh) const {
    return draw_solid(drawing, problem, *mesh);
  }
  std::string operator()(const Rotor& rotor) const { return draw_rotor(drawing, problem, rotor); }
  std::string operator()(const Shaft& shaft) const { return draw_shaft(drawing, problem, shaft); }
};

/// The springs of damped stops where they meet the structure: what its own model knows how to draw.
Problem without_faces(Problem problem, const std::vector<DampedStop>& damped) {
  if (damped.empty()) return problem;
  problem.contacts = contacts_of_structure(std::move(problem.contacts), damped);
  for (const DampedStop& stop : damped)
    problem.contacts[static_cast<std::size_t>(stop.contact)].law = Spring{stop.stiffness};
  return problem;
}

/// " and 2 N s/m"
std::string dampers_note(const std::vector<DampedStop>& damped) {
  if (damped.empty()) return "";
  const auto [least, most] = std::ranges::minmax_element(damped, {}, &DampedStop::damping);
  return " and " + range_text(least->damping, most->damping, "N s/m");
}

}  // namespace

Drawing schematic(const Problem& scene, const SystemLayout& layout, const std::vector<DampedStop>& damped) {
  const Problem problem = without_faces(scene, damped);
  Drawing drawing{.title = problem.title.empty() ? problem.name : problem.name + ": " + problem.title,
                  .damped_stops = !damped.empty()};
  const std::string remark = std::visit(DrawModel{drawing, problem}, layout);
  const Box box = extent(drawing);
  Place below(box.low.x(), box.low.y() - 2.0 * kTextSize);
  for (const std::string& line : {remark, motion_note(problem) + dampers_note(damped)}) {
    if (line.empty()) continue;
    drawing.add("note").labels.push_back(
        {.place = below, .words = line, .anchor = Anchor::start, .ink = Ink::note});
    below.y() -= 1.5 * kTextSize;
  }
  return drawing;
}

}  // namespace signorini
