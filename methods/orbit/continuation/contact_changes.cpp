#include "methods/orbit/continuation/contact_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/flow/impact_groups.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "methods/orbit/family/chatter.hpp"
#include "methods/orbit/family/orbit_section.hpp"

namespace signorini {

namespace {

const SequenceEvent& event_of(const SequencedOrbit& orbit, Eigen::Index i) {
  return orbit.events[static_cast<std::size_t>(i)];
}

// The start with its section moved away from all events, or an obstacle.
ChangeOfSequence begin_at(OrbitFamily& family, const SequencedOrbit& orbit, const OrbitQuantity& quantity,
                          const std::string& origin) {
  const auto quiet = with_quiet_section(family, orbit);
  auto start = quiet ? start_where_grows(family, *quiet, quantity, origin) : std::nullopt;
  if (!start) return {.obstacle = "the orbit cannot be evaluated"};
  return {.start = std::move(start)};
}

// The shortest time between two events of one contact that follow each other.
double shortest_phase(const ExtendedEquations& equations, int contact) {
  const SequencedOrbit& orbit = equations.orbit();
  double shortest = orbit.end();
  for (Eigen::Index i = 1; i < orbit.count(); ++i) {
    if (event_of(orbit, i).contact == contact && event_of(orbit, i - 1).contact == contact)
      shortest = std::min(shortest, orbit.phase(i) - orbit.phase(i - 1));
  }
  return shortest;
}

// The guard of a kind at the first event of a contact that has it.
double guard_of_event(const ExtendedEquations& at, GuardKind kind, int contact) {
  for (const OrbitGuard& guard : event_guards(at)) {
    if (guard.kind == kind && event_of(at.orbit(), guard.index).contact == contact) return guard.value;
  }
  return std::nan("");
}

// The later of event i and that of its contact before or behind it, whichever is nearer; empty where others
// lie between them.
std::optional<Eigen::Index> nearer_event(const SequencedOrbit& orbit, Eigen::Index i) {
  const auto gap = [&](Eigen::Index later) {
    const bool pair = later > 0 && later < orbit.count() &&
                      event_of(orbit, later).contact == event_of(orbit, later - 1).contact;
    return pair ? orbit.phase(later) - orbit.phase(later - 1) : orbit.end();
  };
  const Eigen::Index nearer = gap(i) < gap(i + 1) ? i : i + 1;
  return gap(nearer) < orbit.end() ? std::optional(nearer) : std::nullopt;
}

ChangeOfSequence begin_phase(OrbitFamily& family, const SequencedOrbit& orbit, const OrbitGuard& guard,
                             bool rigid) {
  constexpr double kBrief = 1e-3;  // a fold or a doubling can lie next to the beginning
  const int contact = guard.index;
  SequencedOrbit with_phase = with_contact_phase(orbit, contact, guard.phase);
  for (SequenceEvent& event : with_phase.events) {
    if (!rigid || event.contact != contact || event.kind != ContactEvent::Kind::close ||
        !event.pushed.empty())
      continue;
    event.pushed = {contact};  // a rigid stop takes the speed of what comes to rest on it
    event.restitution = {0.0};
  }
  ChangeOfSequence change = begin_at(
      family, with_phase, [contact](const ExtendedEquations& at) { return shortest_phase(at, contact); },
      fmt::format("contact {} starts pressing, or opens for a moment", contact));
  if (change.start) change.start->first_step_share = kBrief;
  return change;
}

// Of free motions before compliant stops: a phase of contact, or its interruption, at every instant at which
// a contact touches its stop, or lets go, of symmetric motions several. The motion is unique, and all grow.
ChangeOfSequence begin_phases(OrbitFamily& family, const SequencedOrbit& orbit,
                              const ExtendedEquations& equations) {
  constexpr double kTouches = 1e-9, kBrief = 1e-3;
  SequencedOrbit with_phases = orbit;
  for (const GuardMaximum& maximum : survey(equations).maxima) {
    const OrbitGuard& guard = maximum.guard;
    const bool touch = guard.kind == GuardKind::clearance || guard.kind == GuardKind::pressure;
    if (touch && guard.value < kTouches && !equations.model().dynamics.rigid(guard.index))
      with_phases = with_contact_phase(with_phases, guard.index, guard.phase);
  }
  const auto quiet = with_quiet_section(family, with_phases);
  auto start =
      quiet ? start_growing(family, *quiet, "contacts start pressing, or open for a moment") : std::nullopt;
  if (!start) return {.obstacle = "how the motion goes on is not told"};
  start->first_step_share = kBrief;
  return {.start = std::move(start)};
}

// A closing of no force, e = 0: an impact before it, after which the contact flies for no time.
ChangeOfSequence begin_flight(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index closing) {
  std::vector<PlacedEvent> placed = placed_events(orbit);
  PlacedEvent impact = placed[static_cast<std::size_t>(closing)];
  impact.second.kind = ContactEvent::Kind::impact;
  placed.insert(placed.begin() + closing, impact);
  const int contact = impact.second.contact;
  return begin_at(
      family, with_modes(with_events(orbit, std::move(placed))),
      [contact](const ExtendedEquations& at) { return shortest_phase(at, contact); },
      fmt::format("contact {} closes after a short flight", contact));
}

// From before the impact of another contact to after it, of the shortest phase of a contact that an impact
// alone lies in.
double shortest_around(const ExtendedEquations& equations, int contact) {
  const SequencedOrbit& orbit = equations.orbit();
  double shortest = orbit.end();
  for (Eigen::Index i = 1; i + 1 < orbit.count(); ++i) {
    if (event_of(orbit, i).contact != contact && event_of(orbit, i - 1).contact == contact &&
        event_of(orbit, i + 1).contact == contact)
      shortest = std::min(shortest, orbit.phase(i + 1) - orbit.phase(i - 1));
  }
  return shortest;
}

// A spring is reached, or lets go, at the impact of another contact, which turns its contact back: its force
// has no jump there, and the motion goes on with a phase of contact, or a break of one, around the impact.
ChangeOfSequence begin_around(OrbitFamily& family, const SequencedOrbit& orbit, const OrbitGuard& guard) {
  const int contact = guard.index;
  std::vector<PlacedEvent> placed = placed_events(orbit);
  const auto impact = std::ranges::find(placed, guard.phase, &PlacedEvent::first);
  if (impact == placed.end()) return {.obstacle = "the impact is not found"};
  const bool closed = closed_before(orbit, contact, guard.phase);
  using Kind = ContactEvent::Kind;
  const auto event = [&](bool opens) {
    return PlacedEvent{guard.phase,
                       SequenceEvent{.kind = opens ? Kind::open : Kind::close, .contact = contact}};
  };
  placed.insert(placed.insert(impact, event(closed)) + 2, event(!closed));
  return begin_at(
      family, with_modes(with_events(orbit, std::move(placed))),
      [contact](const ExtendedEquations& at) { return shortest_around(at, contact); },
      fmt::format("contact {} presses, or opens, around the impact of another", contact));
}

// The event of a contact before an impact of another one, of which events i - 1 and i are two, where its next
// one follows the impact at once; else empty.
std::optional<Eigen::Index> around_impact(const SequencedOrbit& orbit, Eigen::Index i) {
  constexpr double kNone = 1e-6;  // rad
  for (const Eigen::Index impact : {i - 1, i}) {
    if (impact == 0 || impact + 1 >= orbit.count() || event_of(orbit, impact).pushed.empty()) continue;
    if (event_of(orbit, impact - 1).contact == event_of(orbit, impact + 1).contact &&
        orbit.phase(impact + 1) - orbit.phase(impact - 1) < kNone)
      return impact - 1;
  }
  return std::nullopt;
}

// The phase that began so has ended; its events are `first` and the one after the impact.
ChangeOfSequence end_around(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index first) {
  const int contact = event_of(orbit, first).contact;
  return begin_at(
      family, with_modes(without_event(without_event(orbit, first + 2), first)),
      [contact](const ExtendedEquations& at) {
        const OrbitSurvey found = survey(at);
        const OrbitGuard* guard = found.find(GuardKind::corner, contact);
        return guard == nullptr ? std::nan("") : guard->value;
      },
      fmt::format("contact {} stops pressing, or no longer opens, around the impact of another", contact));
}

// The flight between the impact before a closing and the closing has ended.
ChangeOfSequence end_flight(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index closing) {
  const int contact = event_of(orbit, closing).contact;
  return begin_at(
      family, without_event(orbit, closing - 1),
      [contact](const ExtendedEquations& at) { return guard_of_event(at, GuardKind::landing, contact); },
      fmt::format("contact {} closes at once", contact));
}

// The orbit without the phases of contact, or their interruptions, that have no length: of a symmetric motion
// several end at once.
SequencedOrbit without_brief_phases(SequencedOrbit orbit) {
  constexpr double kNone = 1e-6;  // rad
  for (Eigen::Index i = orbit.count() - 1; i > 0; --i) {
    const bool one = event_of(orbit, i).contact == event_of(orbit, i - 1).contact;
    if (!one || orbit.phase(i) - orbit.phase(i - 1) > kNone) continue;
    orbit = without_event(without_event(orbit, i), i - 1);
    --i;
  }
  return orbit;
}

// Events i - 1 and i of one contact have met.
ChangeOfSequence end_phase(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i) {
  const int contact = event_of(orbit, i).contact;
  const GuardKind kind =
      event_of(orbit, i).kind == ContactEvent::Kind::open ? GuardKind::clearance : GuardKind::pressure;
  SequencedOrbit without = without_event(without_event(orbit, i), i - 1);
  if (!family.driven()) without = without_brief_phases(std::move(without));
  if (!family.driven() && without.events.empty()) return {.obstacle = std::string(kLinearMode)};
  ExtendedEquations equations(family, without);
  if (!equations.evaluate(without.x)) return {.obstacle = "the orbit cannot be evaluated"};
  return begin_at(
      family, of_least_period(without, equations),
      [contact, kind](const ExtendedEquations& at) {
        const OrbitSurvey found = survey(at);
        const OrbitGuard* guard = found.find(kind, contact);
        return guard == nullptr ? std::nan("") : guard->value;
      },
      fmt::format("contact {} stops pressing, or no longer opens for a moment", contact));
}

// Events i - 1 and i of two contacts have met; with them, of a motion with a symmetry, other pairs.
ChangeOfSequence exchange(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i) {
  constexpr double kTogether = 1e-9;  // rad: pairs that a symmetry makes meet do so to rounding
  SequencedOrbit exchanged = orbit;
  for (Eigen::Index k = 1; k < orbit.count(); ++k) {
    const auto later = static_cast<std::size_t>(k);
    const bool meet = std::abs(orbit.phase(k) - orbit.phase(k - 1)) < kTogether &&
                      event_of(orbit, k).contact != event_of(orbit, k - 1).contact;
    if (k != i && !meet) continue;
    std::swap(exchanged.events[later - 1], exchanged.events[later]);
    ++k;  // three at one instant are no pairs
  }
  auto start = start_where_grows(
      family, with_modes(std::move(exchanged)),
      [i](const ExtendedEquations& at) { return at.orbit().phase(i) - at.orbit().phase(i - 1); },
      "events of two contacts exchanged");
  if (!start) return {.obstacle = "the orbit cannot be evaluated"};
  start->exchanges = true;
  return {.start = std::move(start)};
}

// An impact without restitution after which the contact stays where it is: a phase of length 0 of the same
// motion, the acceleration after the impact being 0.
ChangeOfSequence begin_to_stick(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i) {
  SequencedOrbit sticking = orbit;
  SequenceEvent& impact = sticking.events[static_cast<std::size_t>(i)];
  impact.kind = ContactEvent::Kind::close;
  const int contact = impact.contact;
  std::vector<PlacedEvent> placed = placed_events(sticking);
  placed.insert(placed.begin() + i + 1,
                {orbit.phase(i), SequenceEvent{.kind = ContactEvent::Kind::open, .contact = contact}});
  return begin_at(
      family, with_modes(with_events(sticking, std::move(placed))),
      [contact](const ExtendedEquations& at) { return shortest_phase(at, contact); },
      fmt::format("contact {} begins to stick", contact));
}

ChangeOfSequence cease_to_stick(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i) {
  SequencedOrbit without = without_event(orbit, i);
  without.events[static_cast<std::size_t>(i - 1)].kind = ContactEvent::Kind::impact;
  const int contact = event_of(orbit, i).contact;
  return begin_at(
      family, with_modes(std::move(without)),
      [contact](const ExtendedEquations& at) { return guard_of_event(at, GuardKind::release, contact); },
      fmt::format("contact {} sticks no more", contact));
}

// After an impact the contact rests, with no chatter between.
bool keeps_no_speed(const ContactDynamics& dynamics, int contact) {
  return dynamics.restitution(contact) == 0.0;
}

// The event after i where it is of the same contact, of a kind, and at no distance; else empty.
std::optional<Eigen::Index> followed_at_once(const SequencedOrbit& orbit, Eigen::Index i,
                                             ContactEvent::Kind kind) {
  constexpr double kNone = 1e-6;  // rad
  const bool follows = i + 1 < orbit.count() &&
                       event_of(orbit, i + 1).contact == event_of(orbit, i).contact &&
                       event_of(orbit, i + 1).kind == kind && orbit.phase(i + 1) - orbit.phase(i) < kNone;
  return follows ? std::optional(i + 1) : std::nullopt;
}

// Events i - 1 and i coincide.
ChangeOfSequence past_coincidence(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i,
                                  const ContactDynamics& dynamics) {
  const SequenceEvent &a = event_of(orbit, i - 1), &b = event_of(orbit, i);
  const bool one = a.contact == b.contact;
  if (one && !dynamics.rigid(b.contact)) return end_phase(family, orbit, i);
  if (!one && dynamics.halts(a.contact) != dynamics.halts(b.contact)) {
    const auto first = around_impact(orbit, i);
    return first ? end_around(family, orbit, *first) : exchange(family, orbit, i);
  }
  const bool unfelt = !dynamics.halts(a.contact) || dynamics.stops().coupling()(a.contact, b.contact) == 0.0;
  if (!one && !dynamics.rigid(b.contact) && unfelt) return exchange(family, orbit, i);
  using Kind = ContactEvent::Kind;
  if (one && a.kind == Kind::close && b.kind == Kind::open && a.pushed.size() == 1)
    return cease_to_stick(family, orbit, i);
  if (one && a.kind == Kind::impact && b.kind == Kind::close && keeps_no_speed(dynamics, b.contact))
    return end_flight(family, orbit, i);
  if (one && a.kind == Kind::open && b.kind == Kind::close && keeps_no_speed(dynamics, b.contact))
    return end_phase(family, orbit, i);
  const bool impacts = a.kind == ContactEvent::Kind::impact && b.kind == ContactEvent::Kind::impact;
  if (!one && impacts && coupling_of(dynamics.structure(), a, b) != ImpactCoupling::mass)
    return exchange(family, orbit, i);
  return {.obstacle = one ? "not followed" : "an end"};
}

// That a guard is of.
int contact_of(const OrbitGuard& guard, const SequencedOrbit& orbit) {
  const bool of_contact = guard.kind == GuardKind::clearance || guard.kind == GuardKind::pressure ||
                          guard.kind == GuardKind::corner;
  return of_contact ? guard.index : event_of(orbit, guard.index).contact;
}

// Of changes at rigid stops, and at damped ones whose forces feel each other.
std::string why_not_followed(const OrbitGuard& guard) {
  switch (guard.kind) {
    case GuardKind::pressure:
      return "a flight that ends in a chatter begins; not followed";
    case GuardKind::landing:
    case GuardKind::release:
      return "it would stick together with others; not followed";
    case GuardKind::corner:
      return "what comes after depends on the order of the impacts; an end";
    default:
      return "not followed";
  }
}

}  // namespace

ChangeOfSequence past_change(OrbitFamily& family, const TracedCurve& curve) {
  const OrbitGuard& guard = *curve.guard;
  const SequencedOrbit& orbit = curve.last;
  ExtendedEquations equations(family, orbit);
  if (!equations.evaluate(orbit.x)) return {.obstacle = "the orbit cannot be evaluated"};
  const ContactDynamics& dynamics = equations.model().dynamics;
  const int contact = contact_of(guard, orbit);
  const bool rigid = dynamics.rigid(contact);
  if (curve.branch.ended.starts_with(kChatterLimit))
    return {.obstacle = "infinitely many impacts graze there; an end"};
  switch (guard.kind) {
    case GuardKind::clearance:
    case GuardKind::pressure:
      if (!rigid && !family.driven()) return begin_phases(family, orbit, equations);
      if (!rigid || (guard.kind == GuardKind::pressure && keeps_no_speed(dynamics, contact)))
        return begin_phase(family, orbit, guard, rigid);
      break;
    case GuardKind::interval:
      if (guard.index > 0) return past_coincidence(family, orbit, guard.index, dynamics);
      break;
    case GuardKind::approach: {
      // A closing without a speed: its phase of contact has no length, or the interruption before it.
      const bool closing = event_of(orbit, guard.index).kind == ContactEvent::Kind::close;
      const auto met = closing ? nearer_event(orbit, guard.index) : std::nullopt;
      if (met && !rigid) return end_phase(family, orbit, *met);
      if (met && keeps_no_speed(dynamics, contact)) return past_coincidence(family, orbit, *met, dynamics);
      break;
    }
    case GuardKind::release:
      if (const auto closing = followed_at_once(orbit, guard.index, ContactEvent::Kind::close))
        return end_flight(family, orbit, *closing);
      if (event_of(orbit, guard.index).pushed.size() == 1) return begin_to_stick(family, orbit, guard.index);
      break;
    case GuardKind::landing:
      if (!keeps_no_speed(dynamics, contact) || event_of(orbit, guard.index).pushed.size() != 1) break;
      if (const auto opening = followed_at_once(orbit, guard.index, ContactEvent::Kind::open))
        return cease_to_stick(family, orbit, *opening);
      return begin_flight(family, orbit, guard.index);
    case GuardKind::corner:
      if (!dynamics.halts(contact)) return begin_around(family, orbit, guard);
      break;
    case GuardKind::together:
      break;
  }
  return {.obstacle = why_not_followed(guard)};
}

}  // namespace signorini
