#include "methods/event_driven/event_driven.hpp"

#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/periodic_motion/periodic_motion.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/rigid_motions.hpp"

namespace signorini {

namespace {

class PreparedEventDriven final : public PreparedMethod {
 public:
  PreparedEventDriven(const Problem& problem, const EventDriven::Options& options)
      : problem_(with_idle_parts_held(problem).value_or(problem)), options_(options), dynamics_(problem_) {}

  Solution solve(const Start& start) override {
    return find_periodic_motion(problem_, dynamics_,
                                {.tolerance = options_.tolerance,
                                 .shooting = options_.steady == EventDriven::Steady::shooting,
                                 .integrator = options_.flow,
                                 .max_iterations = options_.max_iterations,
                                 .max_order = options_.max_order},
                                start);
  }

 private:
  Problem problem_;
  EventDriven::Options options_;
  ContactDynamics dynamics_;
};

}  // namespace

EventDriven::EventDriven(const Options& options) : options_(options) {
  require_option(options.tolerance >= 1e-13 && options.tolerance <= 1e-3, "tolerance", options.tolerance,
                 "must be in [1e-13, 1e-3]");
  require_option(options.max_iterations >= 1, "max_iterations", options.max_iterations, "must be at least 1");
  require_option(options.max_order >= 1 && options.max_order <= 64, "max_order", options.max_order,
                 "must be in 1..64");
}

Support EventDriven::supports(const Problem& problem) const {
  const std::string obstacle = flow_obstacle(problem);
  return {.ok = obstacle.empty(), .reason = obstacle};
}

RepresentedLaw EventDriven::law(const Problem& problem) const { return as_represented(problem.law()); }

std::unique_ptr<PreparedMethod> EventDriven::prepare(const Problem& problem) const {
  return std::make_unique<PreparedEventDriven>(problem, options_);
}

}  // namespace signorini
