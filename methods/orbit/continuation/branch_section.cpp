#include "methods/orbit/continuation/branch_section.hpp"

#include <algorithm>
#include <cmath>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/family/extended_equations.hpp"

namespace signorini {

SequencedOrbit orbit_of(const OrbitFamily& family, const OrbitBranch& branch, std::size_t i) {
  const SolutionPoint& point = branch.points[i];
  return sequenced(family, branch.orbits[i], kTwoPi * point.order / point.frequency, point.frequency,
                   point.parameter);
}

std::vector<SequencedOrbit> orbits_at(OrbitFamily& family, const OrbitBranch& branch, double parameter) {
  const double rounding = 1e-12 * family.units().parameter;
  std::vector<SequencedOrbit> orbits;
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    const SolutionPoint &a = branch.points[i - 1], &b = branch.points[i];
    const auto [least, most] = std::minmax(a.parameter, b.parameter);
    if (parameter < least - rounding || parameter > most + rounding) continue;
    const bool nearer = std::abs(a.parameter - parameter) <= std::abs(b.parameter - parameter);
    SequencedOrbit orbit = orbit_of(family, branch, nearer ? i - 1 : i);
    orbit.x[orbit.x.size() - 1] = parameter / family.units().parameter;
    ExtendedEquations equations(family, orbit);
    if (correct_at_parameter(equations, orbit.x)) orbits.push_back(equations.orbit());
  }
  return orbits;
}

}  // namespace signorini
