#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/flow/stop_events.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

RelaxingEvents::RelaxingEvents(const ContactDynamics& dynamics, double tolerance)
    : StopEvents(dynamics), touch_(event_noise(tolerance) * dynamics.scales().displacement) {
  // beta x' and beta x'' are told from zero at the noise of xi, X, and of its rates.
  const double floor = event_noise(tolerance) * dynamics.stops().scale(0);
  orders_ = {{.derivative = 1, .floor = floor},
             {.derivative = 2, .floor = floor * dynamics.structure().fastest_rate}};
}

FlowState RelaxingEvents::place(double time, const State& state) const {
  const FlowStructure& structure = dynamics_.structure();
  const auto count = static_cast<std::size_t>(dynamics_.contact_count());
  FlowState flow{.time = time, .state = state, .closed = std::vector<bool>(count, false)};
  Eigen::VectorXd gap = structure.gaps - structure.unloaded(time, state.u, 0);
  if (gap.size() > 0 && gap.minCoeff() < 0.0) {
    // The nearest admissible xi in the metric of C^-1: xi - C z with 0 <= z, 0 <= gap + C z.
    const auto z = solve_small_lcp(structure.massless_compliance, gap, flow.closed);
    if (!z) throw FlowError("no displacement satisfies all gaps");
    const Eigen::VectorXd moved = image(structure.massless_compliance, *z);
    flow.state.u.tail(structure.relaxing()) -= moved;
    gap += moved;
  }
  std::vector<bool> undecided(count);
  for (std::size_t j = 0; j < count; ++j) undecided[j] = gap[static_cast<Eigen::Index>(j)] <= touch_;
  decide(time, flow.state, orders_, std::move(undecided), flow.closed);
  hold(flow.state, dynamics_.mode(flow.closed));
  return flow;
}

void RelaxingEvents::hold(State& state, const ContactMode& mode) const {
  if (mode.active.empty()) return;
  const FlowStructure& structure = dynamics_.structure();
  const Eigen::VectorXd beyond =
      entries_of(structure.unloaded(0.0, state.u, 0), mode.active) - entries_of(structure.gaps, mode.active);
  state.u.tail(structure.relaxing()) -=
      image_by_columns(structure.massless_compliance, mode.active, image(mode.response, beyond));
}

// (u, xi, v)' in the mode that the flow is in.
Eigen::VectorXd RelaxingEvents::rates(const FlowState& flow) const {
  Eigen::VectorXd y(dynamics_.states()), rate(dynamics_.states());
  y << flow.state.u, flow.state.v;
  dynamics_.rate(dynamics_.mode(flow.closed), flow.time, y, rate);
  return rate;
}

// A state closer to its stop meets it earlier, by n^T dy / x'_-, and the two sides of the event differ by F+
// - F- for that long.
void RelaxingEvents::pass(const FlowState& after, const Eigen::VectorXd& before, int trigger,
                          Eigen::MatrixXd& derivative) const {
  const FlowStructure& structure = dynamics_.structure();
  const int n = dynamics_.size(), contacts = structure.relaxing();
  const auto moved = [&](int j) {
    Eigen::VectorXd result = image_by_transposed(derivative.topRows(n), structure.directions.col(j));
    for (Eigen::Index i = 0; i < result.size(); ++i) result[i] += derivative(n + j, i);
    return result;
  };
  const double speed = structure.directions.col(trigger).dot(before.head(n)) + before[n + trigger];
  if (after.closed[static_cast<std::size_t>(trigger)] && speed > 0.0) {
    const Eigen::RowVectorXd earlier = moved(trigger).transpose() / speed;
    derivative += (rates(after) - before) * earlier;
  }
  const ContactMode mode = dynamics_.mode(after.closed);
  if (mode.active.empty()) return;
  Eigen::MatrixXd beyond(mode.response.rows(), derivative.cols());
  for (std::size_t i = 0; i < mode.active.size(); ++i)
    beyond.row(static_cast<Eigen::Index>(i)) = moved(mode.active[i]).transpose();
  derivative.middleRows(n, contacts) -=
      product(columns_of(structure.massless_compliance, mode.active), product(mode.response, beyond));
}

void RelaxingEvents::resolve(FlowState& flow, int trigger, FlowRecord& record) const {
  const std::vector<bool> before = flow.closed;
  const auto changing = static_cast<std::size_t>(trigger);
  const bool closes = !before[changing];
  const Eigen::VectorXd rates_before = rates(flow);
  const MotionDerivatives motion = dynamics_.derivatives(dynamics_.mode(before), flow.time, flow.state, 2);
  // Where a contact closes, all forces jump. The one that closes is pushed, whatever the others do: G is
  // positive definite.
  std::vector<bool> closed(before.size(), false), undecided(before.size(), false);
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    if (index == changing) {
      closed[index] = closes;
    } else if (before[index]) {
      const double push = -motion.lambda(j, 0) * dynamics_.structure().compliance(j, j);
      undecided[index] = closes || push <= orders_[0].floor;
      closed[index] = !undecided[index];
    } else {
      undecided[index] = dynamics_.structure().gaps[j] - motion.x(j, 0) <= touch_;
    }
  }
  decide(flow.time, flow.state, orders_, std::move(undecided), closed);
  flow.closed = closed;
  hold(flow.state, dynamics_.mode(closed));
  log_changes(before, flow, trigger, record);
  if (record.tangent) pass(flow, rates_before, trigger, record.derivative);
}

}  // namespace signorini
