#pragma once
// Newton's method on the equations of an orbit.

#include <Eigen/Core>
#include <string>

#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

/// How Newton's method ended.
struct OrbitNewtonResult {
  bool solved = false;
  bool merging = false;      ///< it failed because two events of the sequence come together
  std::string reason = {};   ///< why it failed, one clause
  int iterations = 0;        ///< Newton steps
  double residual = 0.0;     ///< largest of the equations, in scales; 0 where they are not finite [-]
  Eigen::VectorXd unknowns;  ///< of the last iterate, at which `equations` are left evaluated
};

/// Rounding error of the residual: 32 epsilon times the largest state met, in scales [-].
double residual_noise(const OrbitEquations& equations);

/// Solves the equations from their guess by `damped_newton`. Steps are shortened so that no interval between
/// events loses more than four fifths of its length, for beyond an event that overtakes another the equations
/// mean nothing, and halved until the residual falls. Solved: residual <= max(tolerance, residual_noise),
/// reduced by one more step where that is possible, or a residual that no longer falls and is within a
/// hundred times its noise.
OrbitNewtonResult solve(OrbitEquations& equations, double tolerance, int max_iterations);

}  // namespace signorini
