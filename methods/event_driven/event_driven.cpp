#include "methods/event_driven/event_driven.hpp"

#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "methods/event_driven/steady_state.hpp"
#include "methods/flow/event_trajectory.hpp"
#include "methods/flow/flow.hpp"
#include "methods/structure/condensation.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

class PreparedEventDriven final : public PreparedMethod {
 public:
  PreparedEventDriven(const Problem& problem, const EventDriven::Options& options)
      : problem_(problem), options_(options), dynamics_(problem) {}

  Solution solve(const Start& start) override {
    Solution solution;
    solution.work.unknowns = 2L * dynamics_.size();
    try {
      const std::function<bool()> expired = [&start] { return start.expired(); };
      EventFlow flow(dynamics_, options_.tolerance, expired, options_.flow);
      PeriodMap map(flow);
      run(start, map, expired, solution);
      solution.work.rhs_evaluations = flow.rhs_evaluations();
    } catch (const std::exception& error) {
      solution.verdict = Verdict::not_converged;
      solution.message = error.what();
    }
    return solution;
  }

 private:
  void run(const Start& start, PeriodMap& map, const std::function<bool()>& expired,
           Solution& solution) const {
    constexpr double kCvodeNoise = 5e-11, kModalNoise = 1e-12;
    const SteadyLimits limits{.tolerance = options_.tolerance,
                              .max_iterations = options_.max_iterations,
                              .max_order = std::max(options_.max_order, problem_.subharmonic),
                              .noise = options_.flow == Integrator::cvode ? kCvodeNoise : kModalNoise};
    FlowState state = first_state(start, map.flow());
    SteadyState found;
    try {
      if (options_.steady == EventDriven::Steady::marching) {
        found = march(map, state, limits, expired);
      } else {
        if (!start.guess) warm_up(map, state);
        found = shoot(map, state, problem_.subharmonic, limits, expired);
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

  // A cold shooting starts from a motion that has forgotten the start from rest.
  void warm_up(PeriodMap& map, FlowState& state) const {
    constexpr int kPeriods = 20;
    FlowRecord record;
    map.apply(state, kPeriods * problem_.subharmonic, record);
  }

  [[nodiscard]] FlowState first_state(const Start& start, const EventFlow& flow) const {
    if (!start.guess) {
      const Eigen::VectorXd zero = Eigen::VectorXd::Zero(dynamics_.size());
      return flow.place(0.0, {.u = zero, .v = zero});
    }
    const auto* own = dynamic_cast<const EventTrajectory*>(start.guess.get());
    if (own != nullptr && own->start().state.u.size() == dynamics_.size()) {
      return flow.place(std::fmod(own->start().time, dynamics_.forcing_period()), own->start().state);
    }
    return flow.place(0.0, dynamics_.with_mass(PeriodicResponse(problem_, *start.guess).at(0.0)));
  }

  [[nodiscard]] static std::shared_ptr<const Trajectory> recorded(PeriodMap& map, const SteadyState& found) {
    FlowState state = found.start;
    FlowRecord record;
    record.dense = true;
    map.apply(state, found.order, record);
    return std::make_shared<EventTrajectory>(found.order * map.forcing_period(), found.start, record.pieces,
                                             std::move(record.events));
  }

  const Problem& problem_;
  EventDriven::Options options_;
  ContactDynamics dynamics_;
};

}  // namespace

EventDriven::EventDriven(const Options& options) : options_(options) {
  constexpr double kTightest = 1e-13, kLoosest = 1e-3;
  constexpr int kLargestOrder = 64;
  require_option(options.tolerance >= kTightest && options.tolerance <= kLoosest, "tolerance",
                 options.tolerance, "must be in [1e-13, 1e-3]");
  require_option(options.max_iterations >= 1, "max_iterations", options.max_iterations, "must be at least 1");
  require_option(options.max_order >= 1 && options.max_order <= kLargestOrder, "max_order", options.max_order,
                 "must be in 1..64");
}

Support EventDriven::supports(const Problem& problem) const {
  if (const std::string obstacle = flow_obstacle(problem); !obstacle.empty()) {
    return {.ok = false, .reason = obstacle};
  }
  return {};
}

RepresentedLaw EventDriven::law(const Problem& problem) const {
  return std::visit([](const auto& law) -> RepresentedLaw { return law; }, problem.law);
}

std::unique_ptr<PreparedMethod> EventDriven::prepare(const Problem& problem) const {
  return std::make_unique<PreparedEventDriven>(problem, options_);
}

}  // namespace signorini
