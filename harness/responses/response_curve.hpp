#pragma once
// A frequency response as a method gives it, and the same cut into short pieces of known length.

#include <string>
#include <vector>

#include "harness/records/recorded_response.hpp"
#include "harness/responses/response_metric.hpp"
#include "harness/sweep/frequency_response.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// Points of a response that follow each other.
struct ResponseBranch {
  std::vector<ResponsePoint> points = {};
  bool by_arc_length = true;  ///< each step was corrected along the branch; else by steps of the frequency
};

/// All that one method makes of a response.
struct ResponseCurve {
  std::vector<ResponseBranch> branches = {};
  std::vector<LocatedPoint> located = {};
  std::vector<std::string> open_ends = {};  ///< what was not followed to its end, each with its reason
};

/// The points of a diagram, whose motions must be kept at kComparedPhases.
ResponseCurve curve_of(const BranchDiagram& diagram);

/// The converged points of a sweep, each over its own period, with a gap wherever a solve has failed.
ResponseCurve curve_of(const std::vector<SweepPoint>& steps);

/// The response of an exact record as its file keeps it, with motions (`drawn_with_motions`).
ResponseCurve curve_of(const RecordedResponse& response);

/// The branches of a response as they are drawn.
std::vector<DrawnBranch> drawn(const ResponseCurve& curve);
/// The same with the motions of their points, rounded to 5e-4 of their size, and whether they are of steps.
std::vector<DrawnBranch> drawn_with_motions(const ResponseCurve& curve);

/// A response whose branches by arc length keep the points that straight lines between them need: what is
/// left out is as stable as both its neighbours and within 1e-3 of their chord, by share of length.
ResponseCurve thinned(ResponseCurve curve, const ResponseMetric& metric);

/// Largest of the contacts: half of largest less least x_j [m].
double half_range(const Eigen::MatrixXd& motion);

/// Half of the largest peak to peak of any x_j on a response [m]; 0 for an empty one.
double amplitude_of(const ResponseCurve& curve);

/// A short piece of a response: the point in its middle, and its length in the metric.
struct CurveElement {
  ResponsePoint middle;
  double length = 0.0;
};

/// Length of the elements that a response is cut into, and of a point that stands alone.
inline constexpr double kElementLength = 0.005;
/// Steps of the frequency whose points are farther apart are taken for a jump: nothing is drawn between them.
inline constexpr double kLongestChord = 0.08;

/// The response as elements of at most kElementLength, each over its least period, by linear interpolation
/// of the motion between neighbours. Between steps of the frequency farther apart than kLongestChord nothing
/// is interpolated. A point without a neighbour is an element of its own.
std::vector<CurveElement> elements_of(const ResponseCurve& curve, const ResponseMetric& metric);

}  // namespace signorini
