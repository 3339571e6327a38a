#pragma once
// What a method's frequency response holds of the exact one, and what it holds that is not there.

#include <functional>
#include <limits>
#include <vector>

#include "harness/responses/response_curve.hpp"

namespace signorini {

/// The tolerances at which responses are compared, in the metric: 2 % and 5 %.
inline constexpr double kCloseTolerance = 0.02, kWideTolerance = 0.05;

/// Located points, each once: two branches that meet have both located it. Of one kind and order, as of
/// `compare_curves`, within 1e-6 of the window.
std::vector<LocatedPoint> distinct_points(std::vector<LocatedPoint> points, double window);

/// What steps of the frequency found that lies on none of the branches, farther than kCloseTolerance, each
/// motion once: in the order of the steps, with a gap wherever one lies on a branch or stands there already.
std::vector<ResponseBranch> beside_branches(const ResponseCurve& branches, const ResponseCurve& steps,
                                            const ResponseMetric& metric, double window);

/// What of a comparison is left to its caller.
struct ComparisonOptions {
  /// Longest period of what is to be found [forcing periods]; exact motions of more are true all the same.
  int orders = std::numeric_limits<int>::max();
  /// Whether a motion on no exact branch is one of the scene; asked for each element farther than
  /// kWideTolerance. Empty: none is.
  std::function<bool(const ResponsePoint&)> is_true = {};
};

/// Compares by length: the number of points does not count, and a point that stands alone counts as one
/// element. Located points are matched one to one with those of the same kind and order within 0.05 of the
/// interval, nearest first; a grazing and a change of contact are one kind, the beginning of contact.
/// Found, of all and located are of the orders asked for, of the stable part of every order. What `is_true`
/// accepts is right.
CurveComparison compare_curves(const ResponseCurve& exact, const ResponseCurve& curve,
                               const ResponseMetric& metric, double window,
                               const ComparisonOptions& options = {});

}  // namespace signorini
