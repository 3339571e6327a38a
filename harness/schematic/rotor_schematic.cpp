// Rotors and shafts: from the side, and along the axis of the stator.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/mesh_lines.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"

namespace signorini {

namespace {

constexpr double kDiscRadius = 1.05, kDrawnGap = 0.35, kShaftHalf = 0.08;  // [cm]

/// The directions in which a disc is limited, and how far.
struct Stator {
  std::vector<double> angles = {};  ///< rising [rad]
  std::vector<double> gaps = {};    ///< [m]
};

/// Contacts in planes of two coordinates, by the first of them; `second` is the other one of each plane.
std::map<int, Stator> stators(const Problem& problem, int second_offset) {
  std::map<int, std::vector<std::pair<double, double>>> found;
  for (const Contact& contact : problem.contacts) {
    int plane = contact.normal.front().first;
    for (const auto& [dof, coefficient] : contact.normal) plane = std::min(plane, dof);
    if (second_offset == 1) plane = 0;
    if (second_offset == 2) plane -= plane % 4 >= 2 ? 2 : 0;
    double x = 0.0, y = 0.0;
    for (const auto& [dof, coefficient] : contact.normal) (dof == plane ? x : y) += coefficient;
    found[plane].emplace_back(std::atan2(y, x), contact.gap);
  }
  std::map<int, Stator> result;
  for (auto& [plane, facets] : found) {
    std::ranges::sort(facets);
    for (const auto& [angle, gap] : facets) {
      result[plane].angles.push_back(angle);
      result[plane].gaps.push_back(gap);
    }
  }
  return result;
}

/// Half of the angle that a facet takes, so that those of a full ring join.
double half_angle(const Stator& stator) {
  constexpr double kMost = 0.35;
  double least = 2.0 * std::numbers::pi;
  for (std::size_t i = 1; i < stator.angles.size(); ++i)
    if (stator.angles[i] > stator.angles[i - 1])
      least = std::min(least, stator.angles[i] - stator.angles[i - 1]);
  return std::min(kMost, 0.5 * least);
}

void draw_end_view(Drawing& drawing, const Place& centre, const Stator& stator, const std::string& load,
                   const std::pair<std::string, std::string>& axes) {
  constexpr std::size_t kMostFacets = 72;  // hatched one by one
  const double radius = kDiscRadius + kDrawnGap, half = radius * std::tan(half_angle(stator));
  Part& ring = drawing.add("stop");
  const std::size_t every = (stator.angles.size() + kMostFacets - 1) / kMostFacets;
  for (std::size_t i = 0; i < stator.angles.size(); i += every) {
    const Place out(std::cos(stator.angles[i]), std::sin(stator.angles[i])), along(-out.y(), out.x());
    const Place middle = centre + radius * out, reach = static_cast<double>(every) * half * along;
    hatch_line(ring, middle + reach, middle - reach, Ink::contact);
  }
  draw_circle(drawing.add("mass"), centre, kDiscRadius, Fill::body);
  Part& frame = drawing.add("axes");
  draw_circle(frame, centre, 0.05, Fill::ink);
  draw_arrow(frame, centre, centre + Place(0.6, 0.0), Ink::structure);
  draw_arrow(frame, centre, centre + Place(0.0, 0.6), Ink::structure);
  frame.labels.push_back({.place = centre + Place(0.35, -1.15 * kTextSize), .words = axes.first});
  frame.labels.push_back({.place = centre + Place(-0.12, 0.45), .words = axes.second, .anchor = Anchor::end});
  if (!load.empty()) {
    Part& arrow = drawing.add("load");
    Stroke arc{.ink = Ink::load, .width = 0.05};
    for (int i = 0; i <= 16; ++i) {
      const double angle = std::numbers::pi * (1.05 + 0.55 * i / 16.0);
      arc.places.push_back(centre + 0.72 * Place(std::cos(angle), std::sin(angle)));
    }
    const Place tip = arc.places.back(), before = arc.places[arc.places.size() - 4];
    arrow.strokes.push_back(std::move(arc));
    draw_arrow(arrow, before, tip + 0.4 * (tip - before), Ink::load);
    arrow.labels.push_back({.place = centre - Place(0.0, radius + 0.85), .words = load, .ink = Ink::load});
  }
  if (stator.gaps.empty()) return;
  const auto [least, largest] = std::ranges::minmax(stator.gaps);
  const Label gap{.place = centre + Place(radius + 0.65, -0.35 * kTextSize),
                  .words = "g = " + range_text(least, largest, "m"),
                  .anchor = Anchor::start};
  draw_gap(drawing, centre + Place(kDiscRadius, 0.0), centre + Place(radius, 0.0), gap);
}

/// What turns: "0.15 cos ωt N, 0.15 sin ωt N".
std::string unbalance_text(const Problem& problem, int first, int second) {
  const std::vector<int> loaded = loaded_coordinates(problem);
  std::string text;
  for (const int dof : {first, second})
    if (std::ranges::binary_search(loaded, dof))
      text += (text.empty() ? "" : ",  ") + load_text(problem, dof);
  return text;
}

/// Spring and damper down to the ground, from a bearing that both hang on, also beyond the end of a shaft.
void draw_support(Drawing& drawing, const Place& from, double stiffness, double damping) {
  const Place to = from - Place(0.0, 1.5), half(0.45, 0.0);
  drawing.add("bearing").strokes.push_back({.places = {from - half, from + half}});
  draw_element(drawing, to, from, stiffness > 0.0, damping > 0.0);
  draw_wall(drawing, to + Place(0.65, 0.0), to - Place(0.65, 0.0));
}

void draw_disc(Drawing& drawing, double x, const std::string& words) {
  Part& disc = drawing.add("mass");
  draw_box(disc, {x - 0.16, -kDiscRadius}, {x + 0.16, kDiscRadius}, Fill::body);
  disc.labels.push_back({.place = {x, kDiscRadius + kDrawnGap + 0.4}, .words = words});
}

/// The stator, cut.
void draw_cut_stator(Drawing& drawing, double x) {
  constexpr double kHalf = 0.35;
  Part& part = drawing.add("stator");
  const double y = kDiscRadius + kDrawnGap;
  hatch_line(part, {x - kHalf, y}, {x + kHalf, y}, Ink::contact);
  hatch_line(part, {x + kHalf, -y}, {x - kHalf, -y}, Ink::contact);
}

std::string facets_text(std::size_t facets) {
  return facets == 0 ? "" : fmt::format(", stator of {} facet{}", facets, facets == 1 ? "" : "s");
}

std::string axis_text(int dof) { return fmt::format("u[{}]", dof); }

}  // namespace

std::string draw_rotor(Drawing& drawing, const Problem& problem, const Rotor& rotor) {
  constexpr double kLength = 2.6, kDisc = 0.8, kSupport = 2.2;
  draw_box(drawing.add("shaft"), {0.0, -kShaftHalf}, {kLength, kShaftHalf}, Fill::body);
  draw_support(drawing, {kSupport, -kShaftHalf}, rotor.stiffness, rotor.damping);
  draw_disc(drawing, kDisc, number_text(rotor.mass) + " kg");
  const auto rings = stators(problem, 1);
  const Stator stator = rings.empty() ? Stator() : rings.begin()->second;
  if (!stator.angles.empty()) draw_cut_stator(drawing, kDisc);
  draw_end_view(drawing, {kLength + 2.9, 0.0}, stator, unbalance_text(problem, 0, 1),
                {axis_text(0), axis_text(1)});
  return fmt::format("support {} N/m and {} N s/m in all directions{}", number_text(rotor.stiffness),
                     number_text(rotor.damping), facets_text(stator.angles.size()));
}

std::string draw_shaft(Drawing& drawing, const Problem& problem, const Shaft& shaft) {
  constexpr double kLength = 7.5;
  const auto x_of = [&](int node) { return kLength * node / shaft.beam.elements; };
  draw_box(drawing.add("shaft"), {0.0, -kShaftHalf}, {kLength, kShaftHalf}, Fill::body);
  Part& mesh = drawing.add("mesh");
  for (const double share : mesh_lines(shaft.beam.elements))
    mesh.strokes.push_back(
        {.places = {{share * kLength, -kShaftHalf}, {share * kLength, kShaftHalf}}, .width = 0.02});
  for (const double x : {0.0, kLength})
    draw_support(drawing, {x, -kShaftHalf}, shaft.bearing_stiffness, shaft.bearing_damping);
  if (shaft.disc_mass > 0.0) draw_disc(drawing, x_of(shaft.disc_node), number_text(shaft.disc_mass) + " kg");
  const auto rings = stators(problem, 2);
  for (const auto& [plane, ring] : rings) draw_cut_stator(drawing, x_of(plane / 4));
  const int plane = rings.empty() ? 4 * shaft.disc_node : rings.begin()->first;
  draw_end_view(drawing, {kLength + 3.2, 0.0}, rings.empty() ? Stator() : rings.begin()->second,
                unbalance_text(problem, plane, plane + 2), {axis_text(plane), axis_text(plane + 2)});
  std::size_t facets = 0;
  for (const auto& [first, ring] : rings) facets += ring.angles.size();
  return fmt::format(
      "flexible shaft, {}, {}; bearings {} N/m and {} N s/m{}", elements_text(shaft.beam.elements),
      range_text(shaft.beam.length, shaft.beam.length, "m"), number_text(shaft.bearing_stiffness),
      number_text(shaft.bearing_damping), facets_text(facets));
}

}  // namespace signorini
