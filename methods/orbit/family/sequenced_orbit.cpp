#include "methods/orbit/family/sequenced_orbit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "methods/orbit/periodic_closure.hpp"

namespace signorini {

State state_of(const Eigen::VectorXd& x, const ContactDynamics& dynamics, const CurveUnits& units) {
  return {.u = units.displacement * x.head(dynamics.positions()),
          .v = units.velocity * x.segment(dynamics.positions(), dynamics.size())};
}

std::vector<PlacedEvent> placed_events(const SequencedOrbit& orbit) {
  std::vector<PlacedEvent> placed;
  for (Eigen::Index i = 0; i < orbit.count(); ++i) placed.emplace_back(orbit.phase(i), orbit.event(i));
  return placed;
}

SequencedOrbit with_events(const SequencedOrbit& orbit, std::vector<PlacedEvent> placed) {
  std::stable_sort(placed.begin(), placed.end(),
                   [](const PlacedEvent& a, const PlacedEvent& b) { return a.first < b.first; });
  SequencedOrbit result = orbit;
  const Eigen::Index states = orbit.states();
  result.events.clear();
  result.x.resize(states + static_cast<Eigen::Index>(placed.size()) + 1);
  result.x.head(states) = orbit.x.head(states);
  Eigen::Index i = states;
  for (PlacedEvent& event : placed) {
    result.x[i++] = event.first;
    result.events.push_back(std::move(event.second));
  }
  result.x[i] = orbit.parameter();
  return result;
}

std::optional<State> contact_free_motion(OrbitModel& model) {
  const ContactDynamics& dynamics = model.dynamics;
  model.period = model.dynamics.structure().forcing_period;
  const LinearFlow& flow =
      model.flows.of(std::vector<bool>(static_cast<std::size_t>(model.dynamics.contact_count()), false));
  const PeriodicClosure closure(flow, model.dynamics.scales(), model.period);
  if (!closure.unique()) return std::nullopt;
  const auto arc = flow.arc();
  State end;
  arc->start(0.0, dynamics.at_rest());
  arc->state(model.period, end);
  Eigen::VectorXd change(dynamics.states());
  change << end.u, end.v;
  const Eigen::VectorXd y = closure.solve(change);
  if (!y.allFinite()) return std::nullopt;
  return State{.u = y.head(dynamics.positions()), .v = y.tail(dynamics.size())};
}

std::optional<SequencedOrbit> contact_free_orbit(OrbitFamily& family, double parameter) {
  const auto model = family.model(parameter);
  const auto motion = contact_free_motion(*model);
  if (!motion) return std::nullopt;
  const auto contacts = static_cast<std::size_t>(model->dynamics.contact_count());
  return sequenced(family,
                   {.start = {.time = 0.0, .state = *motion, .closed = std::vector<bool>(contacts, false)},
                    .events = {},
                    .origin = {}},
                   model->period, model->dynamics.structure().frequency, parameter);
}

SequencedOrbit sequenced(const OrbitFamily& family, const OrbitGuess& orbit, double period, double frequency,
                         double parameter) {
  const CurveUnits& units = family.units();
  const Eigen::Index p = orbit.start.state.u.size(), n = orbit.start.state.v.size();
  const auto count = static_cast<Eigen::Index>(orbit.events.size());
  SequencedOrbit result{.order = std::max(1, static_cast<int>(std::lround(period * frequency / kTwoPi))),
                        .closed = orbit.start.closed,
                        .events = orbit.events,
                        .x = Eigen::VectorXd(p + n + count + 1)};
  result.section =
      std::fmod(std::fmod(orbit.start.time * frequency, result.end()) + result.end(), result.end());
  result.x.head(p) = orbit.start.state.u / units.displacement;
  result.x.segment(p, n) = orbit.start.state.v / units.velocity;
  for (Eigen::Index i = 0; i < count; ++i)
    result.x[p + n + i] = (orbit.events[static_cast<std::size_t>(i)].time - orbit.start.time) * frequency;
  result.x[p + n + count] = parameter / units.parameter;
  return result;
}

double quiet_phase(const SequencedOrbit& orbit) {
  const Eigen::Index m = orbit.count();
  if (m == 0) return 0.0;
  // The section lies in the break from the last event to the first of the next period.
  double longest = orbit.phase(0) + orbit.end() - orbit.phase(m - 1);
  double middle = std::fmod(orbit.phase(m - 1) + 0.5 * longest, orbit.end());
  for (Eigen::Index i = 1; i < m; ++i) {
    const double length = orbit.phase(i) - orbit.phase(i - 1);
    if (length <= longest) continue;
    longest = length;
    middle = orbit.phase(i - 1) + 0.5 * length;
  }
  return middle;
}

double clearance_of_section(const SequencedOrbit& orbit) {
  const Eigen::Index m = orbit.count();
  return m == 0 ? orbit.end() : std::min(orbit.phase(0), orbit.end() - orbit.phase(m - 1));
}

SequencedOrbit with_event(const SequencedOrbit& orbit, Eigen::Index position, PlacedEvent event) {
  std::vector<PlacedEvent> placed = placed_events(orbit);
  placed.insert(placed.begin() + position, std::move(event));
  return with_modes(with_events(orbit, std::move(placed)));
}

SequencedOrbit repeated(const SequencedOrbit& orbit, int times) {
  std::vector<PlacedEvent> placed;
  for (int k = 0; k < times; ++k) {
    for (auto& [phase, event] : placed_events(orbit)) placed.emplace_back(phase + k * orbit.end(), event);
  }
  SequencedOrbit result = orbit;
  result.order *= times;
  return with_events(result, std::move(placed));
}

SequencedOrbit with_more(const SequencedOrbit& orbit, const std::vector<PlacedEvent>& more) {
  std::vector<PlacedEvent> placed = placed_events(orbit);
  placed.insert(placed.end(), more.begin(), more.end());
  return with_modes(with_events(orbit, std::move(placed)));
}

bool closed_before(const SequencedOrbit& orbit, int contact, double phase) {
  const Eigen::Index passed = orbit.passed(phase);
  return (passed == 0 ? orbit.closed : orbit.event(passed - 1).closed)[static_cast<std::size_t>(contact)];
}

SequencedOrbit with_contact_phase(const SequencedOrbit& orbit, int contact, double phase) {
  const bool closed = closed_before(orbit, contact, phase);
  using Kind = ContactEvent::Kind;
  const auto event = [&](bool opens) {
    return PlacedEvent{phase, {.kind = opens ? Kind::open : Kind::close, .contact = contact}};
  };
  return with_more(orbit, {event(closed), event(!closed)});
}

SequencedOrbit with_touch(const SequencedOrbit& orbit, int contact, double phase,
                          const ContactDynamics& dynamics) {
  if (!dynamics.rigid(contact)) return with_contact_phase(orbit, contact, phase);
  SequenceEvent impact{.kind = ContactEvent::Kind::impact, .contact = contact, .pushed = {contact}};
  impact.restitution = {dynamics.restitution(contact)};
  return with_more(orbit, {{phase, impact}});
}

SequencedOrbit with_modes(SequencedOrbit orbit) {
  std::vector<bool> closed = orbit.closed;
  for (SequenceEvent& event : orbit.events) {
    if (event.kind != ContactEvent::Kind::impact)
      closed[static_cast<std::size_t>(event.contact)] = event.kind == ContactEvent::Kind::close;
    event.closed = closed;
  }
  return orbit;
}

SequencedOrbit without_event(const SequencedOrbit& orbit, Eigen::Index i) {
  std::vector<PlacedEvent> placed = placed_events(orbit);
  placed.erase(placed.begin() + i);
  return with_events(orbit, std::move(placed));
}

std::string describe_sequence(const SequencedOrbit& orbit) {
  std::string text = fmt::format("order {}", orbit.order);
  if (orbit.events.empty()) return text + ", no events";
  text += ", events";
  for (const SequenceEvent& event : orbit.events) {
    const char* word = event.kind == ContactEvent::Kind::impact  ? " I"
                       : event.kind == ContactEvent::Kind::close ? " C"
                                                                 : " O";
    text += fmt::format("{}{}", word, event.contact);
  }
  return text;
}

}  // namespace signorini
