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

/// Inner lines of so many equal elements that can be told apart on paper, as shares of the whole in (0, 1):
/// all of them up to 40 elements, of finer meshes about 40 lines.
std::vector<double> mesh_lines(int elements);
/// "20 elements", and of how many the lines are where they are not all drawn: "10000 elements (a line every
/// 250)".
std::string elements_text(int elements);

/// Contacts that are drawn as one: those that limit one coordinate on one side, or several of these.
struct SingleStop {
  int dof = 0;
  bool forward = true;  ///< limits positive displacements
  int contacts = 0;
  double least_gap = 0.0, largest_gap = 0.0;  ///< [m]

  /// Takes in others; dof and side are those of the first.
  void add(const SingleStop& other);
};
/// By coordinate, then the positive side first.
std::vector<SingleStop> single_stops(const Problem& problem);
/// Whether both sides of its coordinate are limited. \param all  single_stops
bool has_other_side(const SingleStop& stop, const std::vector<SingleStop>& all);
/// "g = 0.2 m", "3 stops, g = 0.1 … 0.3 m".
std::string gap_text(const SingleStop& stop, const char* things = "stops");

/// A contact between two coordinates, x = u[closing] - u[other] but for positive factors.
struct PairStop {
  int closing = 0, other = 0;
  double gap = 0.0;  ///< [m]
};
std::vector<PairStop> pair_stops(const Problem& problem);
/// Contacts that are neither: on more coordinates, or on two that close it together.
int other_stops(const Problem& problem);
/// ", 3 more contacts not drawn"; nothing of none.
std::string hidden_text(std::ptrdiff_t count, const std::string& contact, const char* rest = "");

/// Length at which a gap of a scene is drawn [cm]: all can be told from none, larger ones from smaller ones.
/// A gap of 0 or less is drawn closed.
double drawn_gap(double gap, const Problem& problem);

/// Loaded coordinates, rising.
std::vector<int> loaded_coordinates(const Problem& problem);
/// The load on a coordinate, "0.5 cos ωt N", "f(t)" where that would be long.
std::string load_text(const Problem& problem, int dof);

/// What is below the picture: frequency of the load, order, law.
std::string motion_note(const Problem& problem);

}  // namespace signorini
