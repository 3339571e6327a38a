#pragma once
// An answer in figures: what `solve` prints before it says how good the answer is.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "harness/judge/measures/motion.hpp"
#include "harness/records/motion_summary.hpp"
#include "methods/method.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// One displacement at equidistant instants of a period, the first at t = 0.
struct SampledDisplacement {
  double period = 1.0;       ///< [s]
  Eigen::VectorXd x;         ///< N [m]
  Eigen::VectorXd velocity;  ///< N, right-sided [m/s]; empty: x is straight between its instants
};

/// Largest and least value of a displacement over the period, between its instants too: those of Hermite's
/// cubic through values and velocities, and beside an instant where the velocity may jump those of the cubics
/// on either side, up to there. The error falls as the fourth power of the step.
/// \param jumps  instants in [0, period), ascending [s]
struct Extremes {
  double min = 0.0, max = 0.0;  ///< [m]
};
Extremes extremes(const SampledDisplacement& displacement, std::span<const double> jumps);

/// What a summary is asked for.
struct SummaryRequest {
  int harmonics = 5;           ///< of each displacement, at most; >= 0
  std::vector<int> dofs = {};  ///< coordinates whose motion is summarised too, each in [0, Nd)
};

/// The summary of an answer under the law that it represents.
///
/// - extremes as by `extremes`; of a motion that keeps values on nodes those of the nodes
/// - harmonics n = 1.. of the motion's period, from its samples, no more than its bandwidth
/// - impacts: impulses that are listed, and at rigid stops phases of force that are not `lasting`
///   (contact_phases), at the middle of the phase
/// - contact phases: those listed as events from closing to opening, else as samples show them
/// - u by `CoordinateMotion`
///
/// \param motion  the same, sampled by `sample_answer`
MotionSummary summarise_motion(const Problem& problem, const RepresentedLaw& law, const Trajectory& answer,
                               const Motion& motion, const SummaryRequest& request);

}  // namespace signorini
