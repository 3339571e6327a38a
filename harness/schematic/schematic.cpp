#include "harness/schematic/schematic.hpp"

#include <fmt/format.h>

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
  std::string operator()(const Rotor& rotor) const { return draw_rotor(drawing, problem, rotor); }
  std::string operator()(const Shaft& shaft) const { return draw_shaft(drawing, problem, shaft); }
};

}  // namespace

Drawing schematic(const Problem& problem, const SystemLayout& layout) {
  Drawing drawing{.title = problem.title.empty() ? problem.name : problem.name + ": " + problem.title};
  const std::string remark = std::visit(DrawModel{drawing, problem}, layout);
  const Box box = extent(drawing);
  Place below(box.low.x(), box.low.y() - 2.0 * kTextSize);
  for (const std::string& line : {remark, motion_note(problem)}) {
    if (line.empty()) continue;
    drawing.add("note").labels.push_back(
        {.place = below, .words = line, .anchor = Anchor::start, .ink = Ink::note});
    below.y() -= 1.5 * kTextSize;
  }
  return drawing;
}

}  // namespace signorini
