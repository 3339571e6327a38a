#pragma once
// What lies on a step of a curve of harmonic balance: folds, doublings, branch points, contacts.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "methods/curve.hpp"
#include "methods/harmonic_balance/continuation/depth_curve.hpp"
#include "methods/harmonic_balance/continuation/series_switching.hpp"

namespace signorini {

/// Where a step begins or ends: the point, its tangents, and the test functions.
struct SeriesStation {
  Eigen::VectorXd z, tangent;               ///< with the depths, see DepthCurve
  Eigen::VectorXd x, slope;                 ///< without them; the unit tangent of the curve of x
  std::vector<ContactDepth> depths = {};    ///< that are followed
  std::vector<std::size_t> intervals = {};  ///< of contact, per contact
  Eigen::MatrixXcd motion = {};             ///< x_n, (H+1) x Nc [m]
  double crossing = 0.0;                    ///< zero at branch points: signed_pivots of [R_x; slope^T]
  std::optional<double> doubling = {};      ///< zero at doublings: signed_pivots of doubled_jacobian
};

/// That of the point at which the curve is evaluated. Its short contacts are the depths from then on.
/// \param slope  unit tangent of the curve of x \param doublings  whether these are looked for
SeriesStation series_station(DepthCurve& curve, const Eigen::VectorXd& slope, bool doublings);

/// Intervals of contact of the motion at which the curve is evaluated, per contact. Those shorter than
/// kNoPhase, and those so near to the next one, do not count.
std::vector<std::size_t> interval_counts(const SeriesCurve& curve);

/// The special points of a step in the order they are met, and what begins there.
struct SeriesEvents {
  std::vector<SpecialPoint> special = {};       ///< `after` left at 0
  std::vector<SeriesStart> others = {};         ///< curves that begin at doublings and branch points
  std::optional<Eigen::VectorXd> grazing = {};  ///< unknowns where a motion without contact first touches
};

/// Locates them, to rounding of the method's own equations: the zeros of the frequency's component of the
/// tangent and of the test functions that change their signs, and the first instant at which the number of
/// intervals of contact changes.
///
/// \param length  of the step along here.tangent, which ends at `next`; the curve follows the depths of
///        `here` afterwards
/// \param leaving  the step leaves a motion of half the period, at which the other tests vanish too
SeriesEvents events_on_step(DepthCurve& curve, const SeriesStation& here, double length,
                            const SeriesStation& next, bool leaving);

}  // namespace signorini
