#pragma once
// One step of pseudo-arclength continuation: tangent, corrector, and a zero along the step.

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "methods/orbit/continuation/extended_equations.hpp"

namespace signorini {

/// When the corrector stops.
struct CorrectorLimits {
  int iterations = 7;        ///< Newton steps at most
  double tolerance = 2e-13;  ///< of R, relative to the largest unknown [-]
};

/// The point of the curve in the plane tangent . (x - predicted) = 0, by full Newton steps on [R; plane] with
/// the Jacobian [R_x; tangent^T], LU with pivoting. Steps are neither shortened nor kept from passing a
/// grazing or from exchanging two events: the curve is smooth there. Where it fails the caller shortens its
/// own step.
///
/// Converged: |R| <= tolerance max(1, |x|), or no longer falling and within a hundred times its noise.
///
/// \return the Newton steps taken; `equations` are left evaluated at the point. Empty where it fails.
std::optional<int> correct(ExtendedEquations& equations, const Eigen::VectorXd& predicted,
                           const Eigen::VectorXd& tangent, const CorrectorLimits& limits = {});

/// The point of the curve nearby where the parameter is what it is in `predicted`.
std::optional<int> correct_at_parameter(ExtendedEquations& equations, const Eigen::VectorXd& predicted);

/// The unit null vector of [R_x] where the equations are evaluated, on the side of `previous`; empty where
/// the bordered matrix is singular.
std::optional<Eigen::VectorXd> tangent_of(ExtendedEquations& equations, const Eigen::VectorXd& previous);
/// The same without a predecessor: the right singular vector of the smallest singular value, of either sign.
Eigen::VectorXd first_tangent(ExtendedEquations& equations);

/// A point of a curve with its tangent, and the step from there that leads to the next one.
struct CurveStep {
  Eigen::VectorXd x, tangent;
  double length = 0.0;  ///< along the tangent
};

/// A quantity where the equations are evaluated; empty where it does not exist.
using CurveFunction = std::function<std::optional<double>(ExtendedEquations&)>;

/// The zero of f between the beginning of a step, where it has the value `first`, and its end, where it is
/// `last` of the other sign: Illinois' rule on the length of the step, each evaluation a corrector of its
/// own. Where f does not exist at the beginning, the step is halved until f exists with the other sign; where
/// it never does, the zero is where it begins to exist.
///
/// \return the length; `equations` are left evaluated there. Empty where it cannot be found.
std::optional<double> locate(ExtendedEquations& equations, const CurveStep& step, const CurveFunction& f,
                             std::optional<double> first, double last);

}  // namespace signorini
