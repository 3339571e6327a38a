#include "methods/flow/flow.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/flow/matrix_exponential.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

constexpr int kNodeOrder = 5;           // highest derivative of x kept at an instant; of lambda one less
constexpr int kTaylorOrder = 12;        // of a short flight
constexpr double kTaylorAngle = 0.3;    // its length in radians of the fastest rate: 0.3^13/13! is round-off
constexpr double kStepsPerPeriod = 16;  // of the highest load harmonic, at least: one extremum per half step
constexpr int kMaxEvents = 20000;       // per call

Eigen::VectorXd packed(const State& state) {
  Eigen::VectorXd y(2 * state.u.size());
  y << state.u, state.v;
  return y;
}

State unpacked(const Eigen::VectorXd& y) {
  const Eigen::Index n = y.size() / 2;
  return {.u = y.head(n), .v = y.tail(n)};
}

// Local tolerance of CVODE. Its global error over some periods is 5 to 1000 times the local one (measured
// against closed forms, the more the tighter), so that with this share `tolerance` is about the error of
// the motion. Below the floor CVODE only adds round-off.
double local_tolerance(double tolerance) {
  constexpr double kShare = 0.01, kFloor = 1e-13;
  return std::max(kShare * tolerance, kFloor);
}

Eigen::VectorXd absolute_tolerances(const ContactDynamics& dynamics, double tolerance) {
  Eigen::VectorXd result(2 * dynamics.size());
  result.head(dynamics.size()).setConstant(tolerance * dynamics.scales().displacement);
  result.tail(dynamics.size()).setConstant(tolerance * dynamics.scales().velocity);
  return result;
}

}  // namespace

EventFlow::EventFlow(const ContactDynamics& dynamics, double tolerance, std::function<bool()> expired,
                     Integrator integrator)
    : dynamics_(dynamics),
      tolerance_(tolerance),
      expired_(std::move(expired)),
      rigid_events_(dynamics, tolerance),
      compliant_events_(dynamics, tolerance),
      flows_(dynamics) {
  if (integrator == Integrator::modal) return;
  session_ = std::make_unique<CvodeSession>(
      local_tolerance(tolerance), absolute_tolerances(dynamics, local_tolerance(tolerance)),
      [this](double time, const Eigen::Ref<const Eigen::VectorXd>& y, Eigen::Ref<Eigen::VectorXd> rate) {
        const Eigen::Index n = y.size() / 2;
        rate.head(n) = y.tail(n);
        dynamics_.acceleration(mode_, time, y.head(n), y.tail(n), rate.tail(n));
      });
}

FlowState EventFlow::place(double time, const State& state) const {
  FlowState flow{.time = time,
                 .state = state,
                 .closed = std::vector<bool>(static_cast<std::size_t>(dynamics_.contact_count()), false)};
  if (dynamics_.rigid()) {
    FlowRecord ignored;
    rigid_events_.expel(flow.state);
    rigid_events_.resolve(flow, -1, ignored);
  } else {
    flow.closed = compliant_events_.pushing(time, state);
  }
  return flow;
}

Guard EventFlow::guard(int contact, double time, const Eigen::VectorXd& y) const {
  if (!dynamics_.rigid() || mode_.closed(contact)) return guards(time, y)[static_cast<std::size_t>(contact)];
  const Eigen::Index n = y.size() / 2;
  const auto w = dynamics_.directions().col(contact);
  return {.value = dynamics_.gaps()[contact] - w.dot(y.head(n)), .rate = -w.dot(y.tail(n))};
}

double EventFlow::guard_floor(int contact, double noise) const {
  const MotionScales& scales = dynamics_.scales();
  return noise * (mode_.closed(contact) && dynamics_.rigid() ? scales.acceleration : scales.displacement);
}

std::vector<Guard> EventFlow::guards(double time, const Eigen::VectorXd& y) const {
  const Eigen::Index n = y.size() / 2;
  const int contacts = dynamics_.contact_count();
  Eigen::VectorXd x = dynamics_.unloaded(time, y.head(n), 0), v = dynamics_.unloaded(time, y.tail(n), 1);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(contacts), rate = force;  // lambda, d lambda / dt
  if (!mode_.active.empty() && dynamics_.rigid()) {
    const MotionDerivatives motion = dynamics_.derivatives(mode_, time, unpacked(y), 3);
    force = motion.lambda.col(0);
    rate = motion.lambda.col(1);
  } else if (!mode_.active.empty()) {
    force = dynamics_.compliant_force(mode_, x, 0);
    rate = dynamics_.compliant_force(mode_, v, 1);
    x += dynamics_.massless_compliance() * force;
    v += dynamics_.massless_compliance() * rate;
  }
  const auto unit = (dynamics_.rigid() ? dynamics_.delassus() : dynamics_.compliance()).diagonal();
  std::vector<Guard> result(static_cast<std::size_t>(contacts));
  for (int j = 0; j < contacts; ++j) {
    result[static_cast<std::size_t>(j)] = {.value = dynamics_.gaps()[j] - x[j], .rate = -v[j]};
  }
  for (const int j : mode_.active) {
    result[static_cast<std::size_t>(j)] = {.value = -unit[j] * force[j], .rate = -unit[j] * rate[j]};
  }
  return result;
}

std::vector<bool> EventFlow::fresh_guards(const std::vector<Guard>& guards, double noise) const {
  std::vector<bool> fresh(guards.size());
  for (std::size_t j = 0; j < guards.size(); ++j) {
    fresh[j] = guards[j].value <= guard_floor(static_cast<int>(j), noise);
  }
  return fresh;
}

// Earliest event of a stretch. `last` holds the guards at its beginning and is left with those at its end.
EventFlow::Crossing EventFlow::first_event(const Stretch& stretch, std::vector<bool>& fresh,
                                           std::vector<Guard>& last) const {
  if (fresh.empty()) return {};
  constexpr double kFar = 2.0;  // a guard this many times further from zero than its rates carry it is safe
  Crossing first;
  const std::vector<Guard> next = stretch.guards(stretch.end);
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    const double reach =
        kFar * (stretch.end - stretch.begin) * (std::abs(last[index].rate) + std::abs(next[index].rate));
    if (!fresh[index] && std::min(last[index].value, next[index].value) > reach) continue;
    const auto value = [&stretch, j](double time) { return stretch.guard(j, time); };
    const double floor = guard_floor(j, stretch.noise);
    const auto time = first_crossing(
        value, {.begin = stretch.begin, .end = stretch.end, .fresh = fresh[index], .floor = floor});
    if (time && (first.contact < 0 || *time < first.time)) first = {.contact = j, .time = *time};
    if (!time && fresh[index]) fresh[index] = next[index].value <= floor;
  }
  last = next;
  return first;
}

void EventFlow::keep(double time, const Eigen::VectorXd& y, FlowRecord& record) const {
  const MotionDerivatives motion = dynamics_.derivatives(mode_, time, unpacked(y), kNodeOrder + 2);
  record.pieces.back().push_back({.time = time, .x = motion.x, .lambda = motion.lambda.leftCols(kNodeOrder)});
}

// Both forms agree on deviations that the constraint admits; those normal to it the saltation removes.
Eigen::MatrixXd EventFlow::transition(const std::vector<bool>& closed, double duration) {
  if (!session_) return flows_.of(closed).transition(duration);
  return matrix_exponential(dynamics_.flow_matrix(mode_) * duration);
}

// Ends a stretch in one mode that began at `since`.
void EventFlow::arrive(FlowState& flow, double time, const Eigen::VectorXd& y, double since,
                       FlowRecord& record) {
  flow.time = time;
  flow.state = unpacked(y);
  if (dynamics_.rigid()) rigid_events_.hold(flow.state, mode_);
  if (record.tangent) {
    record.derivative = transition(flow.closed, time - since) * record.derivative;
  }
}

void EventFlow::pass_event(FlowState& flow, const Crossing& crossing, FlowRecord& record) const {
  if (dynamics_.rigid()) {
    rigid_events_.resolve(flow, crossing.contact, record);
  } else {
    compliant_events_.resolve(flow, crossing.contact, record);
  }
}

// Length of the Taylor step that covers the next rebound of a contact that has just left its stop;
// 0 if there is none short enough.
double EventFlow::short_flight(const FlowState& flow, const MotionDerivatives& motion) const {
  constexpr double kMargin = 1.5;
  const double longest = kTaylorAngle / dynamics_.fastest_rate();
  double length = 0.0;
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto w = dynamics_.directions().col(j);
    const double gap = dynamics_.gaps()[j] - w.dot(flow.state.u);
    const double v = w.dot(flow.state.v), a = w.dot(motion.u.col(2));
    if (flow.closed[static_cast<std::size_t>(j)] || gap > rigid_events_.touch() || !(v < 0.0) || !(a > 0.0))
      continue;
    const double flight = -2.0 * kMargin * v / a;
    if (flight <= longest && (length == 0.0 || flight < length)) length = flight;
  }
  return length;
}

bool EventFlow::take_short_flight(FlowState& flow, double end, FlowRecord& record) {
  if (!dynamics_.rigid()) return false;
  if (short_flight(flow, dynamics_.derivatives(mode_, flow.time, flow.state, 2)) == 0.0) return false;
  const MotionDerivatives motion = dynamics_.derivatives(mode_, flow.time, flow.state, kTaylorOrder + 1);
  const double begin = flow.time;
  const Eigen::Index n = dynamics_.size();
  const auto series = [&](double time, Eigen::VectorXd& y) {
    const double s = time - begin;
    y.resize(2 * n);
    y.head(n) = motion.u.col(kTaylorOrder);
    y.tail(n) = motion.u.col(kTaylorOrder + 1);
    for (int k = kTaylorOrder; k >= 1; --k) {
      y.head(n) = motion.u.col(k - 1) + s / k * y.head(n);
      y.tail(n) = motion.u.col(k) + s / k * y.tail(n);
    }
  };
  Eigen::VectorXd y;
  const Stretch stretch{.begin = begin,
                        .end = std::min(end, begin + short_flight(flow, motion)),
                        .noise = 64.0 * kEpsilon,
                        .guard =
                            [&](int contact, double time) {
                              series(time, y);
                              return guard(contact, time, y);
                            },
                        .guards =
                            [&](double time) {
                              series(time, y);
                              return guards(time, y);
                            }};
  std::vector<Guard> last = guards(begin, packed(flow.state));
  std::vector<bool> fresh = fresh_guards(last, stretch.noise);
  const Crossing crossing = first_event(stretch, fresh, last);
  if (record.dense) {
    record.pieces.emplace_back();
    keep(begin, packed(flow.state), record);
  }
  const double time = crossing.contact < 0 ? stretch.end : crossing.time;
  series(time, y);
  arrive(flow, time, y, begin, record);
  if (record.dense) keep(time, packed(flow.state), record);
  if (crossing.contact >= 0) pass_event(flow, crossing, record);
  return true;
}

void EventFlow::integrate(FlowState& flow, double end, FlowRecord& record) {
  const double begin = flow.time;
  const double noise = std::max(0.01 * tolerance_, 64.0 * kEpsilon);
  Eigen::VectorXd y = packed(flow.state);
  std::vector<Guard> last = guards(begin, y);
  std::vector<bool> fresh = fresh_guards(last, noise);
  if (record.dense) {
    record.pieces.emplace_back();
    keep(begin, y, record);
  }
  session_->start(begin, y, end,
                  dynamics_.forcing_period() / (kStepsPerPeriod * dynamics_.highest_harmonic()));
  for (long steps = 1;; ++steps) {
    if (steps % 256 == 0 && expired_()) throw FlowError("the time budget is spent");
    session_->step();
    const Stretch stretch{.begin = session_->previous_time(),
                          .end = session_->time(),
                          .noise = noise,
                          .guard =
                              [&](int contact, double time) {
                                session_->interpolate(time, y);
                                return guard(contact, time, y);
                              },
                          .guards =
                              [&](double time) {
                                session_->interpolate(time, y);
                                return guards(time, y);
                              }};
    const Crossing crossing = first_event(stretch, fresh, last);
    const bool finished = stretch.end >= end;
    const double time = crossing.contact < 0 ? stretch.end : crossing.time;
    session_->interpolate(time, y);
    if (!y.allFinite()) throw FlowError("the motion is no longer finite");
    if (crossing.contact < 0 && !finished) {
      if (record.dense) keep(time, y, record);
      continue;
    }
    arrive(flow, time, y, begin, record);
    if (record.dense) keep(time, packed(flow.state), record);
    if (crossing.contact >= 0) pass_event(flow, crossing, record);
    return;
  }
}

Guard EventFlow::exact_guard(int contact, double time) const {
  if (mode_.closed(contact)) {
    const double unit = (dynamics_.rigid() ? dynamics_.delassus() : dynamics_.compliance())(contact, contact);
    return {.value = -unit * arc_.force(contact, time), .rate = -unit * arc_.force(contact, time, 1)};
  }
  return {.value = dynamics_.gaps()[contact] - arc_.displacement(contact, time),
          .rate = -arc_.displacement(contact, time, 1)};
}

void EventFlow::keep_exact(double time, FlowRecord& record) const {
  const int contacts = dynamics_.contact_count();
  FlowNode node{.time = time,
                .x = Eigen::MatrixXd(contacts, kNodeOrder + 1),
                .lambda = Eigen::MatrixXd(contacts, kNodeOrder)};
  for (int j = 0; j < contacts; ++j) {
    for (int order = 0; order <= kNodeOrder; ++order) node.x(j, order) = arc_.displacement(j, time, order);
    for (int order = 0; order < kNodeOrder; ++order) node.lambda(j, order) = arc_.force(j, time, order);
  }
  record.pieces.back().push_back(std::move(node));
}

// As `integrate`, by the closed form of the motion: in steps of a fraction of the fastest period left in the
// guards, and in what is kept of the motion. Modes below the noise of the guards bound no step.
void EventFlow::follow(FlowState& flow, double end, FlowRecord& record) {
  constexpr double kSteps = 8.0, kDenseSteps = 16.0;  // per fastest period
  const double begin = flow.time;
  const double noise = std::max(0.01 * tolerance_, 64.0 * kEpsilon);
  arc_.start(flows_.of(flow.closed), begin, flow.state);
  const auto exact_guards = [this](double time) {
    std::vector<Guard> all;
    for (int j = 0; j < dynamics_.contact_count(); ++j) all.push_back(exact_guard(j, time));
    return all;
  };
  std::vector<Guard> last = exact_guards(begin);
  std::vector<bool> fresh = fresh_guards(last, noise);
  const double angle = 2.0 * std::numbers::pi / (record.dense ? kDenseSteps : kSteps);
  const double longest = angle / (dynamics_.highest_harmonic() * dynamics_.frequency());
  const std::vector<FadingRate> terms =
      record.dense ? arc_.fading_rates(noise, longest, kNodeOrder) : arc_.fading_rates(noise);
  if (record.dense) {
    record.pieces.emplace_back();
    keep_exact(begin, record);
  }
  Stretch stretch{.begin = begin,
                  .end = begin,
                  .noise = noise,
                  .guard = [this](int contact, double time) { return exact_guard(contact, time); },
                  .guards = exact_guards};
  Crossing crossing;
  double time = begin;
  for (long step = 1; stretch.end < end && crossing.contact < 0; ++step) {
    if (step % 256 == 0 && expired_()) throw FlowError("the time budget is spent");
    stretch.begin = stretch.end;
    stretch.end = std::min(end, stretch.begin + angle / fastest_left(terms, stretch.begin));
    crossing = first_event(stretch, fresh, last);
    time = crossing.contact < 0 ? stretch.end : crossing.time;
    if (record.dense && crossing.contact < 0 && stretch.end < end) keep_exact(time, record);
  }
  State state;
  arc_.state(time, state);
  const Eigen::VectorXd y = packed(state);
  if (!y.allFinite()) throw FlowError("the motion is no longer finite");
  if (record.dense) keep_exact(time, record);
  arrive(flow, time, y, begin, record);
  if (crossing.contact >= 0) pass_event(flow, crossing, record);
}

void EventFlow::advance(FlowState& flow, double duration, FlowRecord& record) {
  const double end = flow.time + duration;
  const double shortest = 16.0 * kEpsilon * (std::abs(end) + duration);
  if (record.tangent && record.derivative.size() == 0) {
    record.derivative = Eigen::MatrixXd::Identity(2 * dynamics_.size(), 2 * dynamics_.size());
  }
  for (int events = 0; end - flow.time > shortest; ++events) {
    if (events > kMaxEvents)
      throw FlowError("more than " + std::to_string(kMaxEvents) + " events in one forcing period");
    if (expired_()) throw FlowError("the time budget is spent");
    mode_ = dynamics_.mode(flow.closed);
    if (take_short_flight(flow, end, record)) continue;
    session_ ? integrate(flow, end, record) : follow(flow, end, record);
  }
  flow.time = end;
}

}  // namespace signorini
