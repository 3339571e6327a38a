// Structures of which only the matrices are known.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

std::string draw_body(Drawing& drawing, const Problem& problem) {
  constexpr double kHalfWidth = 2.2, kPitch = 1.25;
  constexpr std::size_t kMostRows = 4;
  const std::vector<SingleStop> stops = single_stops(problem);
  const std::vector<int> loaded = loaded_coordinates(problem);
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
  body.labels.push_back({.place = {0.0, 0.15}, .words = "M, D, K"});
  body.labels.push_back(
      {.place = {0.0, -1.3 * kTextSize}, .words = fmt::format("{} coordinates", problem.size())});
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
    node.labels.push_back({.place = pad + Place(-0.5, 0.14),
                           .words = fmt::format("{}u[{}]", stop.forward ? "" : "−", stop.dof)});
    const double gap = drawn_gap(stop.least_gap, largest_gap(problem)) + 0.07;
    const bool compliant = has_compliant_stops(problem);
    draw_stop(drawing, pad + Place(gap, 0.0), {1.0, 0.0}, {.compliant = compliant, .half = 0.32});
    drawing.add("gap").labels.push_back(
        {.place = pad + Place(gap + (compliant ? kStopDepth : 0.0) + 0.35, -0.35 * kTextSize),
         .words = gap_text(stop),
         .anchor = Anchor::start,
         .ink = Ink::contact});
  }
  for (std::size_t row = 0; row < std::min(loaded.size(), kMostRows); ++row) {
    const double y = y_of(row, loaded.size());
    const Place tip(-edge(y) - 0.04, y), tail = tip - Place(1.1, 0.0);
    draw_load(drawing, tail, tip,
              {.place = tail - Place(0.15, 0.35 * kTextSize),
               .words = fmt::format("u[{}]: {}", loaded[row], load_text(problem, loaded[row])),
               .anchor = Anchor::end});
  }
  const auto hidden = static_cast<std::ptrdiff_t>(pair_stops(problem).size()) + other_stops(problem) +
                      std::max(std::ptrdiff_t{0}, std::ssize(stops) - static_cast<std::ptrdiff_t>(kMostRows));
  std::string text = "structure from matrices";
  if (hidden > 0) text += fmt::format(", {} more contact{}", hidden, hidden == 1 ? "" : "s");
  return text;
}

}  // namespace signorini
