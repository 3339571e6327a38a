#include "methods/kernels/exact_orbit/return_check.hpp"

#include <algorithm>

#include "methods/kernels/event_flow/flow.hpp"

namespace signorini {

ReturnCheck cvode_return(const ContactDynamics& dynamics, const ExactTrajectory& orbit,
                         const std::function<bool()>& expired) {
  constexpr double kTolerance = 1e-13;
  // CVODE's own error over a period at this tolerance, relative to the largest state met: below 2e-11 on the
  // populations of tests/methods/exact_orbit; the orbit's instability and the sensitivity of its instants
  // amplify it.
  constexpr double kFloor = 3e-11;
  constexpr int kStates = 100;
  const MotionScales& scales = dynamics.scales();
  EventFlow flow(dynamics, kTolerance, expired);
  const FlowState& start = orbit.orbit().start;
  FlowState end = start;
  FlowRecord record;
  flow.advance(end, orbit.period(), record);
  double largest = 1.0;
  for (int i = 0; i < kStates; ++i) {
    const State state = orbit.at(orbit.period() * i / kStates);
    largest = std::max({largest, state.u.lpNorm<Eigen::Infinity>() / scales.displacement,
                        state.v.lpNorm<Eigen::Infinity>() / scales.velocity});
  }
  const OrbitQuality& quality = orbit.quality();
  double growth = 1.0 + quality.amplification;
  if (quality.multipliers.size() > 0) growth += quality.multipliers.cwiseAbs().maxCoeff();
  ReturnCheck check;
  check.distance = std::max((end.state.u - start.state.u).lpNorm<Eigen::Infinity>() / scales.displacement,
                            (end.state.v - start.state.v).lpNorm<Eigen::Infinity>() / scales.velocity);
  check.allowed = quality.error_bar + kFloor * largest * growth;
  check.returned = check.distance <= check.allowed;
  return check;
}

}  // namespace signorini
