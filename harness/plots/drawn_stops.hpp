#pragma once
// The stops that are drawn with the motion of a contact.

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "harness/report/figures/gnuplot.hpp"
#include "methods/solution.hpp"
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

/// The contact whose displacement has the largest range.
Eigen::Index liveliest(const Samples& motion);

/// Commands of gnuplot for a panel over x [m]: at most so many tics over all values and stops, the stops as
/// walls, in front of which `unset arrow` removes them.
std::string abscissa_commands(std::span<const double> x, const std::vector<DrawnStop>& stops, int most_tics);

/// Draws stops across a panel over time.
void draw_stops(const std::vector<DrawnStop>& stops, Canvas& canvas);

}  // namespace signorini
