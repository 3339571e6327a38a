#pragma once
// Loads and contacts of a scene as a schematic shows them: grouped by where they act, and in words.

#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// A number as people write it: "0.1", "10⁴", "2.5·10⁻³", with so many digits at most.
std::string number_text(double value, int digits = 4);
/// "0.2 m", or the range of several: "0.1 … 0.3 m".
std::string range_text(double least, double largest, const std::string& unit);

/// The contacts that limit one coordinate on one side: drawn as one stop.
struct SingleStop {
  int dof = 0;
  bool forward = true;  ///< limits positive displacements
  int contacts = 0;
  double least_gap = 0.0, largest_gap = 0.0;  ///< [m]
};
/// By coordinate, then the positive side first.
std::vector<SingleStop> single_stops(const Problem& problem);
/// "g = 0.2 m", "3 stops, g = 0.1 … 0.3 m".
std::string gap_text(const SingleStop& stop);

/// A contact between two coordinates, x = u[closing] - u[other] but for positive factors.
struct PairStop {
  int closing = 0, other = 0;
  double gap = 0.0;  ///< [m]
};
std::vector<PairStop> pair_stops(const Problem& problem);
/// Contacts that are neither: on more coordinates, or on two that close it together.
int other_stops(const Problem& problem);

/// Length at which a gap is drawn, of those of a scene whose largest size is `largest` [cm]: all can be told
/// from none, larger ones from smaller ones. A gap of 0 or less is drawn closed.
double drawn_gap(double gap, double largest);
/// The largest gap of the problem in size [m].
double largest_gap(const Problem& problem);

/// Loaded coordinates, rising.
std::vector<int> loaded_coordinates(const Problem& problem);
/// The load on a coordinate, "0.5 cos ωt N", "f(t)" where that would be long.
std::string load_text(const Problem& problem, int dof);

/// Whether stops are springs.
bool has_compliant_stops(const Problem& problem);
/// What is below the picture: frequency of the load, order, law.
std::string motion_note(const Problem& problem);

}  // namespace signorini
