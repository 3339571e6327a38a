#include "methods/flow/rigid_events.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "methods/flow/impact.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/small_lcp.hpp"

namespace signorini {

// The left side of an event and what the impact law made of it.
struct RigidEvents::Impact {
  std::vector<int> contacts;            // touching
  Eigen::VectorXd approach;             // x'_- of each
  Eigen::VectorXd restitution;          // e of each, 0 where a chatter ends
  Eigen::VectorXd impulse;              // p of each
  std::vector<double> rest_of_chatter;  // [s], of each
  State before;
  Eigen::VectorXd acceleration, jerk;  // u'', u''' on the left side
};

// A hundredth of the integration's tolerance separates events from noise: contacts that close within it
// close together, and it is far below any error that the integration makes.
RigidEvents::RigidEvents(const ContactDynamics& dynamics, double tolerance)
    : dynamics_(dynamics),
      tolerance_(tolerance),
      touch_(std::max(0.01 * tolerance, 64.0 * kEpsilon) * dynamics.scales().displacement),
      rest_(std::max(0.01 * tolerance, 64.0 * kEpsilon) * dynamics.scales().velocity),
      weightless_(std::max(0.01 * tolerance, 1024.0 * kEpsilon) * dynamics.scales().acceleration) {}

std::vector<int> RigidEvents::touching(const FlowState& flow) const {
  const Eigen::VectorXd gap =
      dynamics_.structure().gaps - dynamics_.structure().directions.transpose() * flow.state.u;
  std::vector<int> contacts;
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    if (flow.closed[static_cast<std::size_t>(j)] || gap[j] <= touch_) contacts.push_back(j);
  }
  return contacts;
}

bool RigidEvents::chatter_ends(double v, double a, double jerk) const {
  const MotionScales& scales = dynamics_.scales();
  if (v <= tolerance_ * scales.velocity) return true;
  const double e = dynamics_.restitution();
  if (e == 0.0) return true;
  if (!(a > 0.0) || e == 1.0) return false;
  const double rest = 2.0 * e * v / (a * (1.0 - e));
  if (std::abs(jerk) * rest > 0.5 * a) return false;  // the pressing force may vanish before the limit
  const double displaced = 0.5 * v * rest;
  const double flight_height = 0.5 * e * e * v * v / a;
  return displaced <= 0.1 * tolerance_ * scales.displacement ||
         flight_height <= 1024.0 * kEpsilon * scales.displacement;
}

void RigidEvents::collide(FlowState& flow, Impact& impact) const {
  const auto count = static_cast<Eigen::Index>(impact.contacts.size());
  const double e = dynamics_.restitution();
  impact.restitution = Eigen::VectorXd::Constant(count, e);
  impact.impulse = Eigen::VectorXd::Zero(count);
  impact.rest_of_chatter.assign(impact.contacts.size(), 0.0);
  if (count == 0 || impact.approach.maxCoeff() <= rest_) return;

  for (Eigen::Index i = 0; i < count; ++i) {
    const int j = impact.contacts[static_cast<std::size_t>(i)];
    const double a = dynamics_.structure().directions.col(j).dot(impact.acceleration);
    const double v = impact.approach[i];
    if (v <= 0.0 || !chatter_ends(v, a, dynamics_.structure().directions.col(j).dot(impact.jerk))) continue;
    impact.restitution[i] = 0.0;
    if (e > 0.0 && e < 1.0 && a > 0.0) {
      impact.rest_of_chatter[static_cast<std::size_t>(i)] = 2.0 * e * v / (a * (1.0 - e));
    }
  }
  const auto impulses =
      newton_impulses({.delassus = dynamics_.structure().delassus(impact.contacts, impact.contacts),
                       .approach = impact.approach,
                       .restitution = impact.restitution});
  if (!impulses) throw FlowError("no impulses satisfy the impact law: the stops depend on each other");
  impact.impulse = *impulses;
  flow.state.v += dynamics_.structure().velocity_per_impulse(Eigen::all, impact.contacts) * impact.impulse;
}

// The events of one instant: an impulse belongs to the closing that it ends in, unless the end of a chatter
// comes between them.
void RigidEvents::log(const Impact& impact, const FlowState& before, const std::vector<bool>& closed,
                      FlowRecord& record) const {
  for (std::size_t i = 0; i < impact.contacts.size(); ++i) {
    const int j = impact.contacts[i];
    const bool was = before.closed[static_cast<std::size_t>(j)], is = closed[static_cast<std::size_t>(j)];
    const double impulse = std::min(0.0, impact.impulse[static_cast<Eigen::Index>(i)]);
    const double rest = impact.rest_of_chatter[i];
    const bool closes = is && !was, at_once = closes && rest == 0.0;
    if (impulse < 0.0 && !at_once) {
      record.events.push_back(
          {.kind = ContactEvent::Kind::impact, .contact = j, .time = before.time, .impulse = impulse});
    }
    if (was == is) continue;
    record.events.push_back({.kind = closes ? ContactEvent::Kind::close : ContactEvent::Kind::open,
                             .contact = j,
                             .time = before.time + (closes ? rest : 0.0),
                             .impulse = at_once ? impulse : 0.0});
  }
}

std::vector<bool> RigidEvents::pressed(double time, const State& state,
                                       const std::vector<int>& resting) const {
  std::vector<bool> closed(static_cast<std::size_t>(dynamics_.contact_count()), false);
  if (resting.empty()) return closed;
  const Eigen::MatrixXd G = dynamics_.structure().delassus(resting, resting);
  const Eigen::MatrixXd rows = dynamics_.structure().directions(Eigen::all, resting).transpose();
  const MotionDerivatives free = dynamics_.derivatives(dynamics_.mode(closed), time, state, 2);
  const Eigen::VectorXd q = -(rows * free.u.col(2));
  const auto z = solve_small_lcp(G, q, std::vector<bool>(resting.size(), false));
  if (!z) throw FlowError("no contact forces satisfy the contact law: the stops depend on each other");
  const Eigen::VectorXd w = G * *z + q;

  std::vector<int> involved;
  std::vector<bool> held;
  for (std::size_t i = 0; i < resting.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const bool pushes = (*z)[row] * G(row, row) > weightless_;
    closed[static_cast<std::size_t>(resting[i])] = pushes;
    if (!pushes && w[row] > weightless_) continue;  // it leaves
    involved.push_back(resting[i]);
    held.push_back(pushes);
  }
  if (std::find(held.begin(), held.end(), false) != held.end()) decide(time, state, involved, held, closed);
  return closed;
}

// Contacts whose force is at zero: it grows, or they leave, as the next derivative says.
void RigidEvents::decide(double time, const State& state, const std::vector<int>& involved,
                         const std::vector<bool>& held, std::vector<bool>& closed) const {
  const MotionDerivatives next = dynamics_.derivatives(dynamics_.mode(closed), time, state, 3);
  const Eigen::MatrixXd rows = dynamics_.structure().directions(Eigen::all, involved).transpose();
  const auto growth =
      solve_small_lcp(dynamics_.structure().delassus(involved, involved), -(rows * next.u.col(3)), held);
  if (!growth) throw FlowError("no contact forces satisfy the contact law: the stops depend on each other");
  for (std::size_t i = 0; i < involved.size(); ++i) {
    closed[static_cast<std::size_t>(involved[i])] = held[i] || (*growth)[static_cast<Eigen::Index>(i)] > 0.0;
  }
}

Eigen::MatrixXd RigidEvents::saltation(const Impact& impact, const FlowState& after, const ContactMode& mode,
                                       int trigger) const {
  const int n = dynamics_.size();
  const Eigen::MatrixXd& W = dynamics_.structure().directions;
  const Eigen::MatrixXd& back = dynamics_.structure().velocity_per_impulse;

  // dv+/dv-: the contacts that got an impulse have x'_+ = -e x'_-, resting ones stay at rest.
  std::vector<int> pushed;
  std::vector<double> factor;
  double closing_speed = 0.0;
  for (std::size_t i = 0; i < impact.contacts.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (impact.contacts[i] == trigger) closing_speed = impact.approach[row];
    if (!(impact.impulse[row] < 0.0)) continue;
    pushed.push_back(impact.contacts[i]);
    factor.push_back(impact.approach[row] > rest_ ? 1.0 + impact.restitution[row] : 1.0);
  }
  Eigen::MatrixXd R = Eigen::MatrixXd::Identity(n, n);
  if (!pushed.empty()) {
    const Eigen::MatrixXd G = dynamics_.structure().delassus(pushed, pushed);
    const auto scale = Eigen::VectorXd::Map(factor.data(), static_cast<Eigen::Index>(factor.size()));
    R -= back(Eigen::all, pushed) * G.completeOrthogonalDecomposition().solve(Eigen::MatrixXd(
                                        scale.asDiagonal() * W(Eigen::all, pushed).transpose()));
  }
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  S.topLeftCorner(n, n).setIdentity();
  S.bottomRightCorner(n, n) = R;
  if (!pushed.empty() && closing_speed > rest_) {
    Eigen::VectorXd a(n);
    dynamics_.acceleration(mode, after.time, after.state.u, after.state.v, a);
    const Eigen::RowVectorXd along = W.col(trigger).transpose() / closing_speed;
    S.topLeftCorner(n, n) += (after.state.v - impact.before.v) * along;
    S.bottomLeftCorner(n, n) += (a - R * impact.acceleration) * along;
  }
  if (!mode.active.empty()) {
    const Eigen::MatrixXd hold =
        back(Eigen::all, mode.active) * (mode.response * W(Eigen::all, mode.active).transpose());
    S.topRows(n) -= (hold * S.topRows(n)).eval();
    S.bottomRows(n) -= (hold * S.bottomRows(n)).eval();
  }
  return S;
}

SequenceEvent RigidEvents::entry(const Impact& impact, const FlowState& before,
                                 const std::vector<bool>& closed, int trigger) const {
  const auto index = static_cast<std::size_t>(trigger);
  SequenceEvent event{.contact = trigger, .time = before.time, .closed = closed};
  event.kind = before.closed[index] ? ContactEvent::Kind::open
               : closed[index]      ? ContactEvent::Kind::close
                                    : ContactEvent::Kind::impact;
  for (std::size_t i = 0; i < impact.contacts.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (!(impact.impulse[row] < 0.0)) continue;
    event.pushed.push_back(impact.contacts[i]);
    event.restitution.push_back(impact.approach[row] > rest_ ? impact.restitution[row] : 0.0);
  }
  return event;
}

void RigidEvents::resolve(FlowState& flow, int trigger, FlowRecord& record) const {
  Impact impact;
  impact.contacts = touching(flow);
  if (trigger >= 0 && !std::binary_search(impact.contacts.begin(), impact.contacts.end(), trigger)) {
    impact.contacts.insert(std::upper_bound(impact.contacts.begin(), impact.contacts.end(), trigger),
                           trigger);
  }
  const MotionDerivatives left = dynamics_.derivatives(dynamics_.mode(flow.closed), flow.time, flow.state, 3);
  impact.before = flow.state;
  impact.acceleration = left.u.col(2);
  impact.jerk = left.u.col(3);
  impact.approach = dynamics_.structure().directions(Eigen::all, impact.contacts).transpose() * flow.state.v;
  collide(flow, impact);

  std::vector<int> resting;
  for (const int j : impact.contacts) {
    if (std::abs(dynamics_.structure().directions.col(j).dot(flow.state.v)) <= rest_) resting.push_back(j);
  }
  const std::vector<bool> closed = pressed(flow.time, flow.state, resting);
  const ContactMode mode = dynamics_.mode(closed);
  hold(flow.state, mode);
  log(impact, flow, closed, record);
  if (trigger >= 0) record.sequence.push_back(entry(impact, flow, closed, trigger));
  flow.closed = closed;
  if (record.tangent) record.derivative = saltation(impact, flow, mode, trigger) * record.derivative;
}

FlowState RigidEvents::place(double time, const State& state) const {
  FlowState flow{.time = time,
                 .state = state,
                 .closed = std::vector<bool>(static_cast<std::size_t>(dynamics_.contact_count()), false)};
  FlowRecord ignored;
  expel(flow.state);
  resolve(flow, -1, ignored);
  return flow;
}

void RigidEvents::expel(State& state) const {
  const Eigen::VectorXd gap =
      dynamics_.structure().gaps - dynamics_.structure().directions.transpose() * state.u;
  if (gap.size() == 0 || gap.minCoeff() >= 0.0) return;
  const auto z = solve_small_lcp(dynamics_.structure().delassus, gap,
                                 std::vector<bool>(static_cast<std::size_t>(gap.size()), false));
  if (!z) throw FlowError("no displacement satisfies all gaps");
  state.u -= dynamics_.structure().velocity_per_impulse * *z;
}

void RigidEvents::hold(State& state, const ContactMode& mode) const {
  if (mode.active.empty()) return;
  const Eigen::MatrixXd rows = dynamics_.structure().directions(Eigen::all, mode.active).transpose();
  const Eigen::MatrixXd back =
      dynamics_.structure().velocity_per_impulse(Eigen::all, mode.active) * mode.response;
  state.u -= back * (rows * state.u - dynamics_.structure().gaps(mode.active));
  state.v -= back * (rows * state.v);
}

}  // namespace signorini
