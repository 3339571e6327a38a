#pragma once
// Diagrams for the tests of continuation, and what they look up in them.

#include <algorithm>
#include <cmath>
#include <memory>

#include "methods/orbit/continuation/diagram.hpp"
#include "methods/orbit/exact_orbit.hpp"

namespace signorini::test {

inline constexpr double kLocated = 1e-9;  // of a special point, as its closed form is known [rad/s]

inline OrbitDiagram diagram_of(const Problem& problem, double from, double to,
                               const CurveLimits& limits = {}) {
  OrbitFamily family(over_frequency(problem, from, to));
  return trace_diagram(family, {contact_free_orbit(family, to).value()}, limits);
}

// [a b; b c].
inline SparseMatrix symmetric(double a, double b, double c) {
  SparseMatrix A(2, 2);
  A.insert(0, 0) = a;
  A.insert(0, 1) = A.insert(1, 0) = b;
  A.insert(1, 1) = c;
  A.makeCompressed();
  return A;
}

// The branch of orbits of an order with so many impacts.
inline const OrbitBranch* branch_of(const OrbitDiagram& diagram, int order, int impacts) {
  const auto found =
      std::find_if(diagram.branches.begin(), diagram.branches.end(), [&](const OrbitBranch& branch) {
        return branch.points.front().order == order && branch.points[1].impacts == impacts;
      });
  return found == diagram.branches.end() ? nullptr : &*found;
}

// Where a branch has a special point of a kind next to a value; what is missing is far away.
inline double nearest(const Branch& branch, SpecialKind kind, double to) {
  double best = 1e300;
  for (const SpecialPoint& special : branch.special) {
    if (special.kind == kind && std::abs(special.point.parameter - to) < std::abs(best - to))
      best = special.point.parameter;
  }
  return best;
}

// The same among all branches.
inline double nearest(const OrbitDiagram& diagram, SpecialKind kind, double to) {
  double best = 1e300;
  for (const OrbitBranch& branch : diagram.branches) {
    const double here = nearest(branch, kind, to);
    if (std::abs(here - to) < std::abs(best - to)) best = here;
  }
  return best;
}

// The orbit of the i-th point of a branch, polished on the scene at its parameter.
inline ExactOrbit polished(const ParametrisedScene& scene, const OrbitBranch& branch, std::size_t i) {
  const SolutionPoint& point = branch.points[i];
  const auto model = std::make_shared<OrbitModel>(with_subharmonic(scene.at(point.parameter), point.order));
  return polish_sequence(model, branch.orbits[i]);
}

}  // namespace signorini::test
