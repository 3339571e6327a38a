#include "harness/judge/orbit_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "harness/judge/measures/motion.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/structure/bases/condensation.hpp"

namespace signorini {

namespace {

bool converged(const Solution& solution) {
  return solution.verdict == Verdict::converged && solution.trajectory != nullptr;
}

Solution follow_flow(const Problem& problem, const PeriodicMotionOptions& options, const Start& start) {
  if (const std::string obstacle = flow_obstacle(problem); !obstacle.empty())
    return Solution{.message = obstacle};
  const ContactDynamics dynamics(problem);
  return find_periodic_motion(problem, dynamics, options, start);
}

}  // namespace

OrbitSolver flow_orbits() { return follow_flow; }

PeriodicMotionOptions marching_options() {
  return {.tolerance = kOrbitTolerance, .shooting = false, .max_iterations = 20000};
}

PeriodicMotionOptions shooting_options() {
  return {.tolerance = kOrbitTolerance, .shooting = true, .max_iterations = 50};
}

CertifiedOrbit confirm_orbit(const Problem& problem, const OrbitSolver& solver,
                             const PeriodicMotionOptions& options, const Start& start, const Solution& found,
                             double largest_error_bar) {
  if (!converged(found)) return {.reason = found.message.empty() ? "no orbit was found" : found.message};
  const Motion motion = sample_motion(problem, *found.trajectory);
  // Continued at the order that was found, which marching may find to be several forcing periods.
  PeriodicMotionOptions again = shooting_options();
  again.tolerance = kTightOrbitTolerance;
  Solution second = solver(with_subharmonic(problem, motion.order), again,
                           {.guess = found.trajectory, .deadline = start.deadline});
  if (!converged(second) && !options.shooting) {
    again = marching_options();
    again.tolerance = kTightOrbitTolerance;
    second = solver(problem, again, start);
  }
  if (!converged(second)) {
    return {.reason = fmt::format("found at tolerance {:g} but not at {:g}: {}", kOrbitTolerance,
                                  kTightOrbitTolerance, second.message)};
  }
  const Motion tight = sample_motion(problem, *second.trajectory);
  // Both searches may return the guess that they share: the error bar is at least that of the integration.
  const double error_bar =
      std::max(kOrbitTolerance, distance(motion, tight, best_shift(motion, tight)).x_l2.value_or(0.0));
  if (error_bar > largest_error_bar)
    return {.reason = fmt::format("two tolerances give orbits that differ by {:.1e}", error_bar)};
  return {.motion = second.trajectory,
          .error_bar = error_bar,
          .residual = second.residual,
          .source = options.shooting ? "shooting from the answer" : "marching"};
}

CertifiedOrbit find_orbit(const Problem& problem, const OrbitSolver& solver,
                          const PeriodicMotionOptions& options, const Start& start,
                          double largest_error_bar) {
  return confirm_orbit(problem, solver, options, start, solver(problem, options, start), largest_error_bar);
}

}  // namespace signorini
