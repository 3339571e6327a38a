#include "event_driven.hpp"

#include <algorithm>

namespace siconos_rivals {

namespace {

class Prepared final : public signorini::PreparedMethod {
 public:
  Prepared(const signorini::Problem& problem, const EventDriven::Options& options)
      : problem_(problem), options_(options), W_(contact_directions(problem)) {}

  signorini::Solution solve(const signorini::Start& limits) override {
    Events simulation(system_of(problem_), problem_.period() / options_.samples,
                      (options_.max_periods + 1.0) * problem_.period());
    SteadyState search(simulation.state(), options_.tolerance, options_.max_periods, limits);
    int done = 0;
    search.follow([&] { return period(simulation, done++); }, options_.max_periods);
    return search.solution();
  }

 private:
  // From t = number * period, where the simulation is, to that of the next number.
  [[nodiscard]] Period period(Events& simulation, int number) const {
    const double begin = number * problem_.period();
    std::vector<KnottedTrajectory::Knot> knots{knot(simulation, 0.0)};
    std::vector<signorini::Impulse> impulses;
    Period period;
    for (int instants = 0; instants < options_.samples;) {
      const Events::Arrival arrival = simulation.advance();
      const double time = std::clamp(arrival.time - begin, 0.0, problem_.period());
      if (arrival.at_stop) knots.push_back(knot(simulation, time));
      const Eigen::VectorXd impulse = simulation.process();
      knots.push_back(knot(simulation, time));
      for (int j = 0; j < impulse.size(); ++j) {
        if (impulse[j] > 0.0) impulses.push_back({.contact = j, .time = time, .value = -impulse[j]});
      }
      if (!arrival.at_stop) ++instants;
      period.include(simulation.state());
    }
    knots.back().time = problem_.period();
    period.end = simulation.state();
    period.trajectory =
        std::make_shared<KnottedTrajectory>(problem_.period(), std::move(knots), std::move(impulses));
    return period;
  }

  [[nodiscard]] KnottedTrajectory::Knot knot(const Events& simulation, double time) const {
    const State state = simulation.state();
    return {.time = time,
            .x = W_.transpose() * state.u,
            .v = W_.transpose() * state.v,
            .force = -simulation.pressure()};
  }

  const signorini::Problem& problem_;
  EventDriven::Options options_;
  signorini::SparseMatrix W_;
};

}  // namespace

EventDriven::EventDriven(const Options& options) : options_(options) {
  using signorini::require_option;
  const Options& o = options;
  require_option(o.tolerance > 0.0 && o.tolerance <= 1e-2, "tolerance", o.tolerance, "must be in (0, 1e-2]");
  require_option(o.samples >= 16 && o.samples <= 65536, "samples", o.samples, "must be from 16 to 65536");
  require_option(o.max_periods >= 1 && o.max_periods <= 1000000, "max_periods", o.max_periods,
                 "must be from 1 to 1000000");
}

std::unique_ptr<signorini::PreparedMethod> EventDriven::prepare(const signorini::Problem& problem) const {
  return std::make_unique<Prepared>(problem, options_);
}

}  // namespace siconos_rivals
