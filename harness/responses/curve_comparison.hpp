#pragma once
// What a method's frequency response holds of the exact one, and what it holds that is not there.

#include <optional>
#include <vector>

#include "harness/responses/response_curve.hpp"

namespace signorini {

/// The tolerances at which responses are compared, in the metric: 2 % and 5 %.
inline constexpr double kCloseTolerance = 0.02, kWideTolerance = 0.05;

/// Shares of length at one tolerance.
struct CurveShares {
  double covered = 0.0;                       ///< of the exact response, within tolerance of the method's
  std::optional<double> covered_stable = {};  ///< the same of its stable part; absent where there is none
  double false_share = 0.0;                   ///< of the method's response, farther from the exact one
};

/// A point of the exact response and the method's own, which may be missing.
struct PointMatch {
  LocatedPoint exact;
  std::optional<double> frequency = {};  ///< at which the method located it [rad/s]
};

/// A method's response against the exact one.
struct CurveComparison {
  CurveShares close = {}, wide = {};        ///< at kCloseTolerance and kWideTolerance
  double exact_length = 0.0;                ///< of the exact response, in the metric [-]
  double length = 0.0;                      ///< of the method's
  double right_length = 0.0;                ///< of the method's, within kWideTolerance of the exact one
  std::vector<PointMatch> points = {};      ///< in the order of their frequencies
  std::vector<LocatedPoint> invented = {};  ///< located by the method and not there
};

/// What steps of the frequency found that lies on none of the branches, farther than kCloseTolerance, each
/// motion once: in the order of the steps, with a gap wherever one lies on a branch or stands there already.
std::vector<ResponseBranch> beside_branches(const ResponseCurve& branches, const ResponseCurve& steps,
                                            const ResponseMetric& metric, double window);

/// Compares by length: the number of points does not count, and a point that stands alone counts as one
/// element. Located points are matched one to one with those of the same kind and order within 0.05 of the
/// interval, nearest first; a grazing and a change of contact are one kind, the beginning of contact.
CurveComparison compare_curves(const ResponseCurve& exact, const ResponseCurve& curve,
                               const ResponseMetric& metric, double window);

}  // namespace signorini
