#pragma once
// A cold solve by exact-orbit, with the orbit it ends in.

#include <gtest/gtest.h>

#include <memory>

#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::test {

/// Keeps the solution; `orbit` is null where the solve failed.
struct ColdOrbit {
  Solution solution = {};
  std::shared_ptr<const ExactTrajectory> orbit = {};
};

inline ColdOrbit cold_orbit(const Problem& problem, const ExactOrbitMethod::Options& options = {}) {
  ColdOrbit result{.solution = solve<ExactOrbitMethod>(problem, options)};
  if (result.solution.verdict == Verdict::converged)
    result.orbit = std::dynamic_pointer_cast<const ExactTrajectory>(result.solution.trajectory);
  return result;
}

/// Sum and product of the multipliers: trace and determinant of the monodromy matrix.
inline double trace(const ExactTrajectory& orbit) { return orbit.quality().multipliers.sum().real(); }
inline double determinant(const ExactTrajectory& orbit) { return orbit.quality().multipliers.prod().real(); }

}  // namespace signorini::test
