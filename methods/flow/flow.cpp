#include "methods/flow/flow.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "methods/linear_flow/linear_flow.hpp"
#include "methods/linear_flow/shared_modes.hpp"
#include "methods/solvers/constants.hpp"
#include "problems/linear_algebra/exponential.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

EventFlow::EventFlow(const ContactDynamics& dynamics, double tolerance, std::function<bool()> expired,
                     Integrator integrator)
    : dynamics_(dynamics),
      integrator_(integrator),
      expired_(std::move(expired)),
      flows_(dynamics, FlowForm::automatic, std::make_shared<SharedModes>()) {
  if (dynamics.rigid()) {
    auto events = std::make_unique<RigidEvents>(dynamics, tolerance);
    rebound_ = std::make_unique<TaylorStretch>(dynamics, events->touch());
    events_ = std::move(events);
  } else {
    events_ = std::make_unique<GivingEvents>(dynamics, tolerance);
  }
  if (integrator == Integrator::modal) {
    between_ = std::make_unique<ClosedFormStretch>(flows_, tolerance);
  } else {
    const bool stiff = integrator == Integrator::cvode && dynamics.structure().stiff;
    const bool bdf = stiff || integrator == Integrator::bdf;
    between_ = std::make_unique<CvodeStretch>(dynamics, tolerance, bdf ? Multistep::bdf : Multistep::adams);
  }
}

FlowState EventFlow::place(double time, const State& state) const { return events_->place(time, state); }

double EventFlow::guard_floor(int contact, double noise) const {
  return noise * (mode_.closed(contact) ? dynamics_.stops().scale(contact) : dynamics_.scales().displacement);
}

// Earliest event of a stretch's last step. `last` holds the guards at its beginning and is left with those at
// its end.
EventFlow::Crossing EventFlow::first_event(const Stretch& stretch, std::vector<bool>& fresh,
                                           std::vector<Guard>& last) const {
  if (fresh.empty()) return {};
  constexpr double kFar = 2.0;  // a guard this many times further from zero than its rates carry it is safe
  Crossing first;
  const std::vector<Guard> next = stretch.guards(stretch.end());
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    const double reach =
        kFar * (stretch.end() - stretch.begin()) * (std::abs(last[index].rate) + std::abs(next[index].rate));
    if (!fresh[index] && std::min(last[index].value, next[index].value) > reach) continue;
    const auto value = [&stretch, j](double time) { return stretch.guard(j, time); };
    // A guard that this contact's own event has left at zero must first rise above its noise.
    const double floor = guard_floor(j, stretch.noise());
    const auto time = first_crossing(
        value, {.begin = stretch.begin(), .end = stretch.end(), .fresh = fresh[index], .floor = floor});
    if (time && (first.contact < 0 || *time < first.time)) first = {.contact = j, .time = *time};
    if (!time && fresh[index]) fresh[index] = next[index].value <= floor;
  }
  last = next;
  return first;
}

// Both forms agree on deviations that the constraint admits; those normal to it the saltation removes.
Eigen::MatrixXd EventFlow::carried(const std::vector<bool>& closed, double duration,
                                   const Eigen::MatrixXd& deviations) {
  if (integrator_ != Integrator::modal) {
    Eigen::MatrixXd moved = product(matrix_exponential(dynamics_.flow_matrix(mode_) * duration), deviations);
    for (int j = 0; j < dynamics_.structure().relaxing(); ++j)
      if (!dynamics_.structure().relaxes(j)) moved.row(dynamics_.size() + j).setZero();
    return moved;
  }
  const LinearFlow& flow = flows_.of(closed);
  if (deviations.cols() >= deviations.rows()) return product(flow.transition(duration), deviations);
  const TransitionFactors factors = flow.transition_factors(duration);
  return product(factors.writing, product(factors.reading, deviations));
}

// From flow.time to the next event, or to where the stretch ends.
void EventFlow::follow(Stretch& stretch, FlowState& flow, double end, FlowRecord& record) {
  constexpr long kStepsPerCheck = 256;
  const double begin = flow.time;
  stretch.start(mode_, flow, end, record.dense);
  std::vector<Guard> last = stretch.guards(begin);
  std::vector<bool> fresh;
  for (int j = 0; j < dynamics_.contact_count(); ++j)
    fresh.push_back(last[static_cast<std::size_t>(j)].value <= guard_floor(j, stretch.noise()));
  if (record.dense) record.nodes.push_back(stretch.node(begin, flow.state));
  Crossing crossing;
  for (long steps = 1;; ++steps) {
    if (steps % kStepsPerCheck == 0 && expired_()) throw FlowError("the time budget is spent");
    stretch.step();
    crossing = first_event(stretch, fresh, last);
    if (crossing.contact >= 0 || stretch.finished()) break;
    if (record.dense) record.nodes.push_back(stretch.node(stretch.end()));
  }
  flow.time = crossing.contact < 0 ? stretch.end() : crossing.time;
  stretch.state(flow.time, flow.state);
  if (!flow.state.u.allFinite() || !flow.state.v.allFinite())
    throw FlowError("the motion is no longer finite");
  events_->hold(flow.state, mode_);
  if (record.tangent) record.derivative = carried(flow.closed, flow.time - begin, record.derivative);
  if (record.dense) record.nodes.push_back(stretch.node(flow.time, flow.state));
  if (crossing.contact >= 0) events_->resolve(flow, crossing.contact, record);
}

void EventFlow::advance(FlowState& flow, double duration, FlowRecord& record) {
  constexpr int kMaxEvents = 20000;
  const double end = flow.time + duration;
  // What is left of the duration by rounding of the time itself is no stretch.
  const double shortest = 16.0 * kEpsilon * (std::abs(end) + duration);
  if (record.tangent && record.derivative.size() == 0) {
    record.derivative = Eigen::MatrixXd::Identity(dynamics_.states(), dynamics_.states());
  }
  for (int events = 0; end - flow.time > shortest; ++events) {
    if (events > kMaxEvents)
      throw FlowError("more than " + std::to_string(kMaxEvents) + " events in one forcing period");
    if (expired_()) throw FlowError("the time budget is spent");
    mode_ = dynamics_.mode(flow.closed);
    const bool rebounds = rebound_ && rebound_->applies(mode_, flow);
    follow(rebounds ? *rebound_ : *between_, flow, end, record);
  }
  flow.time = end;
}

}  // namespace signorini
