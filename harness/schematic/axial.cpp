#include "harness/schematic/axial.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

// Of the pin below a mass, and of the stops beside it [cm].
constexpr double kPin = 0.8, kPinned = 0.3;

void draw_end_stop(Drawing& drawing, const Problem& problem, const SingleStop& stop,
                   const AxialPoint& point) {
  const double middle = 0.5 * (point.top + point.bottom), half = 0.42 * (point.top - point.bottom);
  const Place face(*point.face + drawn_gap(stop.least_gap, problem), middle);
  draw_stop(drawing, face, {1.0, 0.0}, {.compliant = has_springs(problem), .half = half});
  const double above = point.top + 0.3;
  draw_gap(drawing, {*point.face, above}, {face.x(), above}, {face.x() + 0.5, above - 0.35 * kTextSize},
           gap_text(stop), Anchor::start);
  for (const double x : {*point.face, face.x()})
    draw_line(drawing.parts.back(), {{x, middle + half + 0.06}, {x, above + 0.12}}, Ink::note, kThin);
}

void draw_pin_stop(Drawing& drawing, const Problem& problem, const SingleStop& stop, const AxialPoint& point,
                   bool both, const std::string& words) {
  const double sign = stop.forward ? 1.0 : -1.0, y = point.bottom - kPin + kPinned;
  draw_line(drawing.add("pin"), {{point.x, point.bottom}, {point.x, point.bottom - kPin}}, Ink::structure,
            0.09);
  const Place face(point.x + sign * drawn_gap(stop.least_gap, problem), y);
  const bool compliant = has_springs(problem) && point.room > 2.0 * kStopDepth;
  draw_stop(drawing, face, {sign, 0.0}, {.compliant = compliant, .half = kPinned - 0.05});
  if (words.empty()) return;
  if (both) {
    const double behind = face.x() + sign * ((compliant ? kStopDepth : 0.0) + 0.35);
    draw_gap(drawing, face, face, {behind, y - 0.35 * kTextSize}, words,
             stop.forward ? Anchor::start : Anchor::end);
    return;
  }
  const double below = point.bottom - kPin - 0.2;
  draw_gap(drawing, {point.x, below}, {face.x(), below},
           {0.5 * (point.x + face.x()), below - 0.2 - 0.75 * kTextSize}, words);
}

/// One text for all pins of a scene, where they differ and are too close for a text each.
std::optional<Label> text_of_all_pins(const std::vector<SingleStop>& stops, const AxialPlaces& places) {
  SingleStop all;
  bool equal = true;
  double widest = 0.0;
  std::optional<AxialPoint> first, last;
  std::string first_words;
  for (const SingleStop& stop : stops) {
    const std::optional<AxialPoint> point = places(stop.dof);
    if (!point || stands_at_end(stop, stops, places)) continue;
    const std::string words = gap_text(stop);
    if (!first) {
      first = point;
      first_words = words;
    }
    equal = equal && words == first_words;
    all.add(stop);
    widest = std::max(widest, extent(Label{.words = words}).size().x());
    last = point;
  }
  if (equal || widest <= last->room) return std::nullopt;
  return Label{.place = {0.5 * (first->x + last->x), last->bottom - kPin - 1.2 * kTextSize},
               .words = gap_text(all),
               .ink = Ink::contact};
}

}  // namespace

bool stands_at_end(const SingleStop& stop, const std::vector<SingleStop>& all, const AxialPlaces& places) {
  const std::optional<AxialPoint> point = places(stop.dof);
  return point && point->face && stop.forward && !has_other_side(stop, all);
}

void draw_axial_stops(Drawing& drawing, const Problem& problem, const AxialPlaces& places) {
  const std::vector<SingleStop> stops = single_stops(problem);
  const std::optional<Label> in_one = text_of_all_pins(stops, places);
  std::string before;
  for (const SingleStop& stop : stops) {
    const std::optional<AxialPoint> point = places(stop.dof);
    if (!point) continue;
    if (stands_at_end(stop, stops, places)) {
      draw_end_stop(drawing, problem, stop, *point);
      continue;
    }
    const bool both = has_other_side(stop, stops);
    const std::string words = gap_text(stop);
    draw_pin_stop(drawing, problem, stop, *point, both, in_one || (words == before && !both) ? "" : words);
    before = words;
  }
  if (in_one) drawing.add("gap").labels.push_back(*in_one);
}

void draw_axial_loads(Drawing& drawing, const Problem& problem, const AxialPlaces& places) {
  constexpr std::size_t kMostTexts = 2;
  const std::vector<int> loaded = loaded_coordinates(problem);
  const std::vector<SingleStop> stops = single_stops(problem);
  const bool at_end =
      std::ranges::any_of(stops, [&](const SingleStop& stop) { return stands_at_end(stop, stops, places); });
  struct Load {
    Place foot, from, to;
    Label label;
  };
  std::vector<Load> loads;
  for (const int dof : loaded) {
    const std::optional<AxialPoint> point = places(dof);
    if (!point) continue;
    const double length = std::min(1.1, 0.75 * point->room);
    const double start = point->x - (point->face == point->x ? 0.9 : 0.55) * length;
    const double y = point->top + (at_end ? 0.8 : 0.32);
    const std::string words = loaded.size() > kMostTexts ? "" : load_text(problem, dof);
    loads.push_back({{start, point->top},
                     {start, y},
                     {start + length, y},
                     {.place = {start + 0.5 * length, y + 0.2}, .words = words}});
  }
  // All labels are on one line.
  const bool crowded = std::ranges::adjacent_find(loads, [](const Load& one, const Load& next) {
                         return extent(one.label).high.x() > extent(next.label).low.x();
                       }) != loads.end();
  for (Load& load : loads) {
    if (crowded) load.label.words = "f(t)";
    draw_load(drawing, load.from, load.to, load.label.place, load.label.words);
    draw_line(drawing.parts.back(), {load.foot, load.from}, Ink::load);
  }
}

std::string draw_model(Drawing& drawing, const Problem& problem, const Bar& bar) {
  constexpr double kLength = 8.0, kHalf = 0.4;
  constexpr int kMostStops = 10;
  draw_wall(drawing, {0.0, -1.7 * kHalf}, {0.0, 1.7 * kHalf});
  draw_meshed_box(drawing, "bar", {0.0, -kHalf}, {kLength, kHalf}, bar.elements);
  const std::vector<SingleStop> stops = single_stops(problem);
  const int count = static_cast<int>(stops.size()), every = (count + kMostStops - 1) / kMostStops;
  std::vector<int> left_out;  // coordinates, rising
  for (int i = 0; i < count; ++i)
    if (i % every != 0) left_out.push_back(stops[static_cast<std::size_t>(i)].dof);
  const AxialPlaces all = [&](int node) -> std::optional<AxialPoint> {
    AxialPoint point{.x = kLength * (node + 1) / bar.elements,
                     .top = kHalf,
                     .bottom = -kHalf,
                     .room = kLength / std::max(1, std::min(count, kMostStops))};
    if (node + 1 == bar.elements) point.face = kLength;
    return point;
  };
  draw_axial_stops(drawing, problem, [&](int node) {
    return std::ranges::binary_search(left_out, node) ? std::nullopt : all(node);
  });
  draw_axial_loads(drawing, problem, all);
  const auto hidden = std::ssize(left_out) + std::ssize(pair_stops(problem)) + other_stops(problem);
  return fmt::format("elastic bar, {}, {}{}", elements_text(bar.elements),
                     range_text(bar.length, bar.length, "m"),
                     hidden > 0 ? fmt::format(", {} more stops", hidden) : "");
}

}  // namespace signorini
