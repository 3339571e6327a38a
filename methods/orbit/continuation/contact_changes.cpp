#include "methods/orbit/continuation/contact_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/flow/impact_groups.hpp"
#include "methods/orbit/family/chatter.hpp"
#include "methods/orbit/family/orbit_section.hpp"

namespace signorini {

namespace {

using Kind = ContactEvent::Kind;

constexpr double kBrief = 1e-3;  // of the first step: a fold or a doubling can lie next to the beginning

// The start with its section moved away from all events, on the side where a quantity grows, or an obstacle.
ChangeOfSequence begin_at(OrbitFamily& family, const SequencedOrbit& orbit, const OrbitQuantity& quantity,
                          const std::string& origin) {
  const auto quiet = with_quiet_section(family, orbit);
  auto start = quiet ? start_where_grows(family, *quiet, quantity, origin) : std::nullopt;
  if (!start) return {.obstacle = "the orbit cannot be evaluated"};
  return {.start = std::move(start)};
}

// The shortest time between two events of one contact with so many others between them, which are of other
// contacts.
OrbitQuantity shortest_phase(int contact, Eigen::Index between = 0) {
  return [=](const ExtendedEquations& at) {
    const SequencedOrbit& orbit = at.orbit();
    double shortest = orbit.end();
    for (Eigen::Index i = between + 1; i < orbit.count(); ++i) {
      const Eigen::Index before = i - between - 1;
      const bool ends = orbit.event(i).contact == contact && orbit.event(before).contact == contact;
      if (ends && (between == 0 || orbit.event(i - 1).contact != contact))
        shortest = std::min(shortest, orbit.phase(i) - orbit.phase(before));
    }
    return shortest;
  };
}

// The guard of a kind at the first event of a contact that has it.
OrbitQuantity guard_of_event(GuardKind kind, int contact) {
  return [=](const ExtendedEquations& at) {
    for (const OrbitGuard& guard : event_guards(at)) {
      if (guard.kind == kind && at.orbit().event(guard.index).contact == contact) return guard.value;
    }
    return std::nan("");
  };
}

// The later of event i and that of its contact before or behind it, whichever is nearer; empty where others
// lie between them.
std::optional<Eigen::Index> nearer_event(const SequencedOrbit& orbit, Eigen::Index i) {
  const auto gap = [&](Eigen::Index later) {
    const bool pair =
        later > 0 && later < orbit.count() && orbit.event(later).contact == orbit.event(later - 1).contact;
    return pair ? orbit.phase(later) - orbit.phase(later - 1) : orbit.end();
  };
  const Eigen::Index nearer = gap(i) < gap(i + 1) ? i : i + 1;
  return gap(nearer) < orbit.end() ? std::optional(nearer) : std::nullopt;
}

ChangeOfSequence begin_phase(OrbitFamily& family, const SequencedOrbit& orbit, const OrbitGuard& guard,
                             bool rigid) {
  const int contact = guard.index;
  SequencedOrbit with_phase = with_contact_phase(orbit, contact, guard.phase);
  for (SequenceEvent& event : with_phase.events) {
    if (!rigid || event.contact != contact || event.kind != Kind::close || !event.pushed.empty()) continue;
    event.pushed = {contact};  // a rigid stop takes the speed of what comes to rest on it
    event.restitution = {0.0};
  }
  ChangeOfSequence change =
      begin_at(family, with_phase, shortest_phase(contact),
               fmt::format("contact {} starts pressing, or opens for a moment", contact));
  if (change.start) change.start->first_step_share = kBrief;
  return change;
}

// Of free motions before compliant stops: a phase of contact, or its interruption, at every instant at which
// a contact touches its stop, or lets go, of symmetric motions several. The motion is unique, and all grow.
ChangeOfSequence begin_phases(OrbitFamily& family, const SequencedOrbit& orbit,
                              const ExtendedEquations& equations) {
  SequencedOrbit with_phases = orbit;
  for (const GuardMaximum& guard : survey(equations).maxima) {
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
  SequenceEvent impact = orbit.event(closing);
  impact.kind = Kind::impact;
  return begin_at(family, with_event(orbit, closing, {orbit.phase(closing), impact}),
                  shortest_phase(impact.contact),
                  fmt::format("contact {} closes after a short flight", impact.contact));
}

// A spring is reached, or lets go, at the impact of another contact, which turns its contact back: its force
// has no jump there, and the motion goes on with a phase of contact, or a break of one, around the impact.
ChangeOfSequence begin_around(OrbitFamily& family, const SequencedOrbit& orbit, const OrbitGuard& guard) {
  const int contact = guard.index;
  Eigen::Index impact = 0;
  while (impact < orbit.count() && orbit.phase(impact) != guard.phase) ++impact;
  if (impact == orbit.count()) return {.obstacle = "the impact is not found"};
  const bool closed = closed_before(orbit, contact, guard.phase);
  const auto event = [&](bool opens) {
    return PlacedEvent{guard.phase, {.kind = opens ? Kind::open : Kind::close, .contact = contact}};
  };
  // Both before any sorting: events of one instant may be out of order by rounding.
  std::vector<PlacedEvent> placed = placed_events(orbit);
  placed.insert(placed.begin() + impact + 1, event(!closed));
  placed.insert(placed.begin() + impact, event(closed));
  return begin_at(family, with_modes(with_events(orbit, std::move(placed))), shortest_phase(contact, 1),
                  fmt::format("contact {} presses, or opens, around the impact of another", contact));
}

// The event of a contact before an impact of another one, of which events i - 1 and i are two, where its next
// one follows the impact at once; else empty.
std::optional<Eigen::Index> around_impact(const SequencedOrbit& orbit, Eigen::Index i) {
  for (const Eigen::Index impact : {i - 1, i}) {
    if (impact == 0 || impact + 1 >= orbit.count() || orbit.event(impact).pushed.empty()) continue;
    if (orbit.event(impact - 1).contact == orbit.event(impact + 1).contact &&
        orbit.phase(impact + 1) - orbit.phase(impact - 1) < kAtOnce)
      return impact - 1;
  }
  return std::nullopt;
}

// The phase that began so has ended; its events are `first` and the one after the impact.
ChangeOfSequence end_around(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index first) {
  const int contact = orbit.event(first).contact;
  return begin_at(
      family, with_modes(without_event(without_event(orbit, first + 2), first)),
      quantity_of(GuardKind::corner, contact),
      fmt::format("contact {} stops pressing, or no longer opens, around the impact of another", contact));
}

// The flight between the impact before a closing and the closing has ended.
ChangeOfSequence end_flight(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index closing) {
  const int contact = orbit.event(closing).contact;
  return begin_at(family, without_event(orbit, closing - 1), guard_of_event(GuardKind::landing, contact),
                  fmt::format("contact {} closes at once", contact));
}

// The orbit without the phases of contact, or their interruptions, that have no length: of a symmetric motion
// several end at once.
SequencedOrbit without_brief_phases(SequencedOrbit orbit) {
  for (Eigen::Index i = orbit.count() - 1; i > 0; --i) {
    const bool one = orbit.event(i).contact == orbit.event(i - 1).contact;
    if (!one || orbit.phase(i) - orbit.phase(i - 1) > kAtOnce) continue;
    orbit = without_event(without_event(orbit, i), i - 1);
    --i;
  }
  return orbit;
}

// Events i - 1 and i of one contact have met.
ChangeOfSequence end_phase(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i) {
  const int contact = orbit.event(i).contact;
  const GuardKind kind = orbit.event(i).kind == Kind::open ? GuardKind::clearance : GuardKind::pressure;
  SequencedOrbit without = without_event(without_event(orbit, i), i - 1);
  if (!family.driven()) without = without_brief_phases(std::move(without));
  if (!family.driven() && without.events.empty()) return {.obstacle = std::string(kLinearMode)};
  ExtendedEquations equations(family, without);
  if (!equations.evaluate(without.x)) return {.obstacle = "the orbit cannot be evaluated"};
  return begin_at(family, of_least_period(without, equations), quantity_of(kind, contact),
                  fmt::format("contact {} stops pressing, or no longer opens for a moment", contact));
}

// Events i - 1 and i of two contacts have met; with them, of a motion with a symmetry, other pairs.
ChangeOfSequence exchange(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i) {
  SequencedOrbit exchanged = orbit;
  for (Eigen::Index k = 1; k < orbit.count(); ++k) {
    const bool meet = std::abs(orbit.phase(k) - orbit.phase(k - 1)) < kSimultaneous &&
                      orbit.event(k).contact != orbit.event(k - 1).contact;
    if (k != i && !meet) continue;
    std::iter_swap(exchanged.events.begin() + k - 1, exchanged.events.begin() + k);
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
  sticking.events[static_cast<std::size_t>(i)].kind = Kind::close;
  const int contact = orbit.event(i).contact;
  return begin_at(family,
                  with_event(sticking, i + 1, {orbit.phase(i), {.kind = Kind::open, .contact = contact}}),
                  shortest_phase(contact), fmt::format("contact {} begins to stick", contact));
}

ChangeOfSequence cease_to_stick(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i) {
  SequencedOrbit without = without_event(orbit, i);
  without.events[static_cast<std::size_t>(i - 1)].kind = Kind::impact;
  const int contact = orbit.event(i).contact;
  return begin_at(family, with_modes(std::move(without)), guard_of_event(GuardKind::release, contact),
                  fmt::format("contact {} sticks no more", contact));
}

// After an impact the contact rests, with no chatter between.
bool keeps_no_speed(const ContactDynamics& dynamics, int contact) {
  return dynamics.restitution(contact) == 0.0;
}

// The event after i where it is of the same contact, of a kind, and at no distance; else empty.
std::optional<Eigen::Index> followed_at_once(const SequencedOrbit& orbit, Eigen::Index i, Kind kind) {
  const bool follows = i + 1 < orbit.count() && orbit.event(i + 1).contact == orbit.event(i).contact &&
                       orbit.event(i + 1).kind == kind && orbit.phase(i + 1) - orbit.phase(i) < kAtOnce;
  return follows ? std::optional(i + 1) : std::nullopt;
}

// Events i - 1 and i coincide.
ChangeOfSequence past_coincidence(OrbitFamily& family, const SequencedOrbit& orbit, Eigen::Index i,
                                  const ContactDynamics& dynamics) {
  const SequenceEvent &a = orbit.event(i - 1), &b = orbit.event(i);
  const bool one = a.contact == b.contact;
  if (one && !dynamics.rigid(b.contact)) return end_phase(family, orbit, i);
  if (!one && dynamics.halts(a.contact) != dynamics.halts(b.contact)) {
    const auto first = around_impact(orbit, i);
    return first ? end_around(family, orbit, *first) : exchange(family, orbit, i);
  }
  const bool unfelt = !dynamics.halts(a.contact) || dynamics.stops().coupling()(a.contact, b.contact) == 0.0;
  if (!one && !dynamics.rigid(b.contact) && unfelt) return exchange(family, orbit, i);
  if (one && a.kind == Kind::close && b.kind == Kind::open && a.pushed.size() == 1)
    return cease_to_stick(family, orbit, i);
  if (one && a.kind == Kind::impact && b.kind == Kind::close && keeps_no_speed(dynamics, b.contact))
    return end_flight(family, orbit, i);
  if (one && a.kind == Kind::open && b.kind == Kind::close && keeps_no_speed(dynamics, b.contact))
    return end_phase(family, orbit, i);
  const bool impacts = a.kind == Kind::impact && b.kind == Kind::impact;
  if (!one && impacts && coupling_of(dynamics.structure(), a, b) != ImpactCoupling::mass)
    return exchange(family, orbit, i);
  return {.obstacle = one ? "not followed" : "an end"};
}

// That a guard is of.
int contact_of(const OrbitGuard& guard, const SequencedOrbit& orbit) {
  const bool of_contact = guard.kind == GuardKind::clearance || guard.kind == GuardKind::pressure ||
                          guard.kind == GuardKind::corner;
  return of_contact ? guard.index : orbit.event(guard.index).contact;
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
      const bool closing = orbit.event(guard.index).kind == Kind::close;
      const auto met = closing ? nearer_event(orbit, guard.index) : std::nullopt;
      if (met && !rigid) return end_phase(family, orbit, *met);
      if (met && keeps_no_speed(dynamics, contact)) return past_coincidence(family, orbit, *met, dynamics);
      break;
    }
    case GuardKind::release:
      if (const auto closing = followed_at_once(orbit, guard.index, Kind::close))
        return end_flight(family, orbit, *closing);
      if (orbit.event(guard.index).pushed.size() == 1) return begin_to_stick(family, orbit, guard.index);
      break;
    case GuardKind::landing:
      if (!keeps_no_speed(dynamics, contact) || orbit.event(guard.index).pushed.size() != 1) break;
      if (const auto opening = followed_at_once(orbit, guard.index, Kind::open))
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
