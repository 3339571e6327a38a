#pragma once
// Guards of an orbit with their derivatives along a curve, and what they may do between two points of it.

#include <Eigen/Core>
#include <vector>

#include "methods/orbit/family/survey.hpp"

namespace signorini {

/// A test function f of admissibility between two points of a curve, as a function of the length s in [0, h]
/// of the step, from values and derivatives at both ends:
///
///     f(s) = f_0 + p_0 z + c_2 z^2 + c_3 z^3 + e(z),   z = s / h,   |e| <= (|c_3| + |c_2| / 2) z^2 (1 -
///     z)^2.
///
/// The bound of e, which a constant fourth derivative would make an equation, assumes that the coefficient of
/// z^4 is not larger than that; an eighth of the depth of a parabola is granted in any case.
struct GuardCubic {
  double value = 0.0, last = 0.0;        ///< f_0, f_1 [-]
  double slope = 0.0, last_slope = 0.0;  ///< h f'_0, h f'_1 [-]
  /// z in (0, 1) where f may be least, with the least value that the bound of e allows there.
  struct Lowest {
    double at = 0.5;
    double bound = 0.0;
  };
  [[nodiscard]] Lowest lowest() const;
};

/// A guard, or one maximum of a guard, with its derivative along the curve.
struct TrackedGuard : GuardMaximum {
  double rate = 0.0;  ///< d value / d arc length [-]
};

/// All guards of an orbit, each maximum by itself, with their derivatives along its curve: of a maximum that
/// at fixed phase, for to first order its phase does not count. One evaluation of the flow.
///
/// \param equations  of its sequence; left evaluated beside the orbit
/// \param x          the orbit, in CurveUnits
/// \param tangent    unit tangent of the curve there
/// \param found      its guards
/// \return empty where the flow beside it is not finite
std::vector<TrackedGuard> tracked_guards(ExtendedEquations& equations, const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& tangent, const OrbitSurvey& found);

/// The same guard at the other end of a step: of several maxima on the same arc the nearest in phase. Null
/// where each has a nearer one, or the guard exists at one end only.
///
/// \param guard  one of `own`
const TrackedGuard* counterpart(const TrackedGuard& guard, const std::vector<TrackedGuard>& own,
                                const std::vector<TrackedGuard>& others);

}  // namespace signorini
