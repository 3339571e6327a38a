#pragma once
// Checks a claimed periodic orbit from outside: its own flow, its own contact conditions.

#include <string>

#include "methods/orbit/exact_trajectory.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

struct OrbitCheck {
  bool ok = true;
  std::string reason;            ///< the first condition that fails
  double return_distance = 0.0;  ///< of the state after a period, relative to the largest displacement met
  double penetration = 0.0;      ///< largest x_j - g_j, same scale
};

/// Follows the orbit for one period from its section state through its events and listed impulses, by matrix
/// exponentials of the equation of motion in all coordinates (multipliers eliminated by x_A'' = 0), 300 steps
/// per interval. Conditions, each to `tolerance` of the motion's scales: x_j <= g_j at open contacts,
/// lambda_j <= 0 at closed ones, x_j = g_j where one pushes, impulses <= 0, x'_+ = -e x'_- at impacts (0
/// where a contact stays, if e = 0 or the impact is slower than 1e-4 of the largest speed), the state
/// returns. Shares no code with the orbits it judges. Scenes with the law Restitution or Penalty.
OrbitCheck check_orbit(const Problem& problem, const ExactTrajectory& orbit, double tolerance);

}  // namespace signorini::test
