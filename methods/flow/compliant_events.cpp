#include "methods/flow/compliant_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "methods/solvers/small_lcp.hpp"

namespace signorini {

CompliantEvents::CompliantEvents(const ContactDynamics& dynamics, double tolerance)
    : dynamics_(dynamics),
      noise_(std::max(0.01 * tolerance, 64.0 * std::numeric_limits<double>::epsilon())) {}

FlowState CompliantEvents::place(double time, const State& state) const {
  return {.time = time, .state = state, .closed = pushing(time, state)};
}

std::vector<bool> CompliantEvents::pushing(double time, const State& state) const {
  const auto count = static_cast<std::size_t>(dynamics_.contact_count());
  std::vector<bool> closed(count, false);
  decide(time, state, 0, std::vector<bool>(count, true), closed);
  return closed;
}

// Settles the contacts that are `undecided` (and not closed), derivative by derivative.
void CompliantEvents::decide(double time, const State& state, int first_order, std::vector<bool> undecided,
                             std::vector<bool>& closed) const {
  constexpr int kHighest = 2;
  const MotionScales& scales = dynamics_.scales();
  const double units[] = {scales.displacement, scales.velocity, scales.acceleration};
  for (int order = first_order; order <= kHighest; ++order) {
    std::vector<int> involved;
    std::vector<bool> held;
    for (int j = 0; j < dynamics_.contact_count(); ++j) {
      const auto index = static_cast<std::size_t>(j);
      if (!closed[index] && !undecided[index]) continue;
      involved.push_back(j);
      held.push_back(closed[index]);
    }
    if (std::find(held.begin(), held.end(), false) == held.end()) return;
    const MotionDerivatives motion = dynamics_.derivatives(dynamics_.mode(closed), time, state, 2);
    Eigen::VectorXd gap = -dynamics_.structure().unloaded(time, motion.u.col(order), order);
    if (order == 0) gap += dynamics_.structure().gaps;
    const Eigen::MatrixXd C = dynamics_.structure().compliance(involved, involved);
    const Eigen::VectorXd q = gap(involved);
    const auto push = solve_small_lcp(C, q, held);
    if (!push) throw FlowError("no contact forces satisfy the contact law: the stops depend on each other");
    const Eigen::VectorXd opening = C * *push + q;
    const double floor = noise_ * units[order];
    for (std::size_t i = 0; i < involved.size(); ++i) {
      const auto index = static_cast<std::size_t>(involved[i]);
      const auto row = static_cast<Eigen::Index>(i);
      if (held[i]) continue;
      closed[index] = (*push)[row] * C(row, row) > floor;
      undecided[index] = !closed[index] && opening[row] <= floor;
    }
  }
}

void CompliantEvents::resolve(FlowState& flow, int trigger, FlowRecord& record) const {
  const std::vector<bool> before = flow.closed;
  const auto changing = static_cast<std::size_t>(trigger);
  const MotionDerivatives motion = dynamics_.derivatives(dynamics_.mode(before), flow.time, flow.state, 2);
  std::vector<bool> closed = before, undecided(before.size(), false);
  closed[changing] = !before[changing];
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    if (index == changing) continue;
    const double guard = before[index] ? -motion.lambda(j, 0) * dynamics_.structure().compliance(j, j)
                                       : dynamics_.structure().gaps[j] - motion.x(j, 0);
    undecided[index] = guard <= noise_ * dynamics_.scales().displacement;
    if (undecided[index]) closed[index] = false;
  }
  decide(flow.time, flow.state, 1, std::move(undecided), closed);
  flow.closed = closed;
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    if (closed[index] == before[index]) continue;
    record.events.push_back({.kind = closed[index] ? ContactEvent::Kind::close : ContactEvent::Kind::open,
                             .contact = j,
                             .time = flow.time});
  }
  record.sequence.push_back({.kind = closed[changing] ? ContactEvent::Kind::close : ContactEvent::Kind::open,
                             .contact = trigger,
                             .time = flow.time,
                             .closed = closed});
}

}  // namespace signorini
