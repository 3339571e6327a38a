#include "methods/orbit/family/event_instants.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include "methods/solvers/bracketed_zero.hpp"

namespace signorini {

namespace {

// The function that vanishes at an event, or a derivative.
double equation_of(const SequenceEvent& event, const LinearArc& arc, double gap, double time, int order) {
  if (event.kind == ContactEvent::Kind::open) return arc.force(event.contact, time, order);
  return arc.displacement(event.contact, time, order) - (order == 0 ? gap : 0.0);
}

}  // namespace

std::optional<Eigen::VectorXd> event_instants(OrbitModel& model, const SequencedOrbit& orbit,
                                              const CurveUnits& units, const Eigen::VectorXd& x) {
  constexpr double kFarthest = 0.2, kShort = 0.05;  // rad
  constexpr double kSameFlight = 1e-3;              // of a short flight
  const FlowStructure& structure = model.dynamics.structure();
  const double omega = structure.frequency;
  const Eigen::Index states = model.dynamics.states();
  State state = state_of(x, model.dynamics, units);
  Eigen::VectorXd phases(orbit.count());
  double time = orbit.section / omega, shift = 0.0;
  const std::vector<bool>* closed = &orbit.closed;
  for (Eigen::Index i = 0; i < orbit.count(); ++i) {
    const SequenceEvent& event = orbit.event(i);
    const int j = event.contact;
    const std::unique_ptr<LinearArc> arc = model.flows.of(*closed).arc();
    arc->start(time, state);
    double guess = (orbit.section + x[states + i] + shift) / omega;
    const bool flies = i > 0 && event.kind != ContactEvent::Kind::open &&
                       orbit.event(i - 1).kind == ContactEvent::Kind::impact &&
                       orbit.event(i - 1).contact == j;
    const double flight = flies ? -2.0 * arc->displacement(j, time, 1) / arc->displacement(j, time, 2) : 0.0;
    const bool brief = flight > 0.0 && flight * omega < kShort;
    if (brief) guess = time + flight;
    const auto distance = [&](double t) {
      return ValueAndSlope{equation_of(event, *arc, structure.gaps[j], t, 0),
                           equation_of(event, *arc, structure.gaps[j], t, 1)};
    };
    // To a tolerance that rounding of a slow approach may need.
    const auto at =
        newton_zero_near(distance, {.guess = guess,
                                    .reach = brief ? 0.5 * flight : kFarthest / omega,
                                    .accepted = brief ? kSameFlight * flight : kSimultaneous / omega});
    // Those of one instant come in either order to rounding.
    const bool other = i > 0 && orbit.event(i - 1).contact != j;
    if (!at || !(*at > time - (other ? kSimultaneous / omega : 0.0))) return std::nullopt;
    time = *at;
    phases[i] = time * omega - orbit.section;
    shift = phases[i] - x[states + i];
    arc->state(time, state);
    if (!event.pushed.empty()) {
      const Eigen::VectorXd impulses =
          structure.impulse_of_velocity(event.pushed, event.restitution) * state.v;
      state.v += structure.velocity_per_impulse(Eigen::all, event.pushed) * impulses;
    }
    closed = &event.closed;
  }
  if (orbit.count() > 0 && !(phases[orbit.count() - 1] < orbit.end())) return std::nullopt;
  return phases;
}

}  // namespace signorini
