// A bar in tension and compression.

#include <fmt/format.h>

#include <algorithm>

#include "harness/schematic/axial.hpp"
#include "harness/schematic/mesh_lines.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

std::string draw_bar(Drawing& drawing, const Problem& problem, const Bar& bar) {
  constexpr double kLength = 8.0, kHalf = 0.4;
  constexpr int kMostStops = 10;
  draw_wall(drawing, {0.0, -1.7 * kHalf}, {0.0, 1.7 * kHalf});
  draw_box(drawing.add("bar"), {0.0, -kHalf}, {kLength, kHalf}, Fill::body);
  Part& mesh = drawing.add("mesh");
  for (const double share : mesh_lines(bar.elements))
    mesh.strokes.push_back(
        {.places = {{share * kLength, -kHalf}, {share * kLength, kHalf}}, .ink = Ink::note, .width = 0.018});
  const auto stops = static_cast<int>(single_stops(problem).size());
  const int every = (stops + kMostStops - 1) / kMostStops;
  int seen = 0;  // stops are asked for in the order of their coordinates
  std::vector<int> left_out;
  for (const SingleStop& stop : single_stops(problem))
    if (every > 1 && seen++ % every != 0) left_out.push_back(stop.dof);
  const AxialPlaces all = [&](int node) -> std::optional<AxialPoint> {
    AxialPoint point{.x = kLength * (node + 1) / bar.elements,
                     .top = kHalf,
                     .bottom = -kHalf,
                     .room = kLength / std::max(1, std::min(stops, kMostStops))};
    if (node + 1 == bar.elements) point.face = kLength;
    return point;
  };
  draw_axial_stops(drawing, problem, [&](int node) {
    return std::ranges::binary_search(left_out, node) ? std::nullopt : all(node);
  });
  draw_axial_loads(drawing, problem, all);
  std::string text = fmt::format("elastic bar, {}, {}", elements_text(bar.elements),
                                 range_text(bar.length, bar.length, "m"));
  if (const auto hidden = std::ssize(left_out) + static_cast<std::ptrdiff_t>(pair_stops(problem).size()) +
                          other_stops(problem);
      hidden > 0)
    text += fmt::format(", {} more stops", hidden);
  return text;
}

}  // namespace signorini
