#include "harness/schematic/schematic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

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
  const std::string remark =
      std::visit([&](const auto& model) { return draw_model(drawing, problem, model); }, layout);
  const Box box = extent(drawing);
  Place below(box.low.x(), box.low.y() - 2.0 * kTextSize);
  for (const std::string& line : {remark, motion_note(problem) + dampers_note(damped)}) {
    if (line.empty()) continue;
    draw_text(drawing.add("note"), below, line, Ink::note, Anchor::start);
    below.y() -= 1.5 * kTextSize;
  }
  return drawing;
}

std::string draw_model(Drawing& drawing, const Problem& problem, const std::monostate& /*matrices*/) {
  constexpr double kHalfWidth = 2.2, kPitch = 1.25;
  constexpr std::size_t kMostRows = 4;
  const std::vector<SingleStop> stops = single_stops(problem);
  const std::vector<int> loaded = loaded_coordinates(problem);
  const bool compliant = has_springs(problem);
  const std::size_t rows = std::min(kMostRows, std::max(stops.size(), loaded.size()));
  const double half_height = std::max(1.1, 0.5 * kPitch * static_cast<double>(rows) + 0.35);
  Part& body = drawing.add("body");
  Stroke outline{.fill = Fill::body, .closed = true, .width = 0.045};
  constexpr int kCorners = 96;
  constexpr double kExponent = 0.55;  // a superellipse: a box with round corners
  const auto rounded = [](double c) { return std::copysign(std::pow(std::abs(c), kExponent), c); };
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    outline.places.emplace_back(kHalfWidth * rounded(std::cos(angle)),
                                half_height * rounded(std::sin(angle)));
  }
  body.strokes.push_back(std::move(outline));
  draw_text(body, {0.0, 0.15}, "M, D, K");
  draw_text(body, {0.0, -1.3 * kTextSize}, fmt::format("{} coordinates", problem.size()));
  const auto y_of = [&](std::size_t row, std::size_t count) {
    return kPitch * (0.5 * static_cast<double>(std::min(count, kMostRows) - 1) - static_cast<double>(row));
  };
  const auto edge = [&](double y) {
    return kHalfWidth * std::pow(1.0 - std::pow(std::abs(y) / half_height, 2.0 / kExponent), 0.5 * kExponent);
  };
  for (std::size_t row = 0; row < std::min(stops.size(), kMostRows); ++row) {
    const SingleStop& stop = stops[row];
    const double y = y_of(row, stops.size());
    const Place pad(edge(y) + 1.1, y);
    Part& node = drawing.add("contact-node");
    draw_line(node, {{edge(y), y}, pad});
    draw_circle(node, pad, 0.07, Fill::ink);
    draw_text(node, pad + Place(-0.5, 0.14), fmt::format("{}u[{}]", stop.forward ? "" : "−", stop.dof));
    const double gap = drawn_gap(stop.least_gap, problem) + 0.07;
    draw_stop(drawing, pad + Place(gap, 0.0), {1.0, 0.0}, {.compliant = compliant, .half = 0.32});
    draw_text(drawing.add("gap"), pad + Place(gap + (compliant ? kStopDepth : 0.0) + 0.35, -0.35 * kTextSize),
              gap_text(stop), Ink::contact, Anchor::start);
  }
  for (std::size_t row = 0; row < std::min(loaded.size(), kMostRows); ++row) {
    const double y = y_of(row, loaded.size());
    const Place tip(-edge(y) - 0.04, y), tail = tip - Place(1.1, 0.0);
    draw_load(drawing, tail, tip, tail - Place(0.15, 0.35 * kTextSize),
              fmt::format("u[{}]: {}", loaded[row], load_text(problem, loaded[row])), Anchor::end);
  }
  const auto shown = static_cast<std::ptrdiff_t>(std::min(stops.size(), kMostRows));
  return "structure from matrices" +
         hidden_text(std::ssize(pair_stops(problem)) + other_stops(problem) + std::ssize(stops) - shown,
                     "more contact");
}

}  // namespace signorini
