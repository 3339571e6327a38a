#include "methods/orbit/family/survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "methods/flow/impact_groups.hpp"
#include "methods/orbit/arc_scan.hpp"

namespace signorini {

namespace {

// Whether one of those that an event strikes comes to rest.
bool keeps_none(const SequenceEvent& event) {
  return std::ranges::find(event.restitution, 0.0) != event.restitution.end();
}

// x_j - g_j over X, or lambda_j over its scale.
LimitedOutput output_of(const ContactDynamics& dynamics, double X, const LinearArc& arc, int j,
                        bool of_force) {
  return {.arc = arc,
          .contact = j,
          .of_force = of_force,
          .offset = of_force ? 0.0 : dynamics.structure().gaps[j],
          .unit = of_force ? dynamics.force_scale(j) : X};
}

// Whether contact j rests on its stop where a part begins, let go by an opening or by an impact without
// restitution: x - g and its first derivatives are zero to rounding there, and so is a maximum beside it.
bool leaves_rest(const SequencedOrbit& orbit, const ContactDynamics& dynamics, Eigen::Index part, int j) {
  if (part == 0 || !dynamics.halts(j)) return false;
  const SequenceEvent& event = orbit.event(part - 1);
  if (event.contact != j) return false;
  return event.kind == ContactEvent::Kind::open ||
         (event.kind == ContactEvent::Kind::impact && keeps_none(event));
}

class Surveyor {
 public:
  explicit Surveyor(const ExtendedEquations& equations)
      : equations_(equations),
        dynamics_(equations.model().dynamics),
        orbit_(equations.orbit()),
        X_(equations.family().units().displacement),
        V_(equations.family().units().velocity) {
    result_.highest.setConstant(dynamics_.contact_count(), -std::numeric_limits<double>::infinity());
    result_.lowest = -result_.highest;
  }

  OrbitSurvey run() {
    events(true);
    for (int j = 0; j < dynamics_.contact_count(); ++j) arcs(j);
    return std::move(result_);
  }

  std::vector<OrbitGuard> of_events() {
    events(false);
    return std::move(result_.guards);
  }

  std::optional<OrbitGuard> guard(GuardKind kind, int index) {
    const bool of_contact = kind == GuardKind::clearance || kind == GuardKind::pressure;
    if (of_contact) arcs(index);
    if (!of_contact) events(kind == GuardKind::corner);
    const OrbitGuard* found = result_.find(kind, index);
    return found == nullptr ? std::nullopt : std::optional(*found);
  }

 private:
  void add(GuardKind kind, int index, double value, double phase) {
    result_.guards.push_back({.kind = kind, .index = index, .value = value, .phase = phase});
  }
  // Of several maxima of one contact the largest is the guard.
  void lower(GuardKind kind, int index, double value, double phase, Eigen::Index part) {
    const OrbitGuard found{.kind = kind, .index = index, .value = value, .phase = phase};
    result_.maxima.push_back({found, part});
    for (OrbitGuard& guard : result_.guards) {
      if (!guard.same(found)) continue;
      if (value < guard.value) guard = found;
      return;
    }
    result_.guards.push_back(found);
  }

  void events(bool with_corners) {
    for (Eigen::Index i = 0; i < orbit_.count(); ++i) {
      event(i);
      if (with_corners) corners(i);
    }
  }

  void event(Eigen::Index i) {
    const auto number = static_cast<int>(i);
    const SequenceEvent& event = orbit_.event(i);
    const double phase = orbit_.phase(i);
    if (orbit_.count() > 1) {
      const double before = i == 0 ? orbit_.phase(orbit_.count() - 1) - orbit_.end() : orbit_.phase(i - 1);
      add(GuardKind::interval, number, (phase - before) * interval_weight(equations_, i), phase);
    }
    if (event.kind != ContactEvent::Kind::open) add(GuardKind::approach, number, equations_.speed(i), phase);
    const LinearArc& after = equations_.arc(i + 1);
    const double time = equations_.time_of(phase);
    if (event.pushed.size() > 1) together(i, time);
    if (event.kind == ContactEvent::Kind::close && dynamics_.rigid(event.contact))
      add(GuardKind::landing, number,
          -after.force(event.contact, time) / dynamics_.force_scale(event.contact), phase);
    if (event.kind != ContactEvent::Kind::impact) return;
    if (keeps_none(event) && event.pushed.size() == 1)
      add(GuardKind::release, number,
          -after.displacement(event.contact, time, 2) / (V_ * equations_.frequency()), phase);
  }

  void together(Eigen::Index i, double time) {
    const LinearArc& before = equations_.arc(i);
    double apart = 0.0;
    int struck = 0;
    for (const int j : orbit_.event(i).pushed) {
      if (before.mode().closed(j)) continue;
      ++struck;
      apart = std::max(apart, std::abs(dynamics_.structure().gaps[j] - before.displacement(j, time)) / X_);
    }
    if (struck < 2) return;
    add(GuardKind::together, static_cast<int>(i), kTouches - apart, orbit_.phase(i));
  }

  // Local maxima of other contacts that the jump of their velocity makes.
  void corners(Eigen::Index i) {
    const SequenceEvent& event = orbit_.event(i);
    pressed_corners(i);
    if (event.kind != ContactEvent::Kind::impact) return;
    const LinearArc& before = equations_.arc(i);
    const LinearArc& after = equations_.arc(i + 1);
    const double phase = orbit_.phase(i), time = equations_.time_of(phase);
    for (int j = 0; j < dynamics_.contact_count(); ++j) {
      if (j == event.contact || before.mode().closed(j) || after.mode().closed(j)) continue;
      if (std::ranges::find(event.pushed, j) != event.pushed.end()) continue;  // it is struck, too
      if (!feel_through_mass(dynamics_.structure(), j, event.contact)) continue;
      if (!(before.displacement(j, time, 1) > 0.0 && after.displacement(j, time, 1) <= 0.0)) continue;
      lower(GuardKind::corner, j, (dynamics_.structure().gaps[j] - before.displacement(j, time)) / X_, phase,
            i);
    }
  }

  // The same of the forces of springs that stay pressed, and what a damped stop makes of those of others.
  void pressed_corners(Eigen::Index i) {
    const SequenceEvent& event = orbit_.event(i);
    const LinearArc& before = equations_.arc(i);
    const LinearArc& after = equations_.arc(i + 1);
    const double time = equations_.time_of(orbit_.phase(i));
    for (const int j : before.mode().active) {
      if (j == event.contact || dynamics_.rigid(j) || !after.mode().closed(j)) continue;
      const bool turns = event.kind == ContactEvent::Kind::impact && before.force(j, time, 1) > 0.0 &&
                         after.force(j, time, 1) <= 0.0;
      const bool jumps = event.kind == ContactEvent::Kind::close && dynamics_.halts(j) &&
                         dynamics_.stops().coupling()(j, event.contact) != 0.0;
      if (turns || jumps)
        lower(GuardKind::corner, j, -after.force(j, time) / dynamics_.force_scale(j), orbit_.phase(i), i);
    }
  }

  // Of one contact, over the whole period.
  void arcs(int contact) {
    const Eigen::Index m = orbit_.count();
    for (Eigen::Index i = 0; i <= m; ++i) {
      const double begin = equations_.time_of(i == 0 ? 0.0 : orbit_.phase(i - 1));
      const double end = equations_.time_of(i == m ? orbit_.end() : orbit_.phase(i));
      arc(i, contact, begin, end);
    }
    at_section(contact);
  }

  [[nodiscard]] LimitedOutput output(const LinearArc& arc, int j, bool of_force) const {
    return output_of(dynamics_, X_, arc, j, of_force);
  }

  // A maximum right at the section, as of motions that run backwards as they run forwards, is inside no arc.
  void at_section(int j) {
    const bool closed = equations_.arc(0).mode().closed(j);
    const LimitedOutput after = output(equations_.arc(0), j, closed);
    const LimitedOutput before = output(equations_.arc(orbit_.count()), j, closed);
    const double begin = equations_.time_of(0.0), end = equations_.time_of(orbit_.end());
    if (before.value(end, 1) >= 0.0 && after.value(begin, 1) <= 0.0 && after.value(begin, 2) < 0.0)
      lower(closed ? GuardKind::pressure : GuardKind::clearance, j, -after.value(begin, 0), 0.0, 0);
  }

  void arc(Eigen::Index part, int j, double begin, double end) {
    const LinearArc& arc = equations_.arc(part);
    const std::vector<FadingRate> terms = arc.fading_rates(kOrbitRounding);  // less moves no extreme
    const bool closed = arc.mode().closed(j);
    const double gap = dynamics_.structure().gaps[j];
    const LimitedOutput x = output(arc, j, false);
    constexpr double kBeside = 1e-4;  // rad
    const double resting =
        leaves_rest(orbit_, dynamics_, part, j) ? begin + kBeside / equations_.frequency() : begin;
    for (const LimitedSample& at : extremes(x, begin, end, terms)) {
      result_.highest[j] = std::max(result_.highest[j], gap + X_ * at.value);
      result_.lowest[j] = std::min(result_.lowest[j], gap + X_ * at.value);
      if (at.maximum && !closed && !(at.time < resting && std::abs(at.value) < kOrbitRounding))
        lower(GuardKind::clearance, j, -at.value, equations_.phase_of(at.time), part);
    }
    if (!closed) return;
    const LimitedOutput force = output(arc, j, true);
    for (const LimitedSample& at : extremes(force, begin, end, terms)) {
      if (at.maximum) lower(GuardKind::pressure, j, -at.value, equations_.phase_of(at.time), part);
    }
  }

  const ExtendedEquations& equations_;
  const ContactDynamics& dynamics_;
  const SequencedOrbit& orbit_;
  double X_, V_;
  OrbitSurvey result_;
};

}  // namespace

const OrbitGuard* OrbitSurvey::find(GuardKind kind, int index) const {
  const auto found = std::ranges::find_if(
      guards, [&](const OrbitGuard& guard) { return guard.kind == kind && guard.index == index; });
  return found == guards.end() ? nullptr : &*found;
}

double interval_weight(const ExtendedEquations& equations, Eigen::Index event) {
  constexpr double kOvertaking = 1e-3;
  return event > 0 && equations.equations().may_overtake(event, event - 1) ? kOvertaking : 1.0;
}

OrbitSurvey survey(const ExtendedEquations& equations) { return Surveyor(equations).run(); }

std::optional<OrbitGuard> guard_of(const ExtendedEquations& equations, GuardKind kind, int index) {
  return Surveyor(equations).guard(kind, index);
}

std::optional<double> guard_value(const ExtendedEquations& equations, GuardKind kind, int index) {
  const auto guard = guard_of(equations, kind, index);
  return guard ? std::optional(guard->value) : std::nullopt;
}

std::vector<OrbitGuard> event_guards(const ExtendedEquations& equations) {
  return Surveyor(equations).of_events();
}

double value_at(const ExtendedEquations& equations, const GuardMaximum& maximum) {
  const LinearArc& arc = equations.arc(maximum.part);
  const int j = maximum.index;
  const bool corner = maximum.kind == GuardKind::corner;
  const double time = equations.time_of(corner ? equations.orbit().phase(maximum.part) : maximum.phase);
  const ContactDynamics& dynamics = equations.model().dynamics;
  if (maximum.kind == GuardKind::pressure) return -arc.force(j, time) / dynamics.force_scale(j);
  if (corner && arc.mode().closed(j))
    return -equations.arc(maximum.part + 1).force(j, time) / dynamics.force_scale(j);
  const double gap = dynamics.structure().gaps[j];
  return (gap - arc.displacement(j, time)) / equations.family().units().displacement;
}

bool is_grazing(const OrbitGuard& guard, const ExtendedEquations& equations) {
  const ContactDynamics& dynamics = equations.model().dynamics;
  if (guard.kind == GuardKind::clearance) return dynamics.halts(guard.index);
  if (guard.kind != GuardKind::approach && guard.kind != GuardKind::interval) return false;
  const SequencedOrbit& orbit = equations.orbit();
  const SequenceEvent& event = orbit.event(guard.index);
  const bool follows = guard.index > 0 && orbit.event(guard.index - 1).contact == event.contact;
  const bool damped = dynamics.halts(event.contact) && !dynamics.rigid(event.contact);
  if (guard.kind == GuardKind::interval) return damped && follows && event.kind == ContactEvent::Kind::open;
  if (!damped) return event.kind == ContactEvent::Kind::impact;
  // Else the contact, let go for a moment, closes again at once.
  return !follows || orbit.phase(guard.index) - orbit.phase(guard.index - 1) > kAtOnce;
}

std::string describe(const OrbitGuard& guard, const SequencedOrbit& orbit, const ContactDynamics& dynamics) {
  const auto event = [&]() -> const SequenceEvent& { return orbit.event(guard.index); };
  switch (guard.kind) {
    case GuardKind::approach:
      return event().kind == ContactEvent::Kind::impact
                 ? fmt::format("the speed of an impact of contact {} tends to zero", event().contact)
                 : fmt::format("contact {} stops pressing", event().contact);
    case GuardKind::interval: {
      const SequenceEvent& before = orbit.event((guard.index + orbit.count() - 1) % orbit.count());
      if (before.contact == event().contact)
        return fmt::format("two events of contact {} meet", event().contact);
      return fmt::format("events of contacts {} and {} coincide", before.contact, event().contact);
    }
    case GuardKind::clearance:
      return dynamics.rigid(guard.index) ? fmt::format("contact {} grazes its stop", guard.index)
                                         : fmt::format("contact {} begins to press on its stop", guard.index);
    case GuardKind::corner:
      return closed_before(orbit, guard.index, guard.phase)
                 ? fmt::format("contact {} lets go where another meets its stop", guard.index)
                 : fmt::format("contact {} reaches its stop at the impact of another", guard.index);
    case GuardKind::pressure:
      return fmt::format("contact {} lets go while it is closed", guard.index);
    case GuardKind::landing:
      return fmt::format("contact {} closes without a force", event().contact);
    case GuardKind::release:
      return fmt::format("contact {} begins to stick", event().contact);
    case GuardKind::together:
      return fmt::format("contacts strike no longer at one instant with contact {}", event().contact);
  }
  return {};
}

}  // namespace signorini
