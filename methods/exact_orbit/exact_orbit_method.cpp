#include "methods/exact_orbit/exact_orbit_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/lcp_grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"
#include "methods/hat_functions/hat_contact.hpp"
#include "methods/linear_flow/linear_flows.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "methods/structure/condensation.hpp"

namespace signorini {

namespace {

bool conservative(const Problem& problem) {
  const auto* law = std::get_if<Restitution>(&problem.law);
  return law == nullptr || law->e == 1.0;
}

/// One attempt of the search: where the motion comes from whose orbit is looked for.
struct Attempt {
  enum class Source {
    grid,     ///< pivoting on `samples` nodes, with the covering vector number `cover`
    fourier,  ///< the projected Fourier equations
    flow,     ///< shooting and marching from the first motion found
  };
  Source source = Source::grid;
  int samples = 0;
  int cover = 0;  ///< 0: the constant one

  [[nodiscard]] std::string name() const {
    if (source == Source::fourier) return "Fourier";
    if (source == Source::flow) return "shooting and marching";
    return cover == 0 ? fmt::format("N = {}", samples) : fmt::format("N = {}, cover {}", samples, cover);
  }
};

class PreparedExactOrbit final : public PreparedMethod {
 public:
  PreparedExactOrbit(const Problem& problem, const ExactOrbitMethod::Options& options)
      : problem_(problem), options_(options), coarse_(grid({.samples = options.samples})) {}

  Solution solve(const Start& start) override {
    tried_.clear();
    best_.reset();
    first_.reset();
    name_.clear();
    work_ = {};
    try {
      finder_.emplace(problem_);  // anew: the flows that it keeps are part of every cold solve
      search(start);
    } catch (const std::exception& error) {  // a coarse grid that cannot be factorised
      tried_.emplace_back(error.what());
    }
    return finish();
  }

 private:
  // The algorithm: a motion from each source in turn, until one leads to an orbit. The first attempt, which
  // is enough nearly always, is not part of the list, and needs none to be made.
  void search(const Start& start) {
    if (start.guess && polish(*start.guess, "the guess", start)) return;
    if (attempt({.samples = options_.samples}, start)) return;
    for (const Attempt& next : further_attempts()) {
      if (attempt(next, start)) return;
    }
  }

  // Other paths of pivots on the coarse grid, then finer grids, each with its paths but for the last; other
  // equations; the flow itself.
  [[nodiscard]] std::vector<Attempt> further_attempts() const {
    std::vector<Attempt> attempts;
    int samples = options_.samples;
    for (int level = 0; level <= options_.refinements; ++level, samples *= 4) {
      if (level > 0) attempts.push_back({.samples = samples});
      if (level > 0 && level == options_.refinements) break;
      for (int cover = 1; cover <= options_.restarts; ++cover)
        attempts.push_back({.samples = samples, .cover = cover});
    }
    if (conservative(problem_)) attempts.push_back({.source = Attempt::Source::fourier});
    attempts.push_back({.source = Attempt::Source::flow});
    return attempts;
  }

  // True if the search has come to its end: an orbit is found, or the time is up.
  bool attempt(const Attempt& next, const Start& start) {
    if (next.source == Attempt::Source::flow) return shoot_and_march(next, start);
    const Solution motion = next.source == Attempt::Source::fourier ? projected(start)
                            : next.samples == options_.samples && next.cover == 0
                                ? coarse_->solve(cold(start))
                                : grid(next)->solve(cold(start));
    work_.pivots = work_.pivots.value_or(0) + motion.work.pivots.value_or(0);
    if (!motion.trajectory) {
      tried_.push_back(next.name() + ": " + motion.message);
      return false;
    }
    if (!first_) first_ = motion.trajectory;
    return polish(*motion.trajectory, next.name(), start);
  }

  bool polish(const Trajectory& motion, const std::string& name, const Start& start) {
    if (start.expired()) {
      tried_.emplace_back("the time budget is spent");
      return true;
    }
    return record(finder_->find(motion, settings(start)), name);
  }

  // The coarse problem on N nodes.
  [[nodiscard]] std::unique_ptr<PreparedMethod> grid(const Attempt& of) const {
    constexpr double kWave = 0.3;  // strong enough for another path
    HatSettings settings{.samples = of.samples};
    if (of.cover > 0) {
      settings.solver = ComplementaritySolver::pivoting;
      settings.cover_amplitude = kWave;
      settings.cover_phase = 2.0 * std::numbers::pi * of.cover / (options_.restarts + 1);
    }
    std::optional<double> restitution;
    if (const auto* law = std::get_if<Restitution>(&problem_.law)) restitution = law->e;
    return hat_contact(problem_, settings, restitution);
  }

  static Start cold(const Start& start) { return {.guess = {}, .deadline = start.deadline}; }

  bool shoot_and_march(const Attempt& last, const Start& start) {
    if (!first_) return false;
    SearchOptions options = settings(start);
    options.rounds = 1;
    options.shootings = 40;
    options.marched = options_.marching;
    return record(finder_->find(*first_, options), last.name());
  }

  // The projected Fourier equations; a structure that they cannot reduce is a failed attempt, not the end.
  Solution projected(const Start& start) const {
    try {
      return projected_solve(start);
    } catch (const std::runtime_error& error) {
      return {.message = error.what()};
    }
  }

  Solution projected_solve(const Start& start) const {
    const int harmonics = std::max(options_.samples / 4, load_bandwidth(problem_));
    const bool spring = std::holds_alternative<Penalty>(problem_.law);
    const auto law = [this, spring](const ContactReceptance& receptance) {
      return spring ? penalty_law(problem_, {}, receptance) : lipschitz_law(problem_, {}, receptance);
    };
    return prepare_harmonic_balance(problem_, {.harmonics = harmonics, .compensate = false},
                                    {.law_at = law, .grid_solver = lcp_grid_solver({})})
        ->solve(cold(start));
  }

  [[nodiscard]] SearchOptions settings(const Start& start) const {
    SearchOptions options;
    options.polish.tolerance = options_.tolerance;
    options.polish.max_iterations = options_.max_iterations;
    options.shootings = 15;
    options.expired = [&start] { return start.expired(); };
    return options;
  }

  bool record(OrbitSearch found, const std::string& name) {
    work_.iterations = work_.iterations.value_or(0) + found.iterations;
    const bool done = found.orbit.certified();
    if (!done) tried_.push_back(name + ": " + describe(found.orbit.outcome) + ", " + found.orbit.reason);
    if (done || !best_ || (found.orbit.trajectory && !best_->orbit.trajectory)) {
      best_ = std::move(found);
      name_ = name;
    }
    return done;
  }

  Solution finish() {
    Solution solution;
    if (finder_) work_.unknowns = 2L * finder_->model()->dynamics.size();
    solution.work = work_;
    if (best_) {
      const ExactOrbit& orbit = best_->orbit;
      solution.trajectory = orbit.trajectory;
      solution.residual = orbit.residual;
      if (orbit.trajectory) solution.condition = orbit.condition;
      if (orbit.certified()) {
        solution.verdict = Verdict::converged;
        *solution.work.unknowns += static_cast<long>(orbit.trajectory->orbit().events.size());
        solution.message =
            fmt::format("{}; from {} by {}; error bar {:.1e}, largest multiplier {:.6g}", orbit.reason, name_,
                        orbit.origin, orbit.error_bar, orbit.largest_multiplier());
        return solution;
      }
    }
    solution.message = fmt::format("no exact orbit: {}", fmt::join(tried_, "; "));
    return solution;
  }

  const Problem& problem_;
  ExactOrbitMethod::Options options_;
  std::optional<OrbitFinder> finder_;
  std::unique_ptr<PreparedMethod> coarse_;
  std::vector<std::string> tried_;
  std::optional<OrbitSearch> best_;
  std::string name_;
  std::shared_ptr<const Trajectory> first_;
  Work work_;
};

}  // namespace

ExactOrbitMethod::ExactOrbitMethod(const Options& options) : options_(options) {
  require_option(options.samples >= 8 && options.samples <= 100000, "samples", options.samples,
                 "must be from 8 to 100000");
  require_option(options.refinements >= 0 && options.refinements <= 4, "refinements", options.refinements,
                 "must be from 0 to 4");
  require_option(options.restarts >= 0 && options.restarts <= 16, "restarts", options.restarts,
                 "must be from 0 to 16");
  require_option(options.tolerance >= 1e-14 && options.tolerance <= 1e-6, "tolerance", options.tolerance,
                 "must be in [1e-14, 1e-6]");
  require_option(options.max_iterations >= 1, "max_iterations", options.max_iterations, "must be at least 1");
  require_option(options.marching >= 0, "marching", options.marching, "must be 0 or more");
}

Support ExactOrbitMethod::supports(const Problem& problem) const {
  if (problem.size() > kMostInDenseFlow) {
    return {false, fmt::format("{} coordinates: the closed-form flow is dense, at most {}", problem.size(),
                               kMostInDenseFlow)};
  }
  const int needed = load_bandwidth(problem);
  if (2 * needed >= options_.samples) {
    return {false,
            fmt::format("the load reaches harmonic {} of the motion's base frequency: samples = {} cannot "
                        "resolve it",
                        needed, options_.samples)};
  }
  if (const std::string obstacle = flow_obstacle(problem); !obstacle.empty()) return {false, obstacle};
  return {};
}

RepresentedLaw ExactOrbitMethod::law(const Problem& problem) const { return as_represented(problem.law); }

std::unique_ptr<PreparedMethod> ExactOrbitMethod::prepare(const Problem& problem) const {
  return std::make_unique<PreparedExactOrbit>(problem, options_);
}

}  // namespace signorini
