#include <algorithm>

#include "methods/flow/stretch.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

constexpr int kTaylorOrder = 12;
constexpr double kTaylorAngle = 0.3;  // radians of the fastest rate covered: 0.3^13 / 13! is round-off

double local_tolerance(double tolerance) {
  constexpr double kShare = 0.01, kFloor = 1e-13;
  return std::max(kShare * tolerance, kFloor);
}

Eigen::VectorXd absolute_tolerances(const ContactDynamics& dynamics, double tolerance) {
  Eigen::VectorXd result(dynamics.states());
  result.head(dynamics.positions()).setConstant(tolerance * dynamics.scales().displacement);
  result.tail(dynamics.size()).setConstant(tolerance * dynamics.scales().velocity);
  return result;
}

}  // namespace

Guard Stretch::guard_of(const ContactDynamics& dynamics, int contact, bool closed, double value,
                        double rate) {
  if (!closed) return {.value = dynamics.structure().gaps[contact] - value, .rate = -rate};
  const double unit = dynamics.stops().coupling()(contact, contact);
  return {.value = -unit * value, .rate = -unit * rate};
}

void StateStretch::state(double time, State& state) const {
  evaluate(time, y_);
  state = unpacked();
}

State StateStretch::unpacked() const {
  return {.u = y_.head(dynamics_.positions()), .v = y_.tail(dynamics_.size())};
}

Guard StateStretch::guard(int contact, double time) const {
  // A rigid stop's gap needs neither its force nor those of the others.
  if (!dynamics_.rigid(contact) || mode_->closed(contact))
    return guards(time)[static_cast<std::size_t>(contact)];
  evaluate(time, y_);
  const Eigen::Index n = dynamics_.size();
  const FlowStructure& structure = dynamics_.structure();
  const auto w = structure.directions.col(contact);
  return {.value = structure.gaps[contact] - w.dot(y_.head(n)), .rate = -w.dot(y_.tail(n))};
}

std::vector<Guard> StateStretch::guards(double time) const {
  evaluate(time, y_);
  Eigen::VectorXd x, v, force, rate;  // rate: d lambda / dt
  dynamics_.stops().forces(*mode_, time, unpacked(), x, v, force, rate);
  std::vector<Guard> result;
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const bool closed = mode_->closed(j);
    result.push_back(guard_of(dynamics_, j, closed, closed ? force[j] : x[j], closed ? rate[j] : v[j]));
  }
  return result;
}

FlowNode StateStretch::node(double time, const State& state) const {
  const MotionDerivatives motion = dynamics_.derivatives(*mode_, time, state, kNodeOrder + 2);
  return {.time = time, .x = motion.x, .lambda = motion.lambda.leftCols(kNodeOrder)};
}

CvodeStretch::CvodeStretch(const ContactDynamics& dynamics, double tolerance, Multistep multistep)
    : StateStretch(dynamics, event_noise(tolerance)),
      session_(
          local_tolerance(tolerance), absolute_tolerances(dynamics, local_tolerance(tolerance)),
          [this](double time, const Eigen::Ref<const Eigen::VectorXd>& y, Eigen::Ref<Eigen::VectorXd> rate) {
            dynamics_.rate(*mode_, time, y, rate);
          },
          multistep) {}

void CvodeStretch::start(const ContactMode& mode, const FlowState& flow, double end, bool) {
  constexpr double kStepsPerPeriod = 16;
  mode_ = &mode;
  begin_ = end_ = flow.time;
  stop_ = end;
  const FlowStructure& structure = dynamics_.structure();
  first_.resize(dynamics_.states());
  first_ << flow.state.u, flow.state.v;
  stepped_ = false;
  session_.start(flow.time, first_, end,
                 structure.forcing_period / (kStepsPerPeriod * structure.highest_harmonic));
}

void CvodeStretch::step() {
  begin_ = end_;
  end_ = session_.step();
  stepped_ = true;
}

void CvodeStretch::evaluate(double time, Eigen::VectorXd& y) const {
  if (stepped_) {
    session_.interpolate(time, y);
  } else {
    y = first_;
  }
  if (!y.allFinite()) throw FlowError("the motion is no longer finite");
}

// One step and no error but rounding: the guards are known to its noise.
TaylorStretch::TaylorStretch(const ContactDynamics& dynamics, double touch)
    : StateStretch(dynamics, 64.0 * kEpsilon), touch_(touch) {}

// Length of the Taylor step that covers the next rebound of a contact that has just left its stop;
// 0 if there is none short enough. With the acceleration a towards the stop a flight lasts -2 v / a.
double TaylorStretch::short_flight(const FlowState& flow, const MotionDerivatives& motion) const {
  constexpr double kMargin = 1.5;
  const FlowStructure& structure = dynamics_.structure();
  const double longest = kTaylorAngle / structure.fastest_rate;
  double length = 0.0;
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto w = structure.directions.col(j);
    const double gap = structure.gaps[j] - w.dot(flow.state.u.head(w.size()));
    const double v = w.dot(flow.state.v), a = w.dot(motion.u.col(2).head(w.size()));
    if (!dynamics_.rigid(j) || flow.closed[static_cast<std::size_t>(j)] || gap > touch_ || !(v < 0.0) ||
        !(a > 0.0))
      continue;
    const double flight = -2.0 * kMargin * v / a;
    if (flight <= longest && (length == 0.0 || flight < length)) length = flight;
  }
  return length;
}

bool TaylorStretch::applies(const ContactMode& mode, const FlowState& flow) const {
  return short_flight(flow, dynamics_.derivatives(mode, flow.time, flow.state, 2)) > 0.0;
}

void TaylorStretch::start(const ContactMode& mode, const FlowState& flow, double end, bool) {
  mode_ = &mode;
  motion_ = dynamics_.derivatives(mode, flow.time, flow.state, kTaylorOrder + 1);
  begin_ = flow.time;
  end_ = stop_ = std::min(end, begin_ + short_flight(flow, motion_));
}

void TaylorStretch::evaluate(double time, Eigen::VectorXd& y) const {
  const double s = time - begin_;
  const Eigen::Index n = dynamics_.size(), p = dynamics_.positions();
  y.resize(p + n);
  y.head(p) = motion_.u.col(kTaylorOrder);
  y.tail(n) = motion_.u.col(kTaylorOrder + 1).head(n);
  // Horner's scheme for sum_k u^(k) s^k / k!, and for u' with the derivatives one further.
  for (int k = kTaylorOrder; k >= 1; --k) {
    y.head(p) = motion_.u.col(k - 1) + s / k * y.head(p);
    y.tail(n) = motion_.u.col(k).head(n) + s / k * y.tail(n);
  }
}

}  // namespace signorini
