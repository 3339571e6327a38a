// Rotors and shafts: from the side, and along the axis of the stator.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/schematic/boundary.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/symbols.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

constexpr double kDiscRadius = 1.05, kDrawnGap = 0.35, kShaftHalf = 0.08;  // [cm]

/// The directions in which a disc is limited, rising [rad], and how far [m].
using Stator = std::vector<std::pair<double, double>>;

/// Contacts in planes of two coordinates, by the first of them; the second is `next` coordinates on.
std::map<int, Stator> stators(const Problem& problem, int next) {
  std::map<int, Stator> found;
  for (const Contact& contact : problem.contacts) {
    int plane = std::ranges::min(contact.normal).first;
    if (next == 1) plane = 0;
    if (next == 2) plane -= plane % 4 >= 2 ? 2 : 0;
    double x = 0.0, y = 0.0;
    for (const auto& [dof, coefficient] : contact.normal) (dof == plane ? x : y) += coefficient;
    found[plane].emplace_back(std::atan2(y, x), contact.gap);
  }
  for (auto& [plane, facets] : found) std::ranges::sort(facets);
  return found;
}

/// Half of the angle that a facet takes, so that those of a full ring join.
double half_angle(const Stator& stator) {
  double least = 0.7;
  for (std::size_t i = 1; i < stator.size(); ++i)
    if (stator[i].first > stator[i - 1].first) least = std::min(least, stator[i].first - stator[i - 1].first);
  return 0.5 * least;
}

/// What turns: "0.15 cos ωt N, 0.15 sin ωt N".
std::string unbalance_text(const Problem& problem, int first, int second) {
  const std::vector<int> loaded = loaded_coordinates(problem);
  std::vector<std::string> loads;
  for (const int dof : {first, second})
    if (std::ranges::binary_search(loaded, dof)) loads.push_back(load_text(problem, dof));
  return joined(loads, ",  ");
}

/// Disc and stator along the axis, in the plane of this coordinate and the one `next` coordinates on.
void draw_end_view(Drawing& drawing, const Problem& problem, const Place& centre, const Stator& stator,
                   int plane, int next) {
  constexpr std::size_t kMostFacets = 72;  // hatched one by one
  const double radius = kDiscRadius + kDrawnGap, half = radius * std::tan(half_angle(stator));
  Part& ring = drawing.add("stop");
  const std::size_t every = (stator.size() + kMostFacets - 1) / kMostFacets;
  for (std::size_t i = 0; i < stator.size(); i += every) {
    const Place out(std::cos(stator[i].first), std::sin(stator[i].first)), along(-out.y(), out.x());
    const Place middle = centre + radius * out, reach = static_cast<double>(every) * half * along;
    hatch_line(ring, middle + reach, middle - reach, Ink::contact);
  }
  draw_circle(drawing.add("mass"), centre, kDiscRadius, Fill::body);
  Part& frame = drawing.add("axes");
  draw_circle(frame, centre, 0.05, Fill::ink);
  draw_arrow(frame, centre, centre + Place(0.6, 0.0), Ink::structure);
  draw_arrow(frame, centre, centre + Place(0.0, 0.6), Ink::structure);
  draw_text(frame, centre + Place(0.35, -1.15 * kTextSize), fmt::format("u[{}]", plane));
  draw_text(frame, centre + Place(-0.12, 0.45), fmt::format("u[{}]", plane + next), Ink::structure,
            Anchor::end);
  if (const std::string load = unbalance_text(problem, plane, plane + next); !load.empty()) {
    Part& arrow = drawing.add("load");
    draw_turning_arrow(arrow, centre, 0.72, 1.05, 0.55, 16);
    draw_text(arrow, centre - Place(0.0, radius + 0.85), load, Ink::load);
  }
  if (stator.empty()) return;
  const auto [least, largest] = std::ranges::minmax(stator, {}, &Stator::value_type::second);
  draw_gap(drawing, centre + Place(kDiscRadius, 0.0), centre + Place(radius, 0.0),
           centre + Place(radius + 0.65, -0.35 * kTextSize),
           "g = " + range_text(least.second, largest.second, "m"), Anchor::start);
}

/// Spring and damper down to the ground, from a bearing that both hang on, also beyond the end of a shaft.
void draw_support(Drawing& drawing, const Place& from, double stiffness, double damping) {
  const Place to = from - Place(0.0, 1.5), half(0.45, 0.0);
  draw_line(drawing.add("bearing"), {from - half, from + half});
  draw_element(drawing, to, from, stiffness > 0.0, damping > 0.0);
  draw_wall(drawing, to + Place(0.65, 0.0), to - Place(0.65, 0.0));
}

void draw_disc(Drawing& drawing, double x, double mass) {
  Part& disc = drawing.add("mass");
  draw_box(disc, {x - 0.16, -kDiscRadius}, {x + 0.16, kDiscRadius}, Fill::body);
  draw_text(disc, {x, kDiscRadius + kDrawnGap + 0.4}, number_text(mass) + " kg");
}

/// The stator, cut.
void draw_cut_stator(Drawing& drawing, double x) {
  constexpr double kHalf = 0.35;
  Part& part = drawing.add("stator");
  const double y = kDiscRadius + kDrawnGap;
  hatch_line(part, {x - kHalf, y}, {x + kHalf, y}, Ink::contact);
  hatch_line(part, {x + kHalf, -y}, {x - kHalf, -y}, Ink::contact);
}

/// "5 N/m and 2 N s/m".
std::string constants_text(double stiffness, double damping) {
  return fmt::format("{} N/m and {} N s/m", number_text(stiffness), number_text(damping));
}

std::string facets_text(std::size_t facets) {
  return facets == 0 ? "" : fmt::format(", stator of {} facet{}", facets, facets == 1 ? "" : "s");
}

}  // namespace

std::string draw_model(Drawing& drawing, const Problem& problem, const Rotor& rotor) {
  constexpr double kLength = 2.6, kDisc = 0.8, kSupport = 2.2;
  draw_box(drawing.add("shaft"), {0.0, -kShaftHalf}, {kLength, kShaftHalf}, Fill::body);
  draw_support(drawing, {kSupport, -kShaftHalf}, rotor.stiffness, rotor.damping);
  draw_disc(drawing, kDisc, rotor.mass);
  const auto rings = stators(problem, 1);
  const Stator stator = rings.empty() ? Stator() : rings.begin()->second;
  if (!stator.empty()) draw_cut_stator(drawing, kDisc);
  draw_end_view(drawing, problem, {kLength + 2.9, 0.0}, stator, 0, 1);
  return fmt::format("support {} in all directions{}", constants_text(rotor.stiffness, rotor.damping),
                     facets_text(stator.size()));
}

std::string draw_model(Drawing& drawing, const Problem& problem, const Shaft& shaft) {
  constexpr double kLength = 7.5;
  const auto x_of = [&](int node) { return kLength * node / shaft.beam.elements; };
  draw_meshed_box(drawing, "shaft", {0.0, -kShaftHalf}, {kLength, kShaftHalf}, shaft.beam.elements);
  for (const double x : {0.0, kLength})
    draw_support(drawing, {x, -kShaftHalf}, shaft.bearing_stiffness, shaft.bearing_damping);
  if (shaft.disc_mass > 0.0) draw_disc(drawing, x_of(shaft.disc_node), shaft.disc_mass);
  const auto rings = stators(problem, 2);
  std::size_t facets = 0;
  for (const auto& [plane, ring] : rings) {
    draw_cut_stator(drawing, x_of(plane / 4));
    facets += ring.size();
  }
  const int plane = rings.empty() ? 4 * shaft.disc_node : rings.begin()->first;
  draw_end_view(drawing, problem, {kLength + 3.2, 0.0}, rings.empty() ? Stator() : rings.begin()->second,
                plane, 2);
  return fmt::format("flexible shaft, {}, {}; bearings {}{}", elements_text(shaft.beam.elements),
                     range_text(shaft.beam.length, shaft.beam.length, "m"),
                     constants_text(shaft.bearing_stiffness, shaft.bearing_damping), facets_text(facets));
}

}  // namespace signorini
