#include "harness/run/start_point.hpp"

#include <fmt/format.h>

#include <cmath>

namespace signorini {

namespace {

/// How many periods of a motion make the one that a scene asks for; 0 if no whole number does.
int whole_periods(const Problem& problem, const Trajectory& motion) {
  constexpr double kSamePeriod = 1e-6;  // relative; as the period of an answer is judged
  const double ratio = problem.period() / motion.period();
  const double whole = std::round(ratio);
  return whole >= 1.0 && std::abs(ratio - whole) <= kSamePeriod * ratio ? static_cast<int>(whole) : 0;
}

}  // namespace

StartPoint start_point(const Case& planned_case, const Problem& problem, const Reference& reference) {
  const std::optional<double> late = planned_case.choice.start();
  if (!late) return {};
  if (!reference.orbit) return {.obstacle = "no orbit to start from: " + reference.reason};
  const int periods = whole_periods(problem, *reference.orbit);
  if (periods == 0) {
    return {.obstacle = fmt::format(
                "no orbit to start from: the one reached from rest has a period of {:.6g} s, asked "
                "for is {:.6g} s",
                reference.orbit->period(), problem.period())};
  }
  return {.motion = std::make_shared<SampledTrajectory>(repeated(delayed(*reference.orbit, *late), periods))};
}

}  // namespace signorini
