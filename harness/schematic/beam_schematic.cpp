// Beams in bending, clamped at their left ends, one below the other; deflections point down.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/mesh_lines.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

constexpr double kBeamLength = 9.0, kBeamHalf = 0.14, kBetweenBeams = 2.3;  // [cm]
constexpr std::size_t kMostBeamStops = 20;                                  // drawn one by one

/// Beams on paper.
class BeamPicture {
 public:
  BeamPicture(Drawing& drawing, const Problem& problem, const Beam& beam)
      : drawing_(drawing), problem_(problem), beam_(beam), compliant_(has_compliant_stops(problem)) {}
  void draw();
  [[nodiscard]] std::string remark() const;

 private:
  [[nodiscard]] int beam_of(int dof) const { return dof / (2 * beam_.elements); }
  [[nodiscard]] double x_of(int dof) const {
    const int node = dof % (2 * beam_.elements) / 2 + 1;
    return kBeamLength * node / beam_.elements;
  }
  [[nodiscard]] double gap_of(double gap) const { return drawn_gap(gap, largest_gap(problem_)); }
  static double middle(int beam) { return -kBetweenBeams * beam; }
  [[nodiscard]] bool is_drawn(const PairStop& pair) const;
  void draw_one(int beam);
  void draw_stops(const std::vector<SingleStop>& stops);
  void draw_rail(const std::vector<SingleStop>& stops);
  void draw_row(const std::vector<SingleStop>& stops);
  void draw_buffer(const PairStop& pair);
  void draw_pair_stops();
  [[nodiscard]] bool stopped_above(int dof) const;
  void draw_loads();
  void draw_moment(const Place& at, const std::string& words);

  Drawing& drawing_;
  const Problem& problem_;
  const Beam& beam_;
  bool compliant_;
  int hidden_ = 0;
};

void BeamPicture::draw_one(int beam) {
  const double y = middle(beam);
  draw_box(drawing_.add("beam"), {0.0, y - kBeamHalf}, {kBeamLength, y + kBeamHalf}, Fill::body);
  Part& mesh = drawing_.add("mesh");
  for (const double share : mesh_lines(beam_.elements))
    mesh.strokes.push_back(
        {.places = {{share * kBeamLength, y - kBeamHalf}, {share * kBeamLength, y + kBeamHalf}},
         .ink = Ink::note,
         .width = 0.018});
}

/// The face of a stop and the way it is approached.
Place toward(const SingleStop& stop) { return {0.0, stop.forward ? -1.0 : 1.0}; }

/// Many stops side by side, as one line through their faces.
void BeamPicture::draw_rail(const std::vector<SingleStop>& stops) {
  const Place way = toward(stops.front());
  int contacts = 0;
  double least = stops.front().least_gap, largest = stops.front().largest_gap;
  std::vector<Place> faces;
  for (const SingleStop& stop : stops) {
    faces.push_back(Place(x_of(stop.dof), middle(beam_of(stop.dof))) +
                    (kBeamHalf + gap_of(stop.least_gap)) * way);
    contacts += stop.contacts;
    least = std::min(least, stop.least_gap);
    largest = std::max(largest, stop.largest_gap);
  }
  Part& part = drawing_.add("rail");
  const Place low = faces.front(), high = faces.back();
  part.strokes.push_back({.places = faces, .ink = Ink::contact, .width = 0.055});
  const Place depth = (compliant_ ? 0.55 : 0.0) * way;
  if (compliant_) {
    constexpr int kSprings = 9;  // a few stand for all
    for (int i = 0; i < kSprings; ++i) {
      const Place& face = faces[(faces.size() - 1) * static_cast<std::size_t>(i) / (kSprings - 1)];
      draw_stop_spring(part, face, Place(face.x(), low.y()) + depth);
    }
  }
  const Place from = low + depth - Place(0.15, 0.0), to(high.x() + 0.15, from.y());
  if (stops.front().forward)
    hatch_line(part, to, from, Ink::contact);
  else
    hatch_line(part, from, to, Ink::contact);
  const Place below =
      0.5 * (from + to) + 0.3 * way - Place(0.0, stops.front().forward ? 0.75 * kTextSize : 0.0);
  drawing_.add("gap").labels.push_back(
      {.place = below,
       .words = fmt::format("{} stops, g = {}", contacts, range_text(least, largest, "m")),
       .ink = Ink::contact});
}

/// Stops one by one, each with its text if there is room for all.
void BeamPicture::draw_row(const std::vector<SingleStop>& stops) {
  double room = kBeamLength;
  for (std::size_t i = 1; i < stops.size(); ++i)
    room = std::min(room, x_of(stops[i].dof) - x_of(stops[i - 1].dof));
  const double half = std::min(0.32, 0.4 * room);
  double least = stops.front().least_gap, largest = stops.front().largest_gap, lowest = 0.0;
  double longest = 0.0;
  for (const SingleStop& stop : stops)
    longest = std::max(longest, extent(Label{.words = gap_text(stop)}).size().x());
  const bool named = room > longest;
  const Place way = toward(stops.front());
  for (const SingleStop& stop : stops) {
    const Place surface = Place(x_of(stop.dof), middle(beam_of(stop.dof))) + kBeamHalf * way;
    const Place face = surface + gap_of(stop.least_gap) * way;
    draw_stop(drawing_, face, way, {.compliant = compliant_, .half = half});
    const double behind = (compliant_ ? kStopDepth : 0.0) + 0.3;
    Label label{.place = face + behind * way - Place(0.0, stop.forward ? 0.75 * kTextSize : 0.0),
                .words = gap_text(stop)};
    if (named) {
      const Place aside(-half - 0.14, 0.0);
      draw_gap(drawing_, surface + aside, face + aside, label);
    }
    lowest = std::max(lowest, std::abs(label.place.y() - surface.y()));
    least = std::min(least, stop.least_gap);
    largest = std::max(largest, stop.largest_gap);
  }
  if (named) return;
  const Place ends(x_of(stops.front().dof), x_of(stops.back().dof));
  drawing_.add("gap").labels.push_back(
      {.place = Place(ends.mean(), middle(beam_of(stops.front().dof))) + (kBeamHalf + lowest) * way,
       .words = fmt::format("{} stops, g = {}", stops.size(), range_text(least, largest, "m")),
       .ink = Ink::contact});
}

void BeamPicture::draw_stops(const std::vector<SingleStop>& stops) {
  if (stops.empty()) return;
  if (stops.size() > kMostBeamStops)
    draw_rail(stops);
  else
    draw_row(stops);
}

/// Between neighbours, at the same place along them.
bool BeamPicture::is_drawn(const PairStop& pair) const {
  return beam_of(pair.other) == beam_of(pair.closing) + 1 && x_of(pair.other) == x_of(pair.closing) &&
         pair.other % 2 == 0 && pair.closing % 2 == 0;
}

/// A buffer on the lower beam that the upper one meets.
void BeamPicture::draw_buffer(const PairStop& pair) {
  const double x = x_of(pair.closing), below = middle(beam_of(pair.other)) + kBeamHalf;
  const Place surface(x, middle(beam_of(pair.closing)) - kBeamHalf);
  const Place face = surface - Place(0.0, gap_of(pair.gap));
  Part& part = drawing_.add("stop");
  part.strokes.push_back(
      {.places = {face - Place(0.25, 0.0), face + Place(0.25, 0.0)}, .ink = Ink::contact, .width = 0.055});
  if (compliant_)
    draw_stop_spring(part, face, {x, below});
  else
    draw_line(part, {face, {x, below}}, Ink::contact);
}

/// Their gaps are told in one text beside the free ends.
void BeamPicture::draw_pair_stops() {
  std::vector<double> gaps;
  double y = 0.0;
  for (const PairStop& pair : pair_stops(problem_)) {
    if (!is_drawn(pair)) {
      ++hidden_;
      continue;
    }
    draw_buffer(pair);
    gaps.push_back(pair.gap);
    y = std::min(y, middle(beam_of(pair.other)) + 0.5 * kBetweenBeams);
  }
  if (gaps.empty()) return;
  const auto [least, largest] = std::ranges::minmax(gaps);
  const std::string count = gaps.size() == 1 ? "" : fmt::format("{} stops, ", gaps.size());
  drawing_.add("gap").labels.push_back({.place = {kBeamLength + 0.5, y - 0.35 * kTextSize},
                                        .words = count + "g = " + range_text(least, largest, "m"),
                                        .anchor = Anchor::start,
                                        .ink = Ink::contact});
}

void BeamPicture::draw_moment(const Place& at, const std::string& words) {
  constexpr double kRadius = 0.5;
  Part& part = drawing_.add("load");
  Stroke arc{.ink = Ink::load, .width = 0.05};
  for (int i = 0; i <= 24; ++i) {
    const double angle = std::numbers::pi * (1.25 - 1.4 * i / 24.0);
    arc.places.push_back(at + kRadius * Place(std::cos(angle), std::sin(angle)));
  }
  const Place tip = arc.places.back(), before = arc.places[arc.places.size() - 4];
  part.strokes.push_back(std::move(arc));
  draw_arrow(part, before, tip + 0.4 * (tip - before), Ink::load);
  part.labels.push_back({.place = at + Place(0.0, kRadius + 0.15), .words = words, .ink = Ink::load});
}

bool BeamPicture::stopped_above(int dof) const {
  return std::ranges::any_of(single_stops(problem_),
                             [dof](const SingleStop& stop) { return stop.dof == dof && !stop.forward; });
}

void BeamPicture::draw_loads() {
  constexpr std::ptrdiff_t kMostTexts = 3;
  const std::vector<int> loaded = loaded_coordinates(problem_);
  for (const int dof : loaded) {
    const Place at(x_of(dof), middle(beam_of(dof)) + kBeamHalf);
    const std::string words = std::ssize(loaded) > kMostTexts ? "" : load_text(problem_, dof);
    if (dof % 2 == 1) {
      draw_moment(at - Place(0.0, kBeamHalf), words.empty() ? words : words + " m");
      continue;
    }
    const bool beside = stopped_above(dof);
    const Place foot = at - Place(beside ? 1.0 : 0.0, 0.0);
    draw_load(drawing_, foot + Place(0.0, 0.95), foot + Place(0.0, 0.03),
              {.place = foot + Place(beside ? 0.3 : 0.0, 1.1),
               .words = words,
               .anchor = beside ? Anchor::end : Anchor::middle});
  }
}

void BeamPicture::draw() {
  const double lowest = middle(beam_.count - 1);
  draw_wall(drawing_, {0.0, lowest - 0.7}, {0.0, 0.7});
  for (int beam = 0; beam < beam_.count; ++beam) draw_one(beam);
  const std::vector<SingleStop> stops = single_stops(problem_);
  for (int beam = 0; beam < beam_.count; ++beam) {
    for (const bool forward : {true, false}) {
      std::vector<SingleStop> own;
      for (const SingleStop& stop : stops)
        if (beam_of(stop.dof) == beam && stop.forward == forward && stop.dof % 2 == 0) own.push_back(stop);
      draw_stops(own);
    }
  }
  for (const SingleStop& stop : stops) hidden_ += stop.dof % 2 == 1 ? stop.contacts : 0;
  draw_pair_stops();
  draw_loads();
}

std::string BeamPicture::remark() const {
  std::string text =
      fmt::format("{}, {} each, {}", beam_.count == 1 ? "beam" : fmt::format("{} beams", beam_.count),
                  elements_text(beam_.elements), range_text(beam_.length, beam_.length, "m"));
  if (beam_.count == 1)
    text = fmt::format("beam, {}, {}", elements_text(beam_.elements),
                       range_text(beam_.length, beam_.length, "m"));
  if (const int hidden = hidden_ + other_stops(problem_); hidden > 0)
    text += fmt::format(", {} more contact{} not drawn", hidden, hidden == 1 ? "" : "s");
  return text;
}

}  // namespace

std::string draw_beams(Drawing& drawing, const Problem& problem, const Beam& beam) {
  BeamPicture picture(drawing, problem, beam);
  picture.draw();
  return picture.remark();
}

}  // namespace signorini
