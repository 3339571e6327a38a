#include "moreau_jean.hpp"

#include "methods/discretisation/trajectories.hpp"

namespace siconos_rivals {

namespace {

class Prepared final : public signorini::PreparedMethod {
 public:
  Prepared(const signorini::Problem& problem, const MoreauJean::Options& options)
      : problem_(problem), options_(options), W_(contact_directions(problem)) {}

  // An impact takes place at the end of a step, so the state after a period jumps where the instant of an
  // impact passes from one step to the next. The periodic motion of a grid may fall into such a jump: then it
  // has none, and the state circles. A grid of one step more has its steps elsewhere.
  signorini::Solution solve(const signorini::Start& limits) override {
    constexpr int kPatience = 60;  // periods in which the change must halve once
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(problem_.size());
    const System system = system_of(problem_);
    SteadyState search({rest, rest}, options_.tolerance, options_.max_periods, limits);
    for (int steps = options_.steps; !search.over(); ++steps) {
      const double h = problem_.period() / steps;
      Stepping simulation(system, search.state(), h, (options_.max_periods + 1.0) * problem_.period(),
                          options_.theta);
      search.follow([&] { return period(simulation, steps, h); }, kPatience);
    }
    return search.solution();
  }

 private:
  [[nodiscard]] Period period(Stepping& simulation, int steps, double h) const {
    const int contacts = problem_.contact_count();
    Eigen::MatrixXd x(steps, contacts), force(steps, contacts);
    Period period;
    for (int k = 0; k < steps; ++k) {
      const State state = simulation.state();
      period.include(state);
      x.row(k) = (W_.transpose() * state.u).transpose();
      force.row(k) = -simulation.step().transpose() / h;
    }
    period.end = simulation.state();
    period.trajectory =
        std::make_shared<signorini::NodalTrajectory>(problem_.period(), std::move(x), std::move(force));
    return period;
  }

  const signorini::Problem& problem_;
  MoreauJean::Options options_;
  signorini::SparseMatrix W_;
};

}  // namespace

MoreauJean::MoreauJean(const Options& options) : options_(options) {
  using signorini::require_option;
  const Options& o = options;
  require_option(o.steps >= 4 && o.steps <= 1000000, "steps", o.steps, "must be from 4 to 1000000");
  require_option(o.theta >= 0.5 && o.theta <= 1.0, "theta", o.theta, "must be from 0.5 to 1");
  require_option(o.tolerance > 0.0 && o.tolerance <= 1e-2, "tolerance", o.tolerance, "must be in (0, 1e-2]");
  require_option(o.max_periods >= 1 && o.max_periods <= 1000000, "max_periods", o.max_periods,
                 "must be from 1 to 1000000");
}

std::unique_ptr<signorini::PreparedMethod> MoreauJean::prepare(const signorini::Problem& problem) const {
  return std::make_unique<Prepared>(problem, options_);
}

}  // namespace siconos_rivals
