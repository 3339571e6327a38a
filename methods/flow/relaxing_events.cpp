#include <algorithm>
#include <utility>

#include "methods/flow/stop_events.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

RelaxingEvents::RelaxingEvents(const ContactDynamics& dynamics, double tolerance)
    : GivingEvents(dynamics), touch_(event_noise(tolerance) * dynamics.scales().displacement) {
  for (int j = 0; j < dynamics.contact_count(); ++j)
    if (!dynamics.halts(j) && !springs_) springs_.emplace(dynamics, tolerance);
  // beta x' and beta x'' are told from zero at the noise of xi, X, and of its rates.
  const FlowStructure& structure = dynamics.structure();
  const double floor =
      event_noise(tolerance) *
      std::max(structure.scales.displacement, structure.relaxation.maxCoeff() * structure.scales.velocity);
  orders_ = {{.derivative = 1, .floor = floor},
             {.derivative = 2, .floor = floor * dynamics.structure().fastest_rate}};
}

FlowState RelaxingEvents::place(double time, const State& state) const {
  const FlowStructure& structure = dynamics_.structure();
  const auto count = static_cast<std::size_t>(dynamics_.contact_count());
  FlowState flow{.time = time, .state = state, .closed = std::vector<bool>(count, false)};
  std::vector<int> own;
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    if (structure.relaxes(j))
      own.push_back(j);
    else
      flow.state.u[dynamics_.size() + j] = 0.0;
  }
  Eigen::VectorXd gap = entries_of(structure.gaps - structure.unloaded(time, flow.state.u, 0), own);
  if (gap.size() > 0 && gap.minCoeff() < 0.0) {
    // The nearest admissible xi in the metric of C^-1: xi - C z with 0 <= z, 0 <= gap + C z.
    const auto z = solve_small_lcp(block_of(structure.massless_compliance, own, own), gap,
                                   std::vector<bool>(own.size(), false));
    if (!z) throw FlowError("no displacement satisfies all gaps");
    const Eigen::VectorXd moved = image_by_columns(structure.massless_compliance, own, *z);
    flow.state.u.tail(structure.relaxing()) -= moved;
    gap += entries_of(moved, own);
  }
  std::vector<bool> undecided(count, false);
  for (std::size_t i = 0; i < own.size(); ++i)
    undecided[static_cast<std::size_t>(own[i])] = gap[static_cast<Eigen::Index>(i)] <= touch_;
  if (springs_) flow.closed = springs_->place(time, flow.state).closed;
  decide(time, flow.state, orders_, std::move(undecided), flow.closed);
  hold(flow.state, dynamics_.mode(flow.closed));
  return flow;
}

void RelaxingEvents::hold(State& state, const ContactMode& of_all) const {
  const ContactMode mode = dynamics_.stops().part(of_all, false);
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

// What deviations do to x of a contact.
Eigen::VectorXd RelaxingEvents::moved(int contact, const Eigen::MatrixXd& derivative) const {
  const int n = dynamics_.size();
  Eigen::VectorXd result =
      image_by_transposed(derivative.topRows(n), dynamics_.structure().directions.col(contact));
  for (Eigen::Index i = 0; i < result.size(); ++i) result[i] += derivative(n + contact, i);
  return result;
}

// A state closer to its stop meets it earlier, by n^T dy / x'_-, and the two sides of the event differ by F+
// - F- for that long.
void RelaxingEvents::pass(const FlowState& after, const Eigen::VectorXd& before, int trigger,
                          Eigen::MatrixXd& derivative) const {
  const int n = dynamics_.size();
  const double speed =
      dynamics_.structure().directions.col(trigger).dot(before.head(n)) + before[n + trigger];
  const bool jumps =
      dynamics_.structure().relaxes(trigger) && after.closed[static_cast<std::size_t>(trigger)];
  if (jumps && speed > 0.0) {
    const Eigen::RowVectorXd earlier = moved(trigger, derivative).transpose() / speed;
    derivative += (rates(after) - before) * earlier;
  }
  admit(dynamics_.mode(after.closed), derivative);
}

void RelaxingEvents::admit(const ContactMode& of_all, Eigen::MatrixXd& derivative) const {
  const ContactMode mode = dynamics_.stops().part(of_all, false);
  if (mode.active.empty()) return;
  const FlowStructure& structure = dynamics_.structure();
  Eigen::MatrixXd beyond(mode.response.rows(), derivative.cols());
  for (std::size_t i = 0; i < mode.active.size(); ++i)
    beyond.row(static_cast<Eigen::Index>(i)) = moved(mode.active[i], derivative).transpose();
  derivative.middleRows(dynamics_.size(), structure.relaxing()) -=
      product(columns_of(structure.massless_compliance, mode.active), product(mode.response, beyond));
}

std::vector<bool> RelaxingEvents::closed_after(const FlowState& flow, int trigger, bool struck) const {
  // What springs do is felt by none of the others, and they feel displacements alone.
  const std::vector<bool> before = springs_ ? springs_->closed_after(flow, trigger, struck) : flow.closed;
  const FlowStructure& structure = dynamics_.structure();
  const bool own = trigger >= 0 && structure.relaxes(trigger);
  const bool closes = own && !before[static_cast<std::size_t>(trigger)];
  const MotionDerivatives motion = dynamics_.derivatives(dynamics_.mode(before), flow.time, flow.state, 2);
  // Where a contact closes or velocities have jumped, all forces jump. A contact that closes is pushed,
  // whatever the others do: G is positive definite.
  std::vector<bool> closed = before, undecided(before.size(), false);
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    if (!structure.relaxes(j)) continue;
    if (own && j == trigger) {
      closed[index] = closes;
    } else if (before[index]) {
      const double push = -motion.lambda(j, 0) * structure.compliance(j, j);
      undecided[index] = closes || struck || push <= orders_[0].floor;
      closed[index] = !undecided[index];
    } else {
      undecided[index] = structure.gaps[j] - motion.x(j, 0) <= touch_;
    }
  }
  decide(flow.time, flow.state, orders_, std::move(undecided), closed);
  return closed;
}

void RelaxingEvents::resolve(FlowState& flow, int trigger, FlowRecord& record) const {
  const std::vector<bool> before = flow.closed;
  const Eigen::VectorXd rates_before = rates(flow);
  flow.closed = closed_after(flow, trigger, false);
  hold(flow.state, dynamics_.mode(flow.closed));
  log_changes(before, flow, trigger, record);
  if (record.tangent) pass(flow, rates_before, trigger, record.derivative);
}

}  // namespace signorini
