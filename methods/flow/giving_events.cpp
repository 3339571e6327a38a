#include <algorithm>
#include <utility>

#include "methods/flow/stop_events.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

GivingEvents::GivingEvents(const ContactDynamics& dynamics, double tolerance)
    : StopEvents(dynamics), touch_(event_noise(tolerance) * dynamics.scales().displacement) {
  const FlowStructure& structure = dynamics.structure();
  const MotionScales& scales = structure.scales;
  for (int j = 0; j < dynamics.contact_count(); ++j) springs_ = springs_ || !dynamics.halts(j);
  of_springs_ = {{.derivative = 0, .floor = touch_},
                 {.derivative = 1, .floor = event_noise(tolerance) * scales.velocity},
                 {.derivative = 2, .floor = event_noise(tolerance) * scales.acceleration}};
  if (structure.relaxing() == 0) return;
  // beta x' and beta x'' are told from zero at the noise of xi, X, and of its rates.
  const double floor = event_noise(tolerance) *
                       std::max(scales.displacement, structure.relaxation.maxCoeff() * scales.velocity);
  of_relaxing_ = {{.derivative = 1, .floor = floor},
                  {.derivative = 2, .floor = floor * structure.fastest_rate}};
}

FlowState GivingEvents::place(double time, const State& state) const {
  const FlowStructure& structure = dynamics_.structure();
  const auto count = static_cast<std::size_t>(dynamics_.contact_count());
  FlowState flow{.time = time, .state = state, .closed = std::vector<bool>(count, false)};
  std::vector<bool> springs(count, false), touching(count, false);
  std::vector<int> own;
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    springs[static_cast<std::size_t>(j)] = !dynamics_.halts(j);
    if (structure.relaxes(j))
      own.push_back(j);
    else if (structure.relaxing() > 0)
      flow.state.u[dynamics_.size() + j] = 0.0;
  }
  Eigen::VectorXd gap = entries_of(structure.gaps - structure.unloaded(time, flow.state.u, 0), own);
  if (gap.size() > 0 && gap.minCoeff() < 0.0) {
    // The nearest xi in the metric of C^-1: xi - C z.
    const Eigen::VectorXd moved = image_by_columns(structure.massless_compliance, own,
                                                   moving_back(structure.massless_compliance, own, gap));
    flow.state.u.tail(structure.relaxing()) -= moved;
    gap += entries_of(moved, own);
  }
  for (std::size_t i = 0; i < own.size(); ++i)
    touching[static_cast<std::size_t>(own[i])] = gap[static_cast<Eigen::Index>(i)] <= touch_;
  decide(time, flow.state, of_springs_, std::move(springs), flow.closed);
  decide(time, flow.state, of_relaxing_, std::move(touching), flow.closed);
  if (dynamics_.structure().relaxing() > 0) hold(flow.state, dynamics_.mode(flow.closed));
  return flow;
}

void GivingEvents::hold(State& state, const ContactMode& of_all) const {
  const FlowStructure& structure = dynamics_.structure();
  if (structure.relaxing() == 0) return;
  const ContactMode mode = dynamics_.stops().part(of_all, false);
  if (mode.active.empty()) return;
  const Eigen::VectorXd beyond =
      entries_of(structure.unloaded(0.0, state.u, 0), mode.active) - entries_of(structure.gaps, mode.active);
  state.u.tail(structure.relaxing()) -=
      image_by_columns(structure.massless_compliance, mode.active, image(mode.response, beyond));
}

// (u, xi, v)' in the mode that the flow is in.
Eigen::VectorXd GivingEvents::rates(const FlowState& flow) const {
  Eigen::VectorXd y(dynamics_.states()), rate(dynamics_.states());
  y << flow.state.u, flow.state.v;
  dynamics_.rate(dynamics_.mode(flow.closed), flow.time, y, rate);
  return rate;
}

// What deviations do to x of a contact.
Eigen::VectorXd GivingEvents::moved(int contact, const Eigen::MatrixXd& derivative) const {
  const int n = dynamics_.size();
  Eigen::VectorXd result =
      image_by_transposed(derivative.topRows(n), dynamics_.structure().directions.col(contact));
  for (Eigen::Index i = 0; i < result.size(); ++i) result[i] += derivative(n + contact, i);
  return result;
}

// A state closer to its stop meets it earlier, by n^T dy / x'_-, and the two sides of the event differ by F+
// - F- for that long.
void GivingEvents::pass(const FlowState& after, const Eigen::VectorXd& before, int trigger,
                        Eigen::MatrixXd& derivative) const {
  const FlowStructure& structure = dynamics_.structure();
  const int n = dynamics_.size();
  if (structure.relaxes(trigger) && after.closed[static_cast<std::size_t>(trigger)]) {
    const double speed = structure.directions.col(trigger).dot(before.head(n)) + before[n + trigger];
    if (speed > 0.0) {
      const Eigen::RowVectorXd earlier = moved(trigger, derivative).transpose() / speed;
      derivative += (rates(after) - before) * earlier;
    }
  }
  admit(dynamics_.mode(after.closed), derivative);
}

void GivingEvents::admit(const ContactMode& of_all, Eigen::MatrixXd& derivative) const {
  const FlowStructure& structure = dynamics_.structure();
  if (structure.relaxing() == 0) return;
  const ContactMode mode = dynamics_.stops().part(of_all, false);
  if (mode.active.empty()) return;
  Eigen::MatrixXd beyond(mode.response.rows(), derivative.cols());
  for (std::size_t i = 0; i < mode.active.size(); ++i)
    beyond.row(static_cast<Eigen::Index>(i)) = moved(mode.active[i], derivative).transpose();
  derivative.middleRows(dynamics_.size(), structure.relaxing()) -=
      product(columns_of(structure.massless_compliance, mode.active), product(mode.response, beyond));
}

// What springs do is felt by none of the others, and they feel displacements alone.
std::vector<bool> GivingEvents::closed_after(const FlowState& flow, int trigger, bool struck) const {
  std::vector<bool> closed = flow.closed;
  if (springs_) reconsider(flow, trigger, false, false, closed);
  if (dynamics_.structure().relaxing() > 0) reconsider(flow, trigger, true, struck, closed);
  return closed;
}

void GivingEvents::reconsider(const FlowState& flow, int trigger, bool relaxing, bool struck,
                              std::vector<bool>& closed) const {
  const FlowStructure& structure = dynamics_.structure();
  const std::vector<bool> before = closed;
  const MotionDerivatives motion = dynamics_.derivatives(dynamics_.mode(before), flow.time, flow.state, 2);
  // Where a relaxing contact closes or velocities have jumped, the forces of all such jump. One that closes
  // is pushed, whatever the others do: G is positive definite.
  const bool jump =
      relaxing &&
      (struck || (trigger >= 0 && structure.relaxes(trigger) && !before[static_cast<std::size_t>(trigger)]));
  const double least_push = relaxing ? of_relaxing_[0].floor : touch_;
  std::vector<bool> undecided(before.size(), false);
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    if (relaxing ? !structure.relaxes(j) : dynamics_.halts(j)) continue;
    if (j == trigger) {
      closed[index] = !before[index];
      continue;
    }
    undecided[index] = before[index] ? jump || -motion.lambda(j, 0) * structure.compliance(j, j) <= least_push
                                     : structure.gaps[j] - motion.x(j, 0) <= touch_;
    closed[index] = before[index] && !undecided[index];
  }
  // Gaps and forces of undecided springs are zero here: their speeds are the first to tell them apart.
  const std::vector<Order> orders =
      relaxing ? of_relaxing_ : std::vector<Order>{of_springs_[1], of_springs_[2]};
  decide(flow.time, flow.state, orders, std::move(undecided), closed);
}

void GivingEvents::resolve(FlowState& flow, int trigger, FlowRecord& record) const {
  const std::vector<bool> before = flow.closed;
  // Rates of springs alone are continuous: nothing jumps, nor do small deviations.
  const bool relaxing = dynamics_.structure().relaxing() > 0, carries = record.tangent && relaxing;
  const Eigen::VectorXd rates_before = carries ? rates(flow) : Eigen::VectorXd();
  flow.closed = closed_after(flow, trigger, false);
  if (relaxing) hold(flow.state, dynamics_.mode(flow.closed));
  log_changes(before, flow.closed, flow.time, record);
  record.sequence.push_back({.kind = change_of(flow.closed, trigger),
                             .contact = trigger,
                             .time = flow.time,
                             .closed = flow.closed});
  if (carries) pass(flow, rates_before, trigger, record.derivative);
}

}  // namespace signorini
