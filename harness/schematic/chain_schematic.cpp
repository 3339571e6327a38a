// Oscillators and chains of masses.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "harness/schematic/axial.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

constexpr int kMostMasses = 10;  // drawn one by one
constexpr int kMostNamed = 3;    // of masses that carry their own figures

/// A chain on paper.
class ChainPicture {
 public:
  ChainPicture(Drawing& drawing, const Problem& problem, const Chain& chain);
  void draw();
  [[nodiscard]] std::string remark() const;

 private:
  [[nodiscard]] int size() const { return static_cast<int>(chain_.masses.size()); }
  [[nodiscard]] bool named() const { return size() <= kMostNamed; }
  [[nodiscard]] double half_width(int mass) const {
    return chain_.masses[at(mass)] > 0.0 ? 0.5 * width_ : 0.06;
  }
  [[nodiscard]] std::optional<AxialPoint> place(int mass) const;
  [[nodiscard]] bool has_pins() const;
  static std::size_t at(int mass) { return static_cast<std::size_t>(mass); }
  void draw_row();
  void draw_one_mass(int mass);
  void draw_floor();
  void draw_ground();
  void draw_pairs();
  void draw_links();
  void draw_pair(const PairStop& pair, double y);
  [[nodiscard]] bool both_shown(int first, int second) const {
    return x_.contains(first) && x_.contains(second);
  }

  Drawing& drawing_;
  const Problem& problem_;
  const Chain& chain_;
  std::map<int, double> x_ = {};  ///< middle of each mass that is drawn [cm]
  double width_, height_, element_;
  double lane_;  ///< next height above the row that is free [cm]
};

std::set<int> masses_drawn(const Problem& problem, int size) {
  std::set<int> drawn;
  if (size <= kMostMasses) {
    for (int i = 0; i < size; ++i) drawn.insert(i);
    return drawn;
  }
  drawn = {0, 1, size - 2, size - 1};
  const auto take = [&](int mass) {
    if (std::ssize(drawn) < kMostMasses - 1) drawn.insert(mass);
  };
  for (const int dof : loaded_coordinates(problem)) take(dof);
  for (const SingleStop& stop : single_stops(problem)) take(stop.dof);
  return drawn;
}

ChainPicture::ChainPicture(Drawing& drawing, const Problem& problem, const Chain& chain)
    : drawing_(drawing), problem_(problem), chain_(chain) {
  width_ = named() ? 1.7 : std::max(0.8, 0.24 * static_cast<double>(std::to_string(size()).size()) + 0.2);
  height_ = named() ? 1.75 : 0.9;
  element_ = named() ? 2.4 : 0.95;
  lane_ = 0.5 * height_ + 1.9;
  constexpr double kOmission = 1.7;
  double x = 0.0;
  int before = -1;
  for (const int mass : masses_drawn(problem, size())) {
    x += (mass == before + 1 ? element_ : kOmission) + half_width(mass);
    before = mass;
    x_[mass] = x;
    x += half_width(mass);
  }
}

std::optional<AxialPoint> ChainPicture::place(int mass) const {
  const auto found = x_.find(mass);
  if (found == x_.end()) return std::nullopt;
  AxialPoint point{
      .x = found->second, .top = 0.5 * height_, .bottom = -0.5 * height_, .room = element_ + width_};
  if (mass == size() - 1) point.face = found->second + half_width(mass);
  return point;
}

bool ChainPicture::has_pins() const {
  const std::vector<SingleStop> stops = single_stops(problem_);
  const AxialPlaces places = [this](int mass) { return place(mass); };
  return std::ranges::any_of(stops,
                             [&](const SingleStop& stop) { return !stands_at_end(stop, stops, places); });
}

void ChainPicture::draw_one_mass(int mass) {
  const double x = x_.at(mass), half = half_width(mass);
  const bool node = !(chain_.masses[at(mass)] > 0.0);
  Part& part = drawing_.add(node ? "node" : "mass");
  draw_box(part, {x - half, -0.5 * height_}, {x + half, 0.5 * height_}, node ? Fill::ink : Fill::body);
  const std::string words = node      ? "0 kg"
                            : named() ? number_text(chain_.masses[at(mass)]) + " kg"
                                      : std::to_string(mass);
  const Place below(x, -0.35 * kTextSize), aside(x - 0.55, 0.5 * height_ + 0.1);
  part.labels.push_back(
      {.place = node ? aside : below, .words = words, .anchor = node ? Anchor::end : Anchor::middle});
}

void ChainPicture::draw_row() {
  double right = 0.0;
  int before = -1;
  if (chain_.springs[0] > 0.0 || chain_.dampers[0] > 0.0)
    draw_wall(drawing_, {0.0, -0.62 * height_}, {0.0, 0.62 * height_});
  for (const auto& [mass, x] : x_) {
    const Place from(right, 0.0), to(x - half_width(mass), 0.0);
    const double spring = chain_.springs[at(mass)], damper = chain_.dampers[at(mass)];
    if (mass == before + 1) {
      draw_element(drawing_, from, to, spring > 0.0, damper > 0.0,
                   named() ? ElementText{number_text(spring) + " N/m", number_text(damper) + " N s/m"}
                           : ElementText{});
    } else {
      Part& part = drawing_.add("omission");
      part.strokes.push_back({.places = {from, to}, .ink = Ink::note, .dashed = true});
      part.labels.push_back({.place = 0.5 * (from + to) + Place(0.0, 0.15),
                             .words = fmt::format("{} more", mass - before - 1),
                             .ink = Ink::note});
    }
    draw_one_mass(mass);
    right = x + half_width(mass);
    before = mass;
  }
}

void ChainPicture::draw_floor() {
  constexpr double kWheel = 0.09;
  const double floor = -0.5 * height_ - 2.0 * kWheel - 0.03;
  Part& wheels = drawing_.add("wheels");
  for (const auto& [mass, x] : x_) {
    if (!(chain_.masses[at(mass)] > 0.0)) continue;
    for (const double side : {-0.3, 0.3})
      draw_circle(wheels, {x + side * width_, floor + kWheel + 0.015}, kWheel, Fill::paper);
  }
  draw_wall(drawing_, {x_.rbegin()->second + width_, floor}, {0.0, floor});
}

void ChainPicture::draw_ground() {
  const double y = -0.5 * height_ - (has_pins() ? 2.0 : 0.5);
  for (const auto& [mass, x] : x_) {
    const double spring = chain_.ground_springs.empty() ? 0.0 : chain_.ground_springs[at(mass)];
    const double damper = chain_.ground_dampers.empty() ? 0.0 : chain_.ground_dampers[at(mass)];
    if (!(spring > 0.0) && !(damper > 0.0)) continue;
    const double end = x - 0.2 * width_, start = end - std::min(1.2, 0.6 * element_ + 0.5 * width_);
    draw_line(drawing_.add("arm"), {{end, -0.5 * height_}, {end, y - 0.3}});
    draw_element(drawing_, {start, y}, {end, y}, spring > 0.0, damper > 0.0);
    draw_wall(drawing_, {start, y - 0.4}, {start, y + 0.4});
  }
}

/// u[closing] - u[other] <= gap: an arm of the one ends before an arm of the other, or hooks behind it.
void ChainPicture::draw_pair(const PairStop& pair, double y) {
  const double top = 0.5 * height_, from = x_.at(pair.closing), to = x_.at(pair.other);
  const double gap = drawn_gap(pair.gap, largest_gap(problem_));
  Part& arms = drawing_.add("arm");
  draw_line(arms, {{to, top}, {to, y}});
  const double shoulder = from < to ? 0.0 : 0.3;  // of a hook that passes over the other arm
  const double end = to - (has_compliant_stops(problem_) ? kStopDepth : 0.0) - 0.12;
  draw_line(arms, {{from, top}, {from, y + shoulder}, {end - gap, y + shoulder}, {end - gap, y}});
  for (Stroke& stroke : arms.strokes) stroke.width = 0.06;
  draw_stop(drawing_, {end, y}, {1.0, 0.0}, {.compliant = has_compliant_stops(problem_), .half = 0.26});
  draw_line(drawing_.add("arm"), {{end + (has_compliant_stops(problem_) ? kStopDepth : 0.0), y}, {to, y}});
  const double level = y + (from < to ? 0.42 : -0.42);  // where no arm passes
  draw_gap(drawing_, {end - gap, level}, {end, level},
           {.place = {end + 0.5, level - 0.35 * kTextSize},
            .words = "g = " + range_text(pair.gap, pair.gap, "m"),
            .anchor = Anchor::start});
}

void ChainPicture::draw_pairs() {
  for (const PairStop& pair : pair_stops(problem_)) {
    if (!both_shown(pair.closing, pair.other)) continue;
    draw_pair(pair, lane_);
    lane_ += 1.25;
  }
}

void ChainPicture::draw_links() {
  for (const Link& link : chain_.links) {
    if (!both_shown(link.first, link.second) || (!(link.spring > 0.0) && !(link.damper > 0.0))) continue;
    const double from = std::min(x_.at(link.first), x_.at(link.second)) + 0.15 * width_;
    const double to = std::max(x_.at(link.first), x_.at(link.second)) - 0.15 * width_;
    const double margin = std::max(0.0, 0.5 * (to - from - 2.4));
    Part& arms = drawing_.add("arm");
    draw_line(arms, {{from, 0.5 * height_}, {from, lane_}, {from + margin, lane_}});
    draw_line(arms, {{to, 0.5 * height_}, {to, lane_}, {to - margin, lane_}});
    draw_element(drawing_, {from + margin, lane_}, {to - margin, lane_}, link.spring > 0.0, link.damper > 0.0,
                 {number_text(link.spring) + " N/m", number_text(link.damper) + " N s/m"});
    lane_ += 1.3;
  }
}

void ChainPicture::draw() {
  const AxialPlaces places = [this](int mass) { return place(mass); };
  const bool grounded = !chain_.ground_springs.empty() || !chain_.ground_dampers.empty();
  draw_row();
  if (named() && !has_pins() && !grounded) draw_floor();
  draw_axial_stops(drawing_, problem_, places);
  draw_axial_loads(drawing_, problem_, places);
  if (grounded) draw_ground();
  draw_pairs();
  draw_links();
}

std::string all_of(const std::vector<double>& values, const std::string& unit) {
  const auto [least, largest] = std::ranges::minmax(values);
  return range_text(least, largest, unit);
}

std::string ChainPicture::remark() const {
  std::string text;
  const auto add = [&text](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  if (!named()) {
    add(fmt::format("{} masses of {}", size(), all_of(chain_.masses, "kg")));
    add("springs of " + all_of(chain_.springs, "N/m"));
    add("dampers of " + all_of(chain_.dampers, "N s/m"));
  }
  if (!chain_.ground_springs.empty()) add("ground springs of " + all_of(chain_.ground_springs, "N/m"));
  if (!chain_.ground_dampers.empty()) add("ground dampers of " + all_of(chain_.ground_dampers, "N s/m"));
  if (const int others = other_stops(problem_); others > 0)
    add(fmt::format("{} contact{} of several coordinates not drawn", others, others == 1 ? "" : "s"));
  int hidden = 0;
  for (const SingleStop& stop : single_stops(problem_)) hidden += x_.contains(stop.dof) ? 0 : stop.contacts;
  for (const PairStop& pair : pair_stops(problem_)) hidden += both_shown(pair.closing, pair.other) ? 0 : 1;
  if (hidden > 0) add(fmt::format("{} more stops", hidden));
  return text;
}

}  // namespace

std::string draw_chain(Drawing& drawing, const Problem& problem, const Chain& chain) {
  ChainPicture picture(drawing, problem, chain);
  picture.draw();
  return picture.remark();
}

}  // namespace signorini
