#include "methods/orbit/orbit_guess.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>

#include "methods/discretisation/contact_phases.hpp"
#include "methods/discretisation/periodic_time.hpp"
#include "methods/flow/flow.hpp"
#include "methods/orbit/periodic_closure.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

// What a motion of the scene says of the contacts that act in a model, in its order.
struct ActingMotion {
  const Trajectory& motion;
  std::vector<int> contacts;  // of the scene

  [[nodiscard]] Eigen::MatrixXd x(int count) const { return motion.sample(count).x(Eigen::all, contacts); }
  [[nodiscard]] Eigen::MatrixXd force(int count) const {
    return motion.sample(count).force(Eigen::all, contacts);
  }
  // Of events or impulses those of these contacts.
  template <class OfContact>
  [[nodiscard]] std::vector<OfContact> among(const std::vector<OfContact>& all) const {
    std::vector<OfContact> own;
    for (OfContact one : all) {
      const auto found = std::ranges::find(contacts, one.contact);
      if (found == contacts.end()) continue;
      one.contact = static_cast<int>(found - contacts.begin());
      own.push_back(one);
    }
    return own;
  }
};

// Forces of a period on an equidistant grid, the listed impulses apart.
struct ForceHistory {
  Eigen::MatrixXd force;  // N x Nc
  double step = 0.0;      // [s]
  int reach = 0;          // samples over which an impact may be spread
};

ForceHistory force_history(const ActingMotion& acting) {
  int count = kFineInstants, reach = 0;
  if (const auto nodes = acting.motion.nodes()) {
    count = *nodes;  // a force at a node acts over one step: between the nodes there is nothing to be read
    reach = 3;
  } else if (const auto bandwidth = acting.motion.bandwidth()) {
    count = static_cast<int>(std::bit_ceil(static_cast<unsigned>(8 * std::max(4, *bandwidth))));
    reach = 12;
  }
  return {.force = acting.force(count), .step = acting.motion.period() / count, .reach = reach};
}

// A time during which one contact pushes, as the sequence of an orbit will have it: a phase of contact, or an
// impact. Unlike SampledPhase it has instants, those between two samples.
struct Push {
  int contact = 0;
  double begin = 0.0, end = 0.0, centroid = 0.0;  // [s]; end may reach past the period
  bool lasting = false;
};

// Read off the contact force.
std::vector<Push> pushes_of(const ForceHistory& history, const ContactDynamics& dynamics) {
  constexpr double kRipple = 1e-6;  // of the contact's largest force
  const auto count = static_cast<int>(history.force.rows());
  std::vector<Push> pushes;
  for (int c = 0; c < static_cast<int>(history.force.cols()); ++c) {
    const double threshold = kRipple * history.force.col(c).cwiseAbs().maxCoeff();
    if (threshold == 0.0) continue;
    for (const auto& [first, length] : contact_phases(history.force.col(c), threshold, 1)) {
      if (length == count) {  // never open
        pushes.push_back({c, 0.0, history.step * count, 0.0, true});
        continue;
      }
      double weight = 0.0, moment = 0.0;
      for (int k = first; k < first + length; ++k) {
        weight += history.force(k % count, c);
        moment += history.force(k % count, c) * k;
      }
      pushes.push_back({c, (first - 0.5) * history.step, (first + length - 0.5) * history.step,
                        moment / weight * history.step, !dynamics.rigid(c) || length > history.reach});
    }
  }
  return pushes;
}

// The middle of the longest time free of the given intervals, and its length.
std::pair<double, double> longest_break(std::vector<std::pair<double, double>> busy, double period) {
  if (busy.empty()) return {0.0, 0.0};
  std::sort(busy.begin(), busy.end());
  double reach = busy.front().second, longest = 0.0, middle = 0.0;
  busy.emplace_back(busy.front().first + period, 0.0);
  for (std::size_t i = 1; i < busy.size(); ++i) {
    if (busy[i].first - reach > longest) {
      longest = busy[i].first - reach;
      middle = reach + 0.5 * longest;
    }
    reach = std::max(reach, busy[i].second);
  }
  return {longest, middle};
}

// The middle of the longest time without a push; where contact lasts nearly all the time, of the longest
// between two events.
double quiet_instant(const std::vector<Push>& pushes, double period) {
  constexpr double kTight = 0.02;  // of the period
  std::vector<std::pair<double, double>> spans, edges;
  for (const Push& push : pushes) {
    const double length = push.end - push.begin;
    if (length >= period) continue;  // no instant is free of it, none is an event
    const double begin = wrapped_time(push.begin, period), end = wrapped_time(begin + length, period);
    spans.emplace_back(begin, begin + length);
    edges.emplace_back(begin, begin);
    edges.emplace_back(end, end);
  }
  const auto [length, middle] = longest_break(spans, period);
  const bool quiet = length > kTight * period || spans.empty();
  return wrapped_time(quiet ? middle : longest_break(edges, period).second, period);
}

// The y of (I - Phi(T)) y = d where free motions return by themselves and the equations hold to what a grid
// errs: next to displacements x of the contacts where there is a choice. In units of X and V.
Eigen::VectorXd nearest_closing_state(const FlowStructure& structure, const Eigen::MatrixXd& closing,
                                      const Eigen::VectorXd& d, const Eigen::VectorXd& x) {
  constexpr double kFollow = 1e-3, kNothingElse = 1e-9;  // weights
  const Eigen::Index states = d.size(), contacts = x.size();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * states + contacts, states);
  A.topRows(states) = closing;
  A.block(states, 0, contacts, structure.size()) = kFollow * structure.directions.transpose();
  A.block(states, structure.size(), structure.relaxing(), structure.relaxing())
      .diagonal()
      .setConstant(kFollow);
  A.bottomRows(states).diagonal().setConstant(kNothingElse);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(A.rows());
  b.head(states + contacts) << d, kFollow * x;
  return full_rank_least_squares(A, b);
}

// The structure's periodic state at `time` under load and impulses: y_0 = (I - Phi(T))^-1 times what load and
// impulses of one period make of a structure at rest, for y_0 itself returns as Phi(T) y_0. Where a part
// returns by itself, as one that no spring holds, that of all which is next to the motion of the contacts.
State periodic_state(OrbitModel& model, double time, std::vector<Impulse> impulses,
                     const ActingMotion& acting) {
  const ContactDynamics& dynamics = model.dynamics;
  const int states = dynamics.states();
  const LinearFlow& flow =
      model.flows.of(std::vector<bool>(static_cast<std::size_t>(dynamics.contact_count()), false));
  const std::unique_ptr<LinearArc> arc = flow.arc();
  State end;
  arc->start(time, dynamics.at_rest());
  arc->state(time + model.period, end);
  for (Impulse& impulse : impulses)  // times before the end of the period
    impulse.time = model.period - wrapped_time(impulse.time - time, model.period);
  const State struck = flow.response(impulses);
  Eigen::VectorXd sum(states);
  sum << end.u + struck.u, end.v + struck.v;
  const LuFactors lu(Eigen::MatrixXd::Identity(states, states) - flow.transition(model.period));
  const Eigen::VectorXd y = lu.solve(sum);
  if (y.allFinite() && lu.reciprocal_condition() > 1e-13)
    return {.u = y.head(dynamics.positions()), .v = y.tail(dynamics.size())};
  const Eigen::VectorXd units = state_units(flow, dynamics.scales());
  const Eigen::MatrixXd closing = scaled_closure(flow, units, model.period);
  const int count = acting.motion.nodes().value_or(kFineInstants);
  const long instant = std::lround(wrapped_time(time, model.period) / model.period * count);
  Eigen::VectorXd x = acting.x(count).row(instant % count).transpose();
  if (dynamics.structure().relaxing() == 0) x -= dynamics.structure().shift_at(time, 0);
  const Eigen::VectorXd near = units.cwiseProduct(nearest_closing_state(
      dynamics.structure(), closing, sum.cwiseQuotient(units), x / dynamics.scales().displacement));
  return {.u = near.head(dynamics.positions()), .v = near.tail(dynamics.size())};
}

// The events of the pushes, ordered after the section, with the contacts closed after each.
std::vector<SequenceEvent> events_of(const ContactDynamics& dynamics, const std::vector<Push>& pushes,
                                     FlowState& start, double period) {
  std::vector<SequenceEvent> events;
  const auto after_section = [&](double t) { return start.time + wrapped_time(t - start.time, period); };
  for (const Push& push : pushes) {
    if (!push.lasting) {
      events.push_back({.kind = ContactEvent::Kind::impact,
                        .contact = push.contact,
                        .time = after_section(push.centroid)});
      continue;
    }
    const auto index = static_cast<std::size_t>(push.contact);
    if (push.end - push.begin >= period) {
      start.closed[index] = true;
      continue;
    }
    const double begin = after_section(push.begin), end = after_section(push.end);
    if (end < begin) start.closed[index] = true;
    events.push_back({.kind = ContactEvent::Kind::open, .contact = push.contact, .time = end});
    events.push_back({.kind = ContactEvent::Kind::close, .contact = push.contact, .time = begin});
  }
  std::ranges::stable_sort(events, {}, &SequenceEvent::time);
  std::vector<bool> closed = start.closed;
  for (SequenceEvent& event : events) {
    if (event.kind != ContactEvent::Kind::impact)
      closed[static_cast<std::size_t>(event.contact)] = event.kind == ContactEvent::Kind::close;
    event.closed = closed;
    if (!dynamics.rigid(event.contact) || event.kind == ContactEvent::Kind::open) continue;
    for (int j = 0; j < dynamics.contact_count(); ++j) {  // resting contacts pass an impulse on
      if (!dynamics.rigid(j) || (!closed[static_cast<std::size_t>(j)] && j != event.contact)) continue;
      event.pushed.push_back(j);
      const bool strikes = j == event.contact && event.kind == ContactEvent::Kind::impact;
      event.restitution.push_back(strikes ? dynamics.restitution(j) : 0.0);
    }
  }
  return events;
}

// How long to wait from the section for an instant that is far from all events; 0 if it is one.
double wait_for_quiet(const OrbitGuess& guess, double period) {
  constexpr double kClear = 0.2;  // of the longest time between two events
  const auto& events = guess.events;
  if (events.empty()) return 0.0;
  // The break that the section lies in is the one from the last event to the first of the next period.
  const double before = guess.start.time + period - events.back().time;
  const double after = events.front().time - guess.start.time;
  double longest = before + after, wait = std::fmod(0.5 * (after - before) + period, period);
  for (std::size_t i = 1; i < events.size(); ++i) {
    const double length = events[i].time - events[i - 1].time;
    if (length <= longest) continue;
    longest = length;
    wait = events[i - 1].time + 0.5 * length - guess.start.time;
  }
  return std::min(before, after) > kClear * longest ? 0.0 : wait;
}

// The times that listed events leave no quiet instant in.
std::vector<Push> pushes_of(const std::vector<ContactEvent>& events, double period) {
  std::vector<Push> pushes;
  for (const ContactEvent& event : events) {
    double end = event.time;
    if (event.kind == ContactEvent::Kind::open) continue;
    if (event.kind == ContactEvent::Kind::close) {
      end += period;
      for (const ContactEvent& other : events) {
        if (other.kind != ContactEvent::Kind::open || other.contact != event.contact) continue;
        end = std::min(end, event.time + wrapped_time(other.time - event.time, period));
      }
    }
    pushes.push_back({event.contact, event.time, end, event.time, event.kind != ContactEvent::Kind::impact});
  }
  return pushes;
}

// The contacts with a force at all instants asked for.
std::vector<bool> pushing_throughout(const ActingMotion& acting) {
  constexpr int kInstants = 64;
  std::vector<bool> pushing;
  const Eigen::MatrixXd forces = acting.force(kInstants);
  for (const auto& force : forces.colwise()) pushing.push_back(force.maxCoeff() < 0.0);
  return pushing;
}

std::optional<OrbitGuess> from_events(OrbitModel& model, const ActingMotion& acting, const Expired& expired) {
  const auto listed = acting.motion.events();
  if (!listed) return std::nullopt;
  std::vector<ContactEvent> events = acting.among(*listed);
  if (events.size() > kMostEvents) return std::nullopt;
  const std::vector<bool> pushing = pushing_throughout(acting);
  // Where nothing touches, events do not tell the mean of a part that no spring holds.
  if (events.empty() && !any_closed(pushing)) return std::nullopt;
  const double section = quiet_instant(pushes_of(events, model.period), model.period);
  return listed_sequence(model, std::move(events), section, pushing, expired);
}

std::optional<OrbitGuess> from_force(OrbitModel& model, const ActingMotion& acting) {
  const ForceHistory history = force_history(acting);
  std::vector<Push> pushes = pushes_of(history, model.dynamics);
  std::vector<Impulse> impulses;  // a force on a grid acts as one impulse per step
  for (int c = 0; c < model.dynamics.contact_count(); ++c) {
    for (Eigen::Index k = 0; k < history.force.rows(); ++k) {
      if (history.force(k, c) != 0.0)
        impulses.push_back({.contact = c,
                            .time = static_cast<double>(k) * history.step,
                            .value = history.force(k, c) * history.step});
    }
  }
  for (const Impulse& impulse : acting.among(acting.motion.impulses())) {
    pushes.push_back({impulse.contact, impulse.time, impulse.time, impulse.time, false});
    impulses.push_back(impulse);
  }
  OrbitGuess guess{
      .start = {.time = quiet_instant(pushes, model.period),
                .state = {},
                .closed = std::vector<bool>(static_cast<std::size_t>(model.dynamics.contact_count()), false)},
      .events = {},
      .origin = "the contact force"};
  guess.start.state = periodic_state(model, guess.start.time, std::move(impulses), acting);
  if (!guess.start.state.u.allFinite() || !guess.start.state.v.allFinite()) return std::nullopt;
  guess.events = events_of(model.dynamics, pushes, guess.start, model.period);
  return guess;
}

}  // namespace

std::optional<OrbitGuess> orbit_guess(OrbitModel& model, const Trajectory& motion, const Expired& expired) {
  constexpr double kSamePeriod = 1e-6;
  std::vector<int> contacts = model.dynamics.structure().scene_contacts();
  if (std::abs(motion.period() - model.period) > kSamePeriod * model.period ||
      motion.contact_count() != static_cast<int>(contacts.size()))
    return std::nullopt;
  contacts.resize(static_cast<std::size_t>(model.dynamics.contact_count()));
  const ActingMotion acting{motion, std::move(contacts)};
  if (auto guess = from_events(model, acting, expired)) return guess;
  return from_force(model, acting);
}

std::optional<OrbitGuess> simulated_sequence(OrbitModel& model, const FlowState& start,
                                             const std::function<bool()>& expired, FlowState* end) {
  try {
    EventFlow flow(model.dynamics, 1e-12, expired, Integrator::modal);
    OrbitGuess guess{
        .start = flow.place(start.time, start.state), .events = {}, .origin = "one period's flow"};
    for (int turn = 0;; ++turn) {
      FlowRecord record;
      FlowState last = guess.start;
      flow.advance(last, model.period, record);
      guess.events = std::move(record.sequence);
      const double wait = turn == 0 ? wait_for_quiet(guess, model.period) : 0.0;
      if (wait > 0.0) {
        FlowRecord passed;
        flow.advance(guess.start, wait, passed);
        guess.start.time = wrapped_time(guess.start.time, model.period);
        continue;
      }
      if (end != nullptr) *end = last;
      if (last.closed != guess.start.closed) return std::nullopt;
      return guess;
    }
  } catch (const std::exception&) {  // FlowError and IntegrationError: there is no sequence to follow
    return std::nullopt;
  }
}

}  // namespace signorini
