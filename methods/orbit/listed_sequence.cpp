#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "methods/discretisation/periodic_time.hpp"
#include "methods/flow/impact_groups.hpp"
#include "methods/orbit/orbit_guess.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

using Kind = ContactEvent::Kind;

// An impact that is followed by a closing of its contact without an impulse is where the contact sticks.
void end_chatters(std::vector<ContactEvent>& events) {
  for (std::size_t i = 0; i < events.size();) {
    const auto& closing = events[i];
    std::size_t before = i;
    do before = (before + events.size() - 1) % events.size();
    while (before != i && events[before].contact != closing.contact);
    if (closing.kind == Kind::close && closing.impulse == 0.0 && events[before].kind == Kind::impact) {
      events[before].kind = Kind::close;
      events.erase(events.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

// The contacts that are closed at the section: those whose first change is an opening.
std::vector<bool> closed_at_section(const std::vector<ContactEvent>& events,
                                    const std::vector<bool>& pushing) {
  std::vector<bool> closed = pushing, known(pushing.size(), false);
  for (const ContactEvent& event : events) {
    const auto index = static_cast<std::size_t>(event.contact);
    if (event.kind == Kind::impact || known[index]) continue;
    known[index] = true;
    closed[index] = event.kind == Kind::open;
  }
  return closed;
}

// Adds the entries of events of one instant, one for each group of contacts that feel each other's impulses;
// `closed` goes from their left to their right side. False where they contradict the contacts that are
// closed.
bool join(const ContactDynamics& dynamics, const std::vector<ContactEvent>& together,
          std::vector<bool>& closed, std::vector<SequenceEvent>& sequence) {
  const std::vector<bool> before = closed;
  const auto was_closed = [&](const ContactEvent& event) {
    return before[static_cast<std::size_t>(event.contact)];
  };
  const auto strikes = [&](const ContactEvent& event) {
    return event.kind != Kind::open && !was_closed(event);
  };
  const auto pushed = [&](const ContactEvent& event) {
    return dynamics.rigid(event.contact) && (event.impulse != 0.0 || strikes(event));
  };
  std::vector<int> contacts;
  for (const ContactEvent& event : together) {
    if ((event.kind == Kind::close) == was_closed(event) && event.kind != Kind::impact) return false;
    if (pushed(event)) contacts.push_back(event.contact);
  }
  auto groups = impact_groups(dynamics.structure(), contacts);
  if (groups.empty()) groups.emplace_back();
  for (const std::vector<int>& group : groups) {
    // Those that take no impulse change with the first group.
    const auto of_group = [&](const ContactEvent& event) {
      return pushed(event) ? std::ranges::find(group, event.contact) != group.end() : &group == &groups[0];
    };
    const ContactEvent* trigger = nullptr;
    for (const ContactEvent& event : together) {
      if (of_group(event) && (trigger == nullptr || (strikes(event) && !strikes(*trigger)))) trigger = &event;
    }
    SequenceEvent joined{.kind = trigger->kind, .contact = trigger->contact, .time = trigger->time};
    for (const ContactEvent& event : together) {
      if (!of_group(event)) continue;
      if (event.kind != Kind::impact)
        closed[static_cast<std::size_t>(event.contact)] = event.kind == Kind::close;
      if (!pushed(event)) continue;
      const auto place = std::upper_bound(joined.pushed.begin(), joined.pushed.end(), event.contact);
      joined.restitution.insert(
          joined.restitution.begin() + (place - joined.pushed.begin()),
          event.kind == Kind::impact && strikes(event) ? dynamics.restitution(event.contact) : 0.0);
      joined.pushed.insert(place, event.contact);
    }
    joined.closed = closed;
    sequence.push_back(std::move(joined));
  }
  return true;
}

// The state at the section for which the instants of `guess` come nearest to an orbit's.
std::optional<State> state_for_instants(OrbitModel& model, const OrbitGuess& guess, const Expired& expired) {
  // The motion is linear between given instants: one step from any state solves closure and guards for the
  // state, more equations (2 Nd + m) than unknowns (2 Nd), in the least squares.
  OrbitEquations equations(model, guess, expired);
  const Eigen::Index states = equations.size() - equations.events();
  Eigen::VectorXd unknowns = equations.guess();
  if (!equations.evaluate(unknowns)) return std::nullopt;
  unknowns.head(states) -= pivoted_least_squares(equations.jacobian().leftCols(states), equations.residual());
  if (!unknowns.allFinite()) return std::nullopt;
  return equations.orbit(unknowns).start.state;
}

}  // namespace

std::optional<OrbitGuess> listed_sequence(OrbitModel& model, std::vector<ContactEvent> events, double section,
                                          const std::vector<bool>& pushing, const Expired& expired) {
  constexpr double kSameInstant = 1e-12;  // of the period
  for (ContactEvent& event : events) event.time = section + wrapped_time(event.time - section, model.period);
  std::ranges::stable_sort(events, {},
                           [](const ContactEvent& event) { return std::pair(event.time, event.contact); });
  end_chatters(events);
  std::vector<bool> closed = closed_at_section(events, pushing);
  OrbitGuess guess{.start = {.time = section, .state = model.dynamics.at_rest(), .closed = closed},
                   .events = {},
                   .origin = "its own events"};
  for (auto first = events.begin(); first != events.end();) {
    const auto last = std::find_if(first, events.end(), [&](const ContactEvent& event) {
      return event.time > first->time + kSameInstant * model.period;
    });
    if (!join(model.dynamics, {first, last}, closed, guess.events)) return std::nullopt;
    first = last;
  }
  if (closed != guess.start.closed) return std::nullopt;
  auto state = state_for_instants(model, guess, expired);
  if (!state) return std::nullopt;
  guess.start.state = std::move(*state);
  return guess;
}

}  // namespace signorini
