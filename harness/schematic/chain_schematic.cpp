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

std::string all_of(const std::vector<double>& values, const std::string& unit) {
  const auto [least, largest] = std::ranges::minmax(values);
  return range_text(least, largest, unit);
}

ElementText element_text(double spring, double damper) {
  return {number_text(spring) + " N/m", number_text(damper) + " N s/m"};
}

/// A chain on paper.
class ChainPicture {
 public:
  ChainPicture(Drawing& drawing, const Problem& problem, const Chain& chain)
      : drawing_(drawing), problem_(problem), chain_(chain), compliant_(has_springs(problem)) {
    width_ = named() ? 1.7 : std::max(0.8, 0.24 * static_cast<double>(std::to_string(size()).size()) + 0.2);
    height_ = named() ? 1.75 : 0.9;
    element_ = named() ? 2.4 : 0.95;
    lane_ = 0.5 * height_ + 1.9;
    double x = 0.0;
    int before = -1;
    for (const int mass : masses_drawn(problem, size())) {
      x += (mass == before + 1 ? element_ : 1.7) + half_width(mass);
      before = mass;
      x_[mass] = x;
      x += half_width(mass);
    }
  }

  void draw() {
    const AxialPlaces places = [this](int mass) { return place(mass); };
    const bool pins = std::ranges::any_of(
        stops_, [&](const SingleStop& stop) { return !stands_at_end(stop, stops_, places); });
    const bool grounded = !chain_.ground_springs.empty() || !chain_.ground_dampers.empty();
    draw_row();
    if (named() && !pins && !grounded) draw_floor();
    draw_axial_stops(drawing_, problem_, places);
    draw_axial_loads(drawing_, problem_, places);
    if (grounded) draw_ground(-0.5 * height_ - (pins ? 2.0 : 0.5));
    draw_pairs();
    draw_links();
  }

  [[nodiscard]] std::string remark() const {
    std::string text;
    if (!named())
      text =
          fmt::format(", {} masses of {}, springs of {}, dampers of {}", size(), all_of(chain_.masses, "kg"),
                      all_of(chain_.springs, "N/m"), all_of(chain_.dampers, "N s/m"));
    if (!chain_.ground_springs.empty()) text += ", ground springs of " + all_of(chain_.ground_springs, "N/m");
    if (!chain_.ground_dampers.empty())
      text += ", ground dampers of " + all_of(chain_.ground_dampers, "N s/m");
    text += hidden_text(other_stops(problem_), "contact", " of several coordinates not drawn");
    int hidden = 0;
    for (const SingleStop& stop : stops_) hidden += x_.contains(stop.dof) ? 0 : stop.contacts;
    for (const PairStop& pair : pair_stops(problem_)) hidden += both_shown(pair.closing, pair.other) ? 0 : 1;
    if (hidden > 0) text += fmt::format(", {} more stops", hidden);
    return text.substr(std::min<std::size_t>(text.size(), 2));
  }

 private:
  [[nodiscard]] int size() const { return static_cast<int>(chain_.masses.size()); }
  [[nodiscard]] bool named() const { return size() <= kMostNamed; }
  static std::size_t at(int mass) { return static_cast<std::size_t>(mass); }
  [[nodiscard]] bool is_mass(int mass) const { return chain_.masses[at(mass)] > 0.0; }
  [[nodiscard]] double half_width(int mass) const { return is_mass(mass) ? 0.5 * width_ : 0.06; }
  [[nodiscard]] bool both_shown(int first, int second) const {
    return x_.contains(first) && x_.contains(second);
  }

  [[nodiscard]] std::optional<AxialPoint> place(int mass) const {
    const auto found = x_.find(mass);
    if (found == x_.end()) return std::nullopt;
    AxialPoint point{
        .x = found->second, .top = 0.5 * height_, .bottom = -0.5 * height_, .room = element_ + width_};
    if (mass == size() - 1) point.face = found->second + half_width(mass);
    return point;
  }

  void draw_one_mass(int mass) {
    const double x = x_.at(mass), half = half_width(mass);
    const bool node = !is_mass(mass);
    Part& part = drawing_.add(node ? "node" : "mass");
    draw_box(part, {x - half, -0.5 * height_}, {x + half, 0.5 * height_}, node ? Fill::ink : Fill::body);
    if (node)
      draw_text(part, {x - 0.55, 0.5 * height_ + 0.1}, "0 kg", Ink::structure, Anchor::end);
    else
      draw_text(part, {x, -0.35 * kTextSize},
                named() ? number_text(chain_.masses[at(mass)]) + " kg" : std::to_string(mass));
  }

  void draw_row() {
    double right = 0.0;
    int before = -1;
    if (chain_.springs[0] > 0.0 || chain_.dampers[0] > 0.0)
      draw_wall(drawing_, {0.0, -0.62 * height_}, {0.0, 0.62 * height_});
    for (const auto& [mass, x] : x_) {
      const Place from(right, 0.0), to(x - half_width(mass), 0.0);
      const double spring = chain_.springs[at(mass)], damper = chain_.dampers[at(mass)];
      if (mass == before + 1) {
        draw_element(drawing_, from, to, spring > 0.0, damper > 0.0,
                     named() ? element_text(spring, damper) : ElementText{});
      } else {
        Part& part = drawing_.add("omission");
        part.strokes.push_back({.places = {from, to}, .ink = Ink::note, .dashed = true});
        draw_text(part, 0.5 * (from + to) + Place(0.0, 0.15), fmt::format("{} more", mass - before - 1),
                  Ink::note);
      }
      draw_one_mass(mass);
      right = x + half_width(mass);
      before = mass;
    }
  }

  void draw_floor() {
    constexpr double kWheel = 0.09;
    const double floor = -0.5 * height_ - 2.0 * kWheel - 0.03;
    Part& wheels = drawing_.add("wheels");
    for (const auto& [mass, x] : x_) {
      if (!is_mass(mass)) continue;
      for (const double side : {-0.3, 0.3})
        draw_circle(wheels, {x + side * width_, floor + kWheel + 0.015}, kWheel, Fill::paper);
    }
    draw_wall(drawing_, {x_.rbegin()->second + width_, floor}, {0.0, floor});
  }

  /// Springs and dampers to the ground, at this height.
  void draw_ground(double y) {
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
  void draw_pair(const PairStop& pair, double y) {
    const double top = 0.5 * height_, from = x_.at(pair.closing), to = x_.at(pair.other);
    const double gap = drawn_gap(pair.gap, problem_), depth = compliant_ ? kStopDepth : 0.0;
    Part& arms = drawing_.add("arm");
    draw_line(arms, {{to, top}, {to, y}}, Ink::structure, 0.06);
    const double shoulder = from < to ? 0.0 : 0.3;  // of a hook that passes over the other arm
    const double end = to - depth - 0.12;
    draw_line(arms, {{from, top}, {from, y + shoulder}, {end - gap, y + shoulder}, {end - gap, y}},
              Ink::structure, 0.06);
    draw_stop(drawing_, {end, y}, {1.0, 0.0}, {.compliant = compliant_, .half = 0.26});
    draw_line(drawing_.add("arm"), {{end + depth, y}, {to, y}});
    const double level = y + (from < to ? 0.42 : -0.42);  // where no arm passes
    draw_gap(drawing_, {end - gap, level}, {end, level}, {end + 0.5, level - 0.35 * kTextSize},
             "g = " + range_text(pair.gap, pair.gap, "m"), Anchor::start);
  }

  void draw_pairs() {
    for (const PairStop& pair : pair_stops(problem_)) {
      if (!both_shown(pair.closing, pair.other)) continue;
      draw_pair(pair, lane_);
      lane_ += 1.25;
    }
  }

  void draw_links() {
    for (const Link& link : chain_.links) {
      if (!both_shown(link.first, link.second) || (!(link.spring > 0.0) && !(link.damper > 0.0))) continue;
      const double from = std::min(x_.at(link.first), x_.at(link.second)) + 0.15 * width_;
      const double to = std::max(x_.at(link.first), x_.at(link.second)) - 0.15 * width_;
      const double margin = std::max(0.0, 0.5 * (to - from - 2.4));
      Part& arms = drawing_.add("arm");
      draw_line(arms, {{from, 0.5 * height_}, {from, lane_}, {from + margin, lane_}});
      draw_line(arms, {{to, 0.5 * height_}, {to, lane_}, {to - margin, lane_}});
      draw_element(drawing_, {from + margin, lane_}, {to - margin, lane_}, link.spring > 0.0,
                   link.damper > 0.0, element_text(link.spring, link.damper));
      lane_ += 1.3;
    }
  }

  Drawing& drawing_;
  const Problem& problem_;
  const Chain& chain_;
  bool compliant_;
  std::vector<SingleStop> stops_ = single_stops(problem_);
  std::map<int, double> x_ = {};  ///< middle of each mass that is drawn [cm]
  double width_, height_, element_;
  double lane_;  ///< next height above the row that is free [cm]
};

}  // namespace

std::string draw_model(Drawing& drawing, const Problem& problem, const Chain& chain) {
  ChainPicture picture(drawing, problem, chain);
  picture.draw();
  return picture.remark();
}

}  // namespace signorini
