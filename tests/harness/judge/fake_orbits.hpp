#pragma once
// Orbit solvers that find what a test asks for.

#include <memory>
#include <string>

#include "harness/judge/orbit_solver.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::test {

/// The contact-free motion times a factor.
inline std::shared_ptr<const Trajectory> scaled(double factor) {
  Problem problem = one_mass();
  problem.force.front().cos = factor;
  return free_motion(problem);
}

/// Finds one motion at 1e-11, another at 1e-12.
inline OrbitSolver finds(double factor, double tight_factor) {
  return [=](const Problem&, const PeriodicMotionOptions& options, const Start&) {
    return Solution{.verdict = Verdict::converged,
                    .message = {},
                    .trajectory = scaled(options.tolerance > 5e-12 ? factor : tight_factor)};
  };
}

/// Finds nothing.
inline OrbitSolver fails(const std::string& why = "no") {
  return [=](const Problem&, const PeriodicMotionOptions&, const Start&) { return Solution{.message = why}; };
}

/// Polishes every answer to the contact-free motion times a factor.
inline OrbitPolisher polishes_to(double factor, double error_bar) {
  return [=](const Problem&, const Trajectory&, std::span<const Certificate>, Deadline) {
    CertifiedOrbit orbit{.motion = scaled(factor)};
    orbit.error_bar = error_bar;
    orbit.source = "exact orbit";
    return orbit;
  };
}

}  // namespace signorini::test
