#pragma once
// Contact that never opens.

#include <Eigen/Core>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/projected_law.hpp"

namespace signorini {

/// The solution in which each contact presses at all times or never: which ones press, the mean of the load
/// says (one small complementarity problem); their forces come from one small solve per harmonic,
///
///     c (x_f,n - g delta_n0) + (c C_n + 1 - alpha) lambda_n = 0.
///
/// `converged` if they press throughout and the others stay open; the residual is to be below `tolerance`.
ExactProjection solve_permanent_contact(const ProjectedEquations& equations, double tolerance);

}  // namespace signorini
