#pragma once
// The stops that are drawn with the motion of a contact.

#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// A stop of the displacement x of a contact.
struct DrawnStop {
  int contact = 0;     ///< whose stop it is
  double place = 0.0;  ///< x there [m]
};

/// The stop of a contact, and those of others that limit the same displacement the other way, as where a mass
/// moves between two walls.
std::vector<DrawnStop> stops_of(const Problem& problem, int contact);

/// Largest less least of values and stops [m].
double range_with(const std::vector<double>& x, const std::vector<DrawnStop>& stops);

/// Commands of gnuplot that draw them upright in a panel over x, in front of which `unset arrow` removes
/// them.
std::string wall_commands(const std::vector<DrawnStop>& stops);

}  // namespace signorini
