#include "methods/orbit/family/chatter.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/orbit_guess.hpp"

namespace signorini {

namespace {

using Kind = ContactEvent::Kind;

// From closing i to the opening of the contact, through the section if need be [rad].
double closed_for(const SequencedOrbit& orbit, Eigen::Index i) {
  const int contact = orbit.event(i).contact;
  const Eigen::Index m = orbit.count();
  for (Eigen::Index k = 1; k <= m; ++k) {
    const Eigen::Index at = (i + k) % m;
    if (orbit.event(at).contact == contact && orbit.event(at).kind == Kind::open)
      return orbit.phase(at) - orbit.phase(i) + (at < i ? orbit.end() : 0.0);
  }
  return orbit.end();
}

// The closing becomes an impact, and the contact closes when the next one is due; empty where another event
// comes first.
std::optional<SequencedOrbit> with_one_more(const ExtendedEquations& equations, const ChatterEnd& end) {
  const SequencedOrbit& orbit = equations.orbit();
  const int contact = orbit.event(end.closing).contact;
  const double e = equations.model().dynamics.restitution(contact);
  const double phase =
      orbit.phase(end.closing) + equations.frequency() * 2.0 * e * end.speed / end.acceleration;
  const Eigen::Index next = end.closing + 1;
  if (phase >= (next < orbit.count() ? orbit.phase(next) : orbit.end())) return std::nullopt;
  SequencedOrbit longer = orbit;
  SequenceEvent& impact = longer.events[static_cast<std::size_t>(end.closing)];
  impact.kind = Kind::impact;
  impact.restitution.assign(impact.pushed.size(), e);
  return with_event(longer, next, {phase, orbit.event(end.closing)});
}

// The contact closes at the impact before.
SequencedOrbit with_one_less(const SequencedOrbit& orbit, const ChatterEnd& end) {
  SequencedOrbit result = without_event(orbit, end.closing);
  SequenceEvent& closing = result.events[static_cast<std::size_t>(end.closing - 1)];
  closing.kind = Kind::close;
  closing.restitution.assign(closing.pushed.size(), 0.0);
  return with_modes(std::move(result));
}

bool follows_an_impact(const SequencedOrbit& orbit, Eigen::Index i) {
  if (i == 0) return false;
  const SequenceEvent& before = orbit.event(i - 1);
  return before.kind == Kind::impact && before.contact == orbit.event(i).contact && before.pushed.size() == 1;
}

// The orbit with one impact more or less at one of the closings.
ResolvedChatter one_step(const ExtendedEquations& equations) {
  constexpr double kMostRest = 0.5, kByFar = 0.5;  // shares: of the contact, of kAdmissible
  const SequencedOrbit& orbit = equations.orbit();
  for (const ChatterEnd& end : chatter_ends(equations)) {
    const double e = equations.model().dynamics.restitution(orbit.event(end.closing).contact);
    if (orbit.event(end.closing).pushed.size() != 1)
      return {.obstacle = "its impacts are felt by contacts that rest"};
    if (e == 1.0) return {.obstacle = "elastic impacts that fade have no limit to add to"};
    if (end.left_out > kAdmissible) {
      if (!(end.rest < kMostRest)) return {.obstacle = kChatterLimit};
      auto more = with_one_more(equations, end);
      if (!more) return {.obstacle = "another event comes before its end"};
      return {.orbit = std::move(more)};
    }
    // Each impact makes the error smaller by e^2.
    if (end.left_out < kByFar * e * e * kAdmissible && follows_an_impact(orbit, end.closing))
      return {.orbit = with_one_less(orbit, end)};
  }
  return {};
}

}  // namespace

std::vector<ChatterEnd> chatter_ends(const ExtendedEquations& equations) {
  const ContactDynamics& dynamics = equations.model().dynamics;
  std::vector<ChatterEnd> ends;
  const SequencedOrbit& orbit = equations.orbit();
  for (Eigen::Index i = 0; i < orbit.count(); ++i) {
    const SequenceEvent& event = orbit.event(i);
    const double e = dynamics.restitution(event.contact);
    if (event.kind != Kind::close || !dynamics.rigid(event.contact) || e == 0.0) continue;
    ChatterEnd end{
        .closing = i,
        .speed = equations.equations().crossings()[static_cast<std::size_t>(i)].approach,
        .acceleration = equations.arc(i).displacement(event.contact, equations.time_of(orbit.phase(i)), 2),
        .left_out = std::numeric_limits<double>::infinity(),
        .rest = std::numeric_limits<double>::infinity()};
    if (end.acceleration > 0.0 && e < 1.0) {
      const double lasts = 2.0 * e * end.speed / (end.acceleration * (1.0 - e));
      end.left_out = 0.25 * end.speed * lasts / equations.family().units().displacement;
      end.rest = lasts * equations.frequency() / closed_for(orbit, i);
    }
    ends.push_back(end);
  }
  return ends;
}

ResolvedChatter resolve_chatter(const ExtendedEquations& equations) {
  ResolvedChatter result = one_step(equations);
  while (result.orbit && result.obstacle.empty()) {
    if (result.orbit->events.size() > kMostEvents) return {.obstacle = "too many impacts before its end"};
    ExtendedEquations next(equations.family(), *result.orbit);
    if (!correct_at_parameter(next, result.orbit->x))
      return {.obstacle = "the corrector fails where an impact is added or taken away"};
    result.orbit = next.orbit();
    ResolvedChatter further = one_step(next);
    if (!further.orbit && further.obstacle.empty()) break;
    result = std::move(further);
  }
  return result;
}

bool leaves_out_too_much(const ExtendedEquations& equations) {
  constexpr double kTooMuch = 30.0;  // times
  return std::ranges::any_of(chatter_ends(equations),
                             [](const ChatterEnd& end) { return end.left_out > kTooMuch * kAdmissible; });
}

bool ends_chatter(const ExtendedEquations& equations, const OrbitGuard& guard) {
  if (guard.kind != GuardKind::interval && guard.kind != GuardKind::landing) return false;
  const Eigen::Index closing = guard.kind == GuardKind::interval ? guard.index - 1 : guard.index;
  return std::ranges::count(chatter_ends(equations), closing, &ChatterEnd::closing) > 0;
}

}  // namespace signorini
