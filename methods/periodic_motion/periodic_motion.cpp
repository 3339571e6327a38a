#include "methods/periodic_motion/periodic_motion.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "methods/flow/event_trajectory.hpp"
#include "methods/structure/periodic_response.hpp"
#include "methods/structure/rigid_motions.hpp"

namespace signorini {

namespace {

// At rest at time 0, or where the guess is at the instant `begin`. What a Trajectory shows is the contacts:
// the state behind it is the structure's periodic response to its contact force, which takes a structure with
// only one such response, and at an instant where an impact may be. A motion that a flow has left knows more
// than the interface asks for, its own state between two events, so that what is continued from it is the
// very orbit, unstable or not: hence the cast.
FlowState first_state(const Problem& problem, const ContactDynamics& dynamics, const Start& start,
                      double begin, const EventFlow& flow) {
  if (!start.guess) return flow.place(0.0, dynamics.at_rest());
  const auto* followed = dynamic_cast<const EventTrajectory*>(start.guess.get());
  if (followed != nullptr && followed->start().state.u.size() == dynamics.positions()) {
    return flow.place(std::fmod(followed->start().time, problem.period()), followed->start().state);
  }
  const State whole = PeriodicResponse(problem, *start.guess).at(begin);
  return flow.place(begin, dynamics.with_mass(whole, contact_directions(problem).transpose() * whole.u));
}

std::shared_ptr<const Trajectory> recorded(PeriodMap& map, const FixedPoint& found) {
  FlowState state = found.start;
  FlowRecord record;
  record.dense = true;
  map.apply(state, found.order, record);
  return std::make_shared<EventTrajectory>(found.order * map.forcing_period(), found.start,
                                           std::move(record.nodes), std::move(record.events));
}

void search(const Problem& problem, const ContactDynamics& dynamics, PeriodicMotionOptions options,
            const Start& start, PeriodMap& map, Solution& solution) {
  constexpr int kForgotten = 20;  // periods after which the start from rest of a shooting matters no more
  const std::function<bool()> expired = [&start] { return start.expired(); };
  options.max_order = std::max(options.max_order, problem.subharmonic);
  FlowState state = first_state(problem, dynamics, start, options.begin, map.flow());
  if (options.shooting && !start.guess) {
    FlowRecord record;
    map.apply(state, kForgotten * problem.subharmonic, record);
  }
  const FixedPoint found = options.shooting ? shoot(map, state, problem.subharmonic, options, expired)
                                            : march(map, state, options, expired);
  solution.verdict = found.converged ? Verdict::converged : Verdict::not_converged;
  solution.message = found.message;
  solution.work.iterations = found.iterations;
  solution.condition = found.condition;
  if (std::isfinite(found.residual)) solution.residual = found.residual;
  solution.trajectory = recorded(map, found);
}

}  // namespace

Solution find_periodic_motion(const Problem& problem, const ContactDynamics& dynamics,
                              const PeriodicMotionOptions& options, const Start& start) {
  Solution solution;
  solution.work.unknowns = dynamics.states();
  const bool pushed =
      std::ranges::any_of(problem.force, [](const ForceTerm& term) { return term.harmonic == 0; });
  if (pushed) solution.message = unbalanced_mean_load(problem);
  if (!solution.message.empty()) return solution;
  std::optional<EventFlow> flow;
  std::optional<PeriodMap> map;
  try {
    flow.emplace(
        dynamics, options.tolerance, [&start] { return start.expired(); }, options.integrator);
    map.emplace(*flow);
    search(problem, dynamics, options, start, *map, solution);
  } catch (const std::exception& error) {  // of the integrator's set-up, too
    solution.verdict = Verdict::not_converged;
    solution.message = error.what();
    if (map) solution.work.iterations = map->periods();
  }
  if (flow) solution.work.rhs_evaluations = flow->rhs_evaluations();
  return solution;
}

}  // namespace signorini
