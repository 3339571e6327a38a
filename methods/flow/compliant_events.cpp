#include <utility>

#include "methods/flow/stop_events.hpp"

namespace signorini {

CompliantEvents::CompliantEvents(const ContactDynamics& dynamics, double tolerance)
    : GivingEvents(dynamics),
      orders_{{.derivative = 0, .floor = event_noise(tolerance) * dynamics.scales().displacement},
              {.derivative = 1, .floor = event_noise(tolerance) * dynamics.scales().velocity},
              {.derivative = 2, .floor = event_noise(tolerance) * dynamics.scales().acceleration}} {}

FlowState CompliantEvents::place(double time, const State& state) const {
  const auto count = static_cast<std::size_t>(dynamics_.contact_count());
  FlowState flow{.time = time, .state = state, .closed = std::vector<bool>(count, false)};
  std::vector<bool> compliant(count, false);
  for (int j = 0; j < dynamics_.contact_count(); ++j)
    compliant[static_cast<std::size_t>(j)] = !dynamics_.halts(j);
  decide(time, state, orders_, std::move(compliant), flow.closed);
  return flow;
}

std::vector<bool> CompliantEvents::closed_after(const FlowState& flow, int trigger, bool) const {
  const std::vector<bool>& before = flow.closed;
  const MotionDerivatives motion = dynamics_.derivatives(dynamics_.mode(before), flow.time, flow.state, 2);
  std::vector<bool> closed = before, undecided(before.size(), false);
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    if (dynamics_.halts(j)) continue;
    if (j == trigger) {
      closed[index] = !before[index];
      continue;
    }
    const double guard = before[index] ? -motion.lambda(j, 0) * dynamics_.structure().compliance(j, j)
                                       : dynamics_.structure().gaps[j] - motion.x(j, 0);
    undecided[index] = guard <= orders_[0].floor;
    if (undecided[index]) closed[index] = false;
  }
  // Gaps and forces of the undecided are zero here: their speeds are the first to tell them apart.
  decide(flow.time, flow.state, {orders_[1], orders_[2]}, std::move(undecided), closed);
  return closed;
}

void CompliantEvents::resolve(FlowState& flow, int trigger, FlowRecord& record) const {
  const std::vector<bool> before = flow.closed;
  flow.closed = closed_after(flow, trigger, false);
  log_changes(before, flow, trigger, record);
}

}  // namespace signorini
