#pragma once
// A scene over an interval of frequencies of its load, in the units of the curves that a method follows
// there.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// What curves of a method over the frequency of the load have in common. Their last unknown is the frequency
/// over its unit; the units do not change along them.
struct CurveFamily {
  Problem problem;  ///< in the middle of the interval, its order that of the shortest motions followed
  double low = 0.0, high = 0.0;    ///< of the interval [rad/s]
  double frequency_unit = 1.0;     ///< of the frequency in the unknowns [rad/s]
  double displacement_unit = 1.0;  ///< of displacements in the unknowns [m]

  /// Whether larger frequencies lead from there into the interval. \param frequency  [rad/s]
  [[nodiscard]] bool is_below_middle(double frequency) const { return frequency < 0.5 * (low + high); }
  /// What a step from unknowns x to a frequency meets first (first_target). \param end  [rad/s]
  [[nodiscard]] std::optional<StepTarget> target(const std::vector<double>& values, const Eigen::VectorXd& x,
                                                 double end) const;
  /// Whether the frequency turns on a step so that a value is passed forth and back (turns_past); false for
  /// steps below 1e-5, which are not worth shortening for it. \param end  [rad/s] \param tangent  there
  [[nodiscard]] bool turns_past(const std::vector<double>& values, const CurveStep& step, double end,
                                const Eigen::VectorXd& tangent) const;
};

/// A family with its units: a third of the interval for the frequency; the static deflection of the softest
/// contact, or its gap if that is larger, for displacements; 1 where there is neither.
/// \param from, to  ends of the interval [rad/s]
CurveFamily curve_family(const Problem& problem, double from, double to);

}  // namespace signorini
