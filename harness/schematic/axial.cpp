#include "harness/schematic/axial.hpp"

#include <algorithm>

#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

// Of the pin below a mass, and of the stops beside it [cm].
constexpr double kPin = 0.8, kPinned = 0.3;

bool has_other_side(const SingleStop& stop, const std::vector<SingleStop>& all) {
  return std::ranges::any_of(
      all, [&](const SingleStop& other) { return other.dof == stop.dof && other.forward != stop.forward; });
}

void draw_end_stop(Drawing& drawing, const Problem& problem, const SingleStop& stop,
                   const AxialPoint& point) {
  const double gap = drawn_gap(stop.least_gap, largest_gap(problem));
  const double middle = 0.5 * (point.top + point.bottom), half = 0.42 * (point.top - point.bottom);
  const Place face(*point.face + gap, middle);
  draw_stop(drawing, face, {1.0, 0.0}, {.compliant = has_compliant_stops(problem), .half = half});
  const double above = point.top + 0.3;
  const Label label{
      .place = {face.x() + 0.5, above - 0.35 * kTextSize}, .words = gap_text(stop), .anchor = Anchor::start};
  draw_gap(drawing, {*point.face, above}, {face.x(), above}, label);
  Part& part = drawing.parts.back();
  for (const double x : {*point.face, face.x()})
    part.strokes.push_back(
        {.places = {{x, middle + half + 0.06}, {x, above + 0.12}}, .ink = Ink::note, .width = 0.018});
}

void draw_pin_stop(Drawing& drawing, const Problem& problem, const SingleStop& stop, const AxialPoint& point,
                   bool both, const std::string& words) {
  const double sign = stop.forward ? 1.0 : -1.0;
  const double gap = drawn_gap(stop.least_gap, largest_gap(problem));
  const double y = point.bottom - kPin + kPinned;
  draw_line(drawing.add("pin"), {{point.x, point.bottom}, {point.x, point.bottom - kPin}});
  drawing.parts.back().strokes.back().width = 0.09;
  const Place face(point.x + sign * gap, y);
  const bool compliant = has_compliant_stops(problem) && point.room > 2.0 * kStopDepth;
  draw_stop(drawing, face, {sign, 0.0}, {.compliant = compliant, .half = kPinned - 0.05});
  if (words.empty()) return;
  if (both) {
    const double behind = face.x() + sign * ((compliant ? kStopDepth : 0.0) + 0.35);
    draw_gap(drawing, face, face,
             {.place = {behind, y - 0.35 * kTextSize},
              .words = words,
              .anchor = stop.forward ? Anchor::start : Anchor::end});
    return;
  }
  const double below = point.bottom - kPin - 0.2;
  draw_gap(drawing, {point.x, below}, {face.x(), below},
           {.place = {0.5 * (point.x + face.x()), below - 0.2 - 0.75 * kTextSize}, .words = words});
}

/// Whether the pins of a scene are too close for a text each, and the text for all.
struct PinTexts {
  bool in_one = false;
  Label label = {};

  PinTexts(const std::vector<SingleStop>& stops, const AxialPlaces& places) {
    SingleStop all;
    bool equal = true;
    double widest = 0.0, room = 0.0, from = 0.0, to = 0.0, bottom = 0.0;
    std::string first;
    for (const SingleStop& stop : stops) {
      const std::optional<AxialPoint> point = places(stop.dof);
      if (!point || stands_at_end(stop, stops, places)) continue;
      const std::string words = gap_text(stop);
      if (first.empty()) {
        first = words;
        all = stop;
        from = point->x;
      } else {
        all.contacts += stop.contacts;
        all.least_gap = std::min(all.least_gap, stop.least_gap);
        all.largest_gap = std::max(all.largest_gap, stop.largest_gap);
      }
      equal = equal && words == first;
      widest = std::max(widest, extent(Label{.words = words}).size().x());
      room = point->room;
      to = point->x;
      bottom = point->bottom;
    }
    in_one = !equal && widest > room;
    label = {.place = {0.5 * (from + to), bottom - kPin - 1.2 * kTextSize},
             .words = gap_text(all),
             .ink = Ink::contact};
  }
};

}  // namespace

bool stands_at_end(const SingleStop& stop, const std::vector<SingleStop>& all, const AxialPlaces& places) {
  const std::optional<AxialPoint> point = places(stop.dof);
  return point && point->face && stop.forward && !has_other_side(stop, all);
}

void draw_axial_stops(Drawing& drawing, const Problem& problem, const AxialPlaces& places) {
  const std::vector<SingleStop> stops = single_stops(problem);
  const PinTexts texts(stops, places);
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
    draw_pin_stop(drawing, problem, stop, *point, both,
                  texts.in_one || (words == before && !both) ? "" : words);
    before = words;
  }
  if (texts.in_one) drawing.add("gap").labels.push_back(texts.label);
}

namespace {

struct AxialLoad {
  Place foot = Place::Zero(), from = Place::Zero(), to = Place::Zero();
  Label label = {};
};

// All labels are on one line.
bool overlap(const std::vector<AxialLoad>& loads) {
  const auto into_next = [](const AxialLoad& one, const AxialLoad& next) {
    return extent(one.label).high.x() > extent(next.label).low.x();
  };
  return std::ranges::adjacent_find(loads, into_next) != loads.end();
}

}  // namespace

void draw_axial_loads(Drawing& drawing, const Problem& problem, const AxialPlaces& places) {
  constexpr double kUp = 0.32, kAboveGap = 0.8, kAboveArrow = 0.2;
  constexpr std::size_t kMostTexts = 2;
  const std::vector<int> loaded = loaded_coordinates(problem);
  const std::vector<SingleStop> stops = single_stops(problem);
  const bool at_end =
      std::ranges::any_of(stops, [&](const SingleStop& stop) { return stands_at_end(stop, stops, places); });
  std::vector<AxialLoad> loads;
  for (const int dof : loaded) {
    const std::optional<AxialPoint> point = places(dof);
    if (!point) continue;
    const double length = std::min(1.1, 0.75 * point->room);
    const double start = point->x - (point->face == point->x ? 0.9 : 0.55) * length;
    const double y = point->top + (at_end ? kAboveGap : kUp);
    const std::string words = loaded.size() > kMostTexts ? "" : load_text(problem, dof);
    loads.push_back({.foot = {start, point->top},
                     .from = {start, y},
                     .to = {start + length, y},
                     .label = {.place = {start + 0.5 * length, y + kAboveArrow}, .words = words}});
  }
  const bool crowded = overlap(loads);
  for (AxialLoad& load : loads) {
    if (crowded) load.label.words = "f(t)";
    draw_load(drawing, load.from, load.to, load.label);
    draw_line(drawing.parts.back(), {load.foot, load.from}, Ink::load);
  }
}

}  // namespace signorini
