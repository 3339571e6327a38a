#include "methods/periodic_motion/periodic_motion.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <utility>

#include "methods/flow/event_trajectory.hpp"
#include "methods/periodic_motion/period_map.hpp"
#include "methods/periodic_motion/steady_state.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

SteadyLimits limits_of(const PeriodicMotionOptions& options, int subharmonic) {
  constexpr double kCvodeNoise = 5e-11, kModalNoise = 1e-12;
  return {.tolerance = options.tolerance,
          .max_iterations = options.max_iterations,
          .max_order = std::max(options.max_order, subharmonic),
          .noise = options.integrator == Integrator::cvode ? kCvodeNoise : kModalNoise};
}

/// At rest at time 0, or where the guess is. A motion that was followed itself knows a state of its own,
/// exactly and between two events; of any other the response to its contact force has to do.
FlowState first_state(const Problem& problem, const ContactDynamics& dynamics, const Start& start,
                      const EventFlow& flow) {
  if (!start.guess) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(dynamics.size());
    return flow.place(0.0, {.u = zero, .v = zero});
  }
  const auto* followed = dynamic_cast<const EventTrajectory*>(start.guess.get());
  if (followed != nullptr && followed->start().state.u.size() == dynamics.size()) {
    return flow.place(std::fmod(followed->start().time, dynamics.structure().forcing_period),
                      followed->start().state);
  }
  return flow.place(0.0, dynamics.with_mass(PeriodicResponse(problem, *start.guess).at(0.0)));
}

/// A cold shooting starts from a motion that has forgotten the start from rest.
void forget_rest(PeriodMap& map, FlowState& state, int subharmonic) {
  constexpr int kPeriods = 20;
  FlowRecord record;
  map.apply(state, kPeriods * subharmonic, record);
}

std::shared_ptr<const Trajectory> recorded(PeriodMap& map, const SteadyState& found) {
  FlowState state = found.start;
  FlowRecord record;
  record.dense = true;
  map.apply(state, found.order, record);
  return std::make_shared<EventTrajectory>(found.order * map.forcing_period(), found.start, record.pieces,
                                           std::move(record.events));
}

void search(const Problem& problem, const ContactDynamics& dynamics, const PeriodicMotionOptions& options,
            const Start& start, PeriodMap& map, Solution& solution) {
  const std::function<bool()> expired = [&start] { return start.expired(); };
  const SteadyLimits limits = limits_of(options, problem.subharmonic);
  FlowState state = first_state(problem, dynamics, start, map.flow());
  SteadyState found;
  try {
    if (options.shooting) {
      if (!start.guess) forget_rest(map, state, problem.subharmonic);
      found = shoot(map, state, problem.subharmonic, limits, expired);
    } else {
      found = march(map, state, limits, expired);
    }
  } catch (const std::exception&) {
    solution.work.rhs_evaluations = map.flow().rhs_evaluations();
    solution.work.iterations = map.periods();
    throw;
  }
  solution.verdict = found.periodic ? Verdict::converged : Verdict::not_converged;
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
  solution.work.unknowns = 2L * dynamics.size();
  try {
    EventFlow flow(
        dynamics, options.tolerance, [&start] { return start.expired(); }, options.integrator);
    PeriodMap map(flow);
    search(problem, dynamics, options, start, map, solution);
    solution.work.rhs_evaluations = flow.rhs_evaluations();
  } catch (const std::exception& error) {
    solution.verdict = Verdict::not_converged;
    solution.message = error.what();
  }
  return solution;
}

}  // namespace signorini
