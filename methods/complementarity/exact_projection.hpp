#pragma once
// The projected contact equations with the contact integral taken exactly, and Newton's method for them.

#include <Eigen/Core>
#include <optional>

#include "methods/complementarity/projected_law.hpp"
#include "methods/deadline.hpp"
#include "methods/discretisation/contact_phases.hpp"

namespace signorini {

/// How project_exactly evaluates and when it ends.
struct ExactProjectionSettings {
  int samples = 0;           ///< instants on which sign changes of y are bracketed, at least 8 H
  double tolerance = 1e-10;  ///< on ExactProjection::residual [-]
  int most = 40;             ///< Newton steps [-]
  /// The end of the time budget, asked for between steps.
  Deadline deadline = {};
};

/// A solution of the exactly projected equations, or the best iterate.
struct ExactProjection {
  bool converged = false;  ///< the residual is below the tolerance
  int iterations = 0;      ///< Newton steps
  double residual = 0.0;   ///< |R|_2 / |lambda|_2, or over rounding where that is larger [-]
  std::optional<double> condition =
      {};                   ///< of the linear system of the last step (JacobianSolver); empty: none [-]
  Eigen::MatrixXcd lambda;  ///< (H+1) x Nc [N]
};

/// Solves R(lambda) = lambda + P max(0, y) = 0 for the law of `equations`, x = x_f + C lambda, with P exact,
/// by damped Newton steps from `lambda`, the solution of a nearby problem.
///
/// With exact P the contact force does no net work at every contact, to rounding, whatever H and c
/// (docs/theory.md, section 3); sampling leaves O(N^-2) of it, irregularly. The edges of contact move with
/// lambda, where y = 0: R is continuously differentiable, and Newton converges quadratically where no contact
/// is born or lost. Its linear systems are solved at the nodes of contact or by GMRES (JacobianSolver).
///
/// \param lambda  (H+1) x Nc [N]
/// \param shifts  the stops stand at g - shift(t); while that is constant during each contact, the contact
///        still does no net work, and with a speed it does speed J / T of it on the structure
ExactProjection project_exactly(const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                const ExactProjectionSettings& settings, const StopShifts& shifts = {});

/// The solution in which each contact presses at all times or never: which ones press, the mean of the load
/// says (one small complementarity problem); their forces come from one small solve per harmonic,
///
///     c (x_f,n - g delta_n0) + (c C_n + 1 - alpha) lambda_n = 0.
///
/// `converged` if they press throughout and the others stay open; the residual is to be below `tolerance`.
ExactProjection solve_permanent_contact(const ProjectedEquations& equations, double tolerance);

}  // namespace signorini
