// Beams in bending, clamped at their left ends, one below the other; deflections point down.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

constexpr double kBeamLength = 9.0, kBeamHalf = 0.14, kBetweenBeams = 2.3;  // [cm]

/// The way in which a stop is approached.
Place toward(const SingleStop& stop) { return {0.0, stop.forward ? -1.0 : 1.0}; }

/// Beams on paper.
class BeamPicture {
 public:
  BeamPicture(Drawing& drawing, const Problem& problem, const Beam& beam)
      : drawing_(drawing), problem_(problem), beam_(beam), compliant_(has_springs(problem)) {}

  void draw() {
    draw_wall(drawing_, {0.0, middle(beam_.count - 1) - 0.7}, {0.0, 0.7});
    for (int beam = 0; beam < beam_.count; ++beam)
      draw_meshed_box(drawing_, "beam", {0.0, middle(beam) - kBeamHalf},
                      {kBeamLength, middle(beam) + kBeamHalf}, beam_.elements);
    const std::vector<SingleStop> stops = single_stops(problem_);
    for (int beam = 0; beam < beam_.count; ++beam) {
      for (const bool forward : {true, false}) {
        std::vector<SingleStop> own;
        std::ranges::copy_if(stops, std::back_inserter(own), [&](const SingleStop& stop) {
          return beam_of(stop.dof) == beam && stop.forward == forward && stop.dof % 2 == 0;
        });
        draw_stops(own);
      }
    }
    for (const SingleStop& stop : stops) hidden_ += stop.dof % 2 == 1 ? stop.contacts : 0;
    draw_pair_stops();
    draw_loads(stops);
  }

  [[nodiscard]] std::string remark() const {
    const bool one = beam_.count == 1;
    return fmt::format("{}, {}{}, {}{}", one ? "beam" : fmt::format("{} beams", beam_.count),
                       elements_text(beam_.elements), one ? "" : " each",
                       range_text(beam_.length, beam_.length, "m"),
                       hidden_text(hidden_ + other_stops(problem_), "more contact", " not drawn"));
  }

 private:
  [[nodiscard]] int beam_of(int dof) const { return dof / (2 * beam_.elements); }
  [[nodiscard]] double x_of(int dof) const {
    const int node = dof % (2 * beam_.elements) / 2 + 1;
    return kBeamLength * node / beam_.elements;
  }
  static double middle(int beam) { return -kBetweenBeams * beam; }
  [[nodiscard]] Place place_of(int dof) const { return {x_of(dof), middle(beam_of(dof))}; }

  /// Those of one side of a beam.
  void draw_stops(const std::vector<SingleStop>& stops) {
    constexpr std::size_t kMostBeamStops = 20;  // drawn one by one
    if (stops.empty()) return;
    SingleStop all;
    for (const SingleStop& stop : stops) all.add(stop);
    if (stops.size() > kMostBeamStops)
      draw_rail(stops, gap_text(all));
    else
      draw_row(stops, gap_text(all));
  }

  /// Many stops side by side, as one line through their faces.
  void draw_rail(const std::vector<SingleStop>& stops, const std::string& words) {
    const bool forward = stops.front().forward;
    const Place way = toward(stops.front());
    std::vector<Place> faces;
    for (const SingleStop& stop : stops)
      faces.push_back(place_of(stop.dof) + (kBeamHalf + drawn_gap(stop.least_gap, problem_)) * way);
    Part& part = drawing_.add("rail");
    draw_line(part, faces, Ink::contact, kThick);
    const Place low = faces.front(), high = faces.back(), depth = (compliant_ ? 0.55 : 0.0) * way;
    constexpr std::size_t kSprings = 9;  // a few stand for all
    for (std::size_t i = 0; compliant_ && i < kSprings; ++i) {
      const Place& face = faces[(faces.size() - 1) * i / (kSprings - 1)];
      draw_stop_spring(part, face, Place(face.x(), low.y()) + depth);
    }
    const Place from = low + depth - Place(0.15, 0.0), to(high.x() + 0.15, from.y());
    hatch_line(part, forward ? to : from, forward ? from : to, Ink::contact);
    const Place below = 0.5 * (from + to) + 0.3 * way - Place(0.0, forward ? 0.75 * kTextSize : 0.0);
    draw_text(drawing_.add("gap"), below, words, Ink::contact);
  }

  /// Stops one by one, each with its text if there is room for all, else with one for all.
  void draw_row(const std::vector<SingleStop>& stops, const std::string& words) {
    double room = kBeamLength, longest = 0.0, lowest = 0.0;
    for (std::size_t i = 1; i < stops.size(); ++i)
      room = std::min(room, x_of(stops[i].dof) - x_of(stops[i - 1].dof));
    for (const SingleStop& stop : stops)
      longest = std::max(longest, extent(Label{.words = gap_text(stop)}).size().x());
    const double half = std::min(0.32, 0.4 * room), behind = (compliant_ ? kStopDepth : 0.0) + 0.3;
    const bool named = room > longest;
    const Place way = toward(stops.front()), aside(-half - 0.14, 0.0);
    for (const SingleStop& stop : stops) {
      const Place surface = place_of(stop.dof) + kBeamHalf * way;
      const Place face = surface + drawn_gap(stop.least_gap, problem_) * way;
      draw_stop(drawing_, face, way, {.compliant = compliant_, .half = half});
      const Place below = face + behind * way - Place(0.0, stop.forward ? 0.75 * kTextSize : 0.0);
      if (named) draw_gap(drawing_, surface + aside, face + aside, below, gap_text(stop));
      lowest = std::max(lowest, std::abs(below.y() - surface.y()));
    }
    if (named) return;
    const Place first = place_of(stops.front().dof), last = place_of(stops.back().dof);
    draw_text(drawing_.add("gap"),
              Place(0.5 * (first.x() + last.x()), first.y()) + (kBeamHalf + lowest) * way, words,
              Ink::contact);
  }

  /// Between neighbours, at the same place along them.
  [[nodiscard]] bool is_drawn(const PairStop& pair) const {
    return beam_of(pair.other) == beam_of(pair.closing) + 1 && x_of(pair.other) == x_of(pair.closing) &&
           pair.other % 2 == 0 && pair.closing % 2 == 0;
  }

  /// A buffer on the lower beam that the upper one meets.
  void draw_buffer(const PairStop& pair) {
    const Place below = place_of(pair.other) + Place(0.0, kBeamHalf);
    const Place face = place_of(pair.closing) - Place(0.0, kBeamHalf + drawn_gap(pair.gap, problem_));
    Part& part = drawing_.add("stop");
    draw_line(part, {face - Place(0.25, 0.0), face + Place(0.25, 0.0)}, Ink::contact, kThick);
    if (compliant_)
      draw_stop_spring(part, face, below);
    else
      draw_line(part, {face, below}, Ink::contact);
  }

  /// Their gaps are told in one text beside the free ends.
  void draw_pair_stops() {
    SingleStop all;
    double y = 0.0;
    for (const PairStop& pair : pair_stops(problem_)) {
      if (!is_drawn(pair)) {
        ++hidden_;
        continue;
      }
      draw_buffer(pair);
      all.add({.contacts = 1, .least_gap = pair.gap, .largest_gap = pair.gap});
      y = std::min(y, middle(beam_of(pair.other)) + 0.5 * kBetweenBeams);
    }
    if (all.contacts > 0)
      draw_text(drawing_.add("gap"), {kBeamLength + 0.5, y - 0.35 * kTextSize}, gap_text(all), Ink::contact,
                Anchor::start);
  }

  void draw_loads(const std::vector<SingleStop>& stops) {
    constexpr std::ptrdiff_t kMostTexts = 3;
    const std::vector<int> loaded = loaded_coordinates(problem_);
    for (const int dof : loaded) {
      const std::string words = std::ssize(loaded) > kMostTexts ? "" : load_text(problem_, dof);
      if (dof % 2 == 1) {
        Part& part = drawing_.add("load");
        draw_turning_arrow(part, place_of(dof), 0.5, 1.25, -1.4, 24);
        draw_text(part, place_of(dof) + Place(0.0, 0.65), words.empty() ? words : words + " m", Ink::load);
        continue;
      }
      const bool beside = std::ranges::any_of(
          stops, [dof](const SingleStop& stop) { return stop.dof == dof && !stop.forward; });
      const Place foot = place_of(dof) + Place(beside ? -1.0 : 0.0, kBeamHalf);
      draw_load(drawing_, foot + Place(0.0, 0.95), foot + Place(0.0, 0.03),
                foot + Place(beside ? 0.3 : 0.0, 1.1), words, beside ? Anchor::end : Anchor::middle);
    }
  }

  Drawing& drawing_;
  const Problem& problem_;
  const Beam& beam_;
  bool compliant_;
  std::ptrdiff_t hidden_ = 0;
};

}  // namespace

std::string draw_model(Drawing& drawing, const Problem& problem, const Beam& beam) {
  BeamPicture picture(drawing, problem, beam);
  picture.draw();
  return picture.remark();
}

}  // namespace signorini
