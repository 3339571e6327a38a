#include "methods/orbit/return_check.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "methods/flow/flow.hpp"
#include "problems/linear_algebra/general_eigen.hpp"

namespace signorini {

namespace {

constexpr double kTolerance = 1e-13;  // CVODE's local tolerance is at its floor
constexpr double kTenfold = 1e-10;    // and ten times as large

State one_period_later(const ContactDynamics& dynamics, const ExactTrajectory& orbit, Integrator integrator,
                       double tolerance, const std::function<bool()>& expired) {
  EventFlow flow(dynamics, tolerance, expired, integrator);
  FlowState end = orbit.orbit().start;
  FlowRecord record;
  flow.advance(end, orbit.period(), record);
  return end.state;
}

// By how much errors of one period have grown at its end, at most, relative to the scales of the motion.
double growth_of_errors(const ExactTrajectory& orbit, const MotionScales& scales) {
  constexpr int kStates = 100;
  double largest = 1.0;
  for (int i = 0; i < kStates; ++i) {
    const State state = orbit.at(orbit.period() * i / kStates);
    largest = std::max({largest, state.u.lpNorm<Eigen::Infinity>() / scales.displacement,
                        state.v.lpNorm<Eigen::Infinity>() / scales.velocity});
  }
  return largest * (1.0 + largest_magnitude(orbit.quality().multipliers));
}

}  // namespace

ReturnCheck cvode_return(const ContactDynamics& dynamics, const ExactTrajectory& orbit,
                         const std::function<bool()>& expired) {
  // CVODE's own error over a period at this tolerance, relative to the largest state met: below 2e-11 on the
  // populations of tests/methods/exact_orbit; the orbit's instability and the sensitivity of its instants
  // amplify it.
  constexpr double kFloor = 3e-11;
  constexpr double kLargest = 1e-6, kStillLinear = 1e-3;
  constexpr double kMostAdamsSteps = 1e5;
  constexpr double kSafety = 4.0;  // two runs may agree better than each of them does with the truth
  const MotionScales& scales = dynamics.scales();
  const State& start = orbit.orbit().start.state;
  // An orbit that multiplies errors is as much nearer to where CVODE returns, while that is near at all.
  const double largest =
      std::min(kStillLinear, kLargest * std::max(1.0, largest_magnitude(orbit.quality().multipliers)));
  const double expected =
      std::min(largest, orbit.quality().error_bar + kFloor * growth_of_errors(orbit, scales));
  ReturnCheck check{.distance = std::numeric_limits<double>::infinity(), .allowed = expected};
  // Adams' steps in a stiff structure are as short as its fastest decay, however little is left of that.
  const FlowStructure& structure = dynamics.structure();
  const bool endless = structure.stiff && structure.fastest_rate * orbit.period() > kMostAdamsSteps;
  const std::vector<Integrator> methods =
      endless ? std::vector{Integrator::bdf} : std::vector{Integrator::adams, Integrator::bdf};
  for (const Integrator integrator : methods) {
    try {
      const State end = one_period_later(dynamics, orbit, integrator, kTolerance, expired);
      const double missed = scales.distance(end, start);
      double allowed = expected;
      if (missed > allowed && missed <= largest) {
        const State coarse = one_period_later(dynamics, orbit, integrator, kTenfold, expired);
        allowed = std::min(largest, std::max(allowed, kSafety * scales.distance(coarse, end)));
      }
      if (missed < check.distance) check = {missed <= allowed, missed, allowed};
    } catch (const IntegrationError&) {
      if (integrator == methods.back() && check.distance > largest) throw;  // none of them
    }
    if (check.returned) break;
  }
  return check;
}

}  // namespace signorini
