#include "methods/exact_orbit/exact_orbit_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "methods/complementarity/projected_law.hpp"
#include "methods/exact_orbit/exact_diagram.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"
#include "methods/hat_functions/hat_contact.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "methods/marching/contact_march.hpp"
#include "methods/orbit/bifurcation_curves/bifurcation_curve.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "methods/orbit/reduced/failed_attempts.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"
#include "methods/structure/bases/condensation.hpp"

namespace signorini {

namespace {

// One attempt of the search: a name for messages, and the motion whose orbit is looked for.
struct Attempt {
  std::string name;
  std::function<Solution()> motion;
};

// Nodes of a coarse grid over the harmonics that take its place.
constexpr int kSamplesPerHarmonic = 4;

// Nodes of the first coarse grid: as many as asked for, times 4 until they resolve the load and the turns of
// several contacts.
int first_grid(const Problem& problem, int samples) {
  const int least = marches_several(problem) ? kMarchedPerPeriod * problem.subharmonic : 0;
  while (samples < least || !grid_support(problem, samples).ok) samples *= 4;
  return samples;
}

// A cold start with a quarter of the time that is left: of several contacts a path of pivots may take all.
Start quarter_of(const Start& start) {
  return {.guess = {}, .deadline = Deadline::after(std::max(0.0, start.deadline.left() / 4.0))};
}

// A motion by harmonic balance. A structure that cannot be reduced is a failed attempt, not the end.
Solution series_motion(const Problem& problem, int harmonics, const Start& start) {
  const bool spring = std::holds_alternative<Penalty>(problem.law());
  const auto method_for = [spring](const Problem& solved) -> HarmonicMethod {
    const auto law = [&solved, spring](const ContactReceptance& receptance) {
      return spring ? penalty_law(solved, {}, receptance) : lipschitz_law(solved, {}, receptance);
    };
    return {.law_at = law, .grid_solver = lcp_grid_solver({})};
  };
  try {
    const HarmonicOptions options{.harmonics = std::max(harmonics, load_bandwidth(problem))};
    return prepare_harmonic_balance(problem, options, method_for)->solve(start);
  } catch (const std::runtime_error& error) {
    return {.message = error.what()};
  }
}

SearchOptions search_options(const ExactOrbitMethod::Options& options, const Start& start) {
  return {.polish = {.tolerance = options.tolerance, .max_iterations = options.max_iterations},
          .shootings = 15,
          .expired = [&start] { return start.expired(); }};
}

class PreparedExactOrbit final : public PreparedMethod {
 public:
  PreparedExactOrbit(const Problem& problem, const ExactOrbitMethod::Options& options)
      : problem_(problem), options_(options) {}

  Solution solve(const Start& start) override {
    progress_ = {};
    try {
      progress_.finder.emplace(problem_);  // anew: the flows that it keeps are part of every cold solve
      search(start);
    } catch (const std::exception& error) {  // a coarse grid that cannot be factorised
      progress_.failed.note(grid_name(first_samples_, 0), error.what());
    }
    return finish();
  }

 private:
  // What one solve has come to.
  struct Progress {
    std::optional<OrbitFinder> finder = {};
    FailedAttempts failed = {};
    std::optional<ExactOrbit> best = {};                // the orbit, or what came nearest to one
    std::string name = {};                              // of the attempt that led there
    std::shared_ptr<const Trajectory> first = nullptr;  // motion found
    Work work = {};
  };

  // The algorithm: a motion from each source in turn, until one leads to an orbit; then the flow itself, from
  // the first motion found. The first attempt is enough nearly always; its grid is prepared once.
  void search(const Start& start) {
    const Start cold{.guess = {}, .deadline = start.deadline};
    SearchOptions last = search_options(options_, start);
    last.free_families = FreeFamilies::last;
    if (start.guess && polish(*start.guess, "the guess", last)) return;
    SearchOptions each = last, first = last;
    if (several_)
      each.rounds = first.rounds = 1;  // a finer grid tells more than the flow from an unstable motion
    else
      first.followed = std::min(32, options_.marching);  // less than a shooting takes, and enough most often
    const Start coarse = several_ ? quarter_of(cold) : cold;
    if (attempt({grid_name(first_samples_, 0), [&] { return coarse_->solve(coarse); }}, first)) return;
    for (const Attempt& next : further_attempts(cold)) {
      if (attempt(next, each)) return;
    }
    if (!progress_.first) return;
    last.rounds = 1;
    last.shootings = 40;
    last.marched = options_.marching;
    polish(*progress_.first, "shooting and marching", last);
  }

  // Other paths of pivots on the coarse grid, then finer grids, each with its paths but for the last; other
  // equations. Of several contacts, whose paths are long, harmonic balance from the march, where it resolves
  // phases of contact that the coarse grid does not, then finer grids alone.
  [[nodiscard]] std::vector<Attempt> further_attempts(const Start& cold) const {
    std::vector<Attempt> attempts;
    const auto add_grid = [&](int samples, int cover) {
      attempts.push_back({grid_name(samples, cover),
                          [this, &cold, samples, cover] { return grid(samples, cover)->solve(cold); }});
    };
    const Attempt series{"harmonic balance", [this, &cold] {
                           return series_motion(problem_, first_samples_ / kSamplesPerHarmonic,
                                                several_ ? quarter_of(cold) : cold);
                         }};
    if (several_) attempts.push_back(series);
    int samples = first_samples_;
    for (int level = 0; level <= options_.refinements; ++level, samples *= 4) {
      if (level > 0) add_grid(samples, 0);
      if (several_ || (level > 0 && level == options_.refinements)) continue;
      for (int cover = 1; cover <= options_.restarts; ++cover) add_grid(samples, cover);
    }
    const Law scene_law = problem_.law();
    const auto* law = std::get_if<Restitution>(&scene_law);  // the series know no other restitution than 1
    if (!several_ && (law == nullptr || law->e == 1.0)) attempts.push_back(series);
    return attempts;
  }

  // True if the search has come to its end: an orbit is found, or the time is up.
  bool attempt(const Attempt& next, const SearchOptions& options) {
    const Solution motion = next.motion();
    progress_.work.pivots = progress_.work.pivots.value_or(0) + motion.work.pivots.value_or(0);
    if (!motion.trajectory) {
      progress_.failed.note(next.name, motion.message);
      return false;
    }
    if (!progress_.first) progress_.first = motion.trajectory;
    return polish(*motion.trajectory, next.name, options);
  }

  bool polish(const Trajectory& motion, const std::string& name, const SearchOptions& options) {
    if (options.expired()) {
      progress_.failed.note(name, "the time budget is spent");
      return true;
    }
    OrbitSearch found = progress_.finder->find(motion, options);
    progress_.work.iterations = progress_.work.iterations.value_or(0) + found.iterations;
    ExactOrbit& orbit = found.orbit;
    const bool done = orbit.certified();
    if (!done) progress_.failed.note(name, fmt::format("{}, {}", describe(orbit.outcome), orbit.reason));
    std::optional<ExactOrbit>& best = progress_.best;
    if (done || !best || (orbit.trajectory && !best->trajectory)) {
      best = std::move(orbit);
      progress_.name = name;
    }
    return done;
  }

  static std::string grid_name(int samples, int cover) {
    return cover == 0 ? fmt::format("N = {}", samples) : fmt::format("N = {} (cover {})", samples, cover);
  }

  // The coarse problem on N nodes, with the covering vector of that number: the constant one is 0.
  [[nodiscard]] std::unique_ptr<PreparedMethod> grid(int samples, int cover) const {
    HatSettings settings{.samples = samples};
    if (cover > 0) {
      settings.solver = ComplementaritySolver::pivoting;
      settings.cover_amplitude = 0.3;  // strong enough for another path
      settings.cover_phase = 2.0 * std::numbers::pi * cover / (options_.restarts + 1);
    }
    if (several_ && samples > first_samples_) settings.scheme = HatScheme::bdf2;  // its march is linear in N
    return hat_contact(problem_, settings, scene_restitution(problem_));
  }

  Solution finish() {
    Solution solution{.work = progress_.work};
    if (progress_.finder) solution.work.unknowns = progress_.finder->model()->dynamics.states();
    solution.message = "no exact orbit: " + progress_.failed.text();
    if (!progress_.best) return solution;
    const ExactOrbit& orbit = *progress_.best;
    solution.trajectory = orbit.trajectory;
    solution.residual = orbit.residual;
    if (orbit.trajectory) solution.condition = orbit.condition;
    if (!orbit.certified()) return solution;
    solution.verdict = Verdict::converged;
    *solution.work.unknowns += static_cast<long>(orbit.trajectory->orbit().events.size());
    solution.message = fmt::format("{}; from {} by {}; error bar {:.1e}, {}", orbit.reason, progress_.name,
                                   orbit.origin, orbit.error_bar, orbit.describe_multipliers());
    return solution;
  }

  const Problem& problem_;
  ExactOrbitMethod::Options options_;
  const bool several_ = marches_several(problem_);                    // contacts that are marched
  const int first_samples_ = first_grid(problem_, options_.samples);  // N
  const std::unique_ptr<PreparedMethod> coarse_ = grid(first_samples_, 0);
  Progress progress_;
};

// Structures too large for a closed form, by orbits of what their contacts feel.
class PreparedReducedOrbit final : public PreparedMethod {
 public:
  PreparedReducedOrbit(const Problem& problem, const ExactOrbitMethod::Options& options)
      : problem_(&problem), options_(options), space_(problem) {
    if (!space_.obstacle().empty()) throw std::runtime_error(space_.obstacle());
  }

  Solution solve(const Start& start) override {
    OrbitCorrectionSettings settings{.search = search_options(options_, start)};
    settings.search.marched = options_.marching;
    Solution solution;
    try {
      ReducedOrbit found = find(start, settings);
      take(found, solution);
      last_ = std::move(found.corrected.space);
    } catch (const std::exception& error) {  // a mode whose flow cannot be formed, or no memory in a growth
      solution.message = fmt::format("no exact orbit: {}", error.what());
      whole_ = false;
    }
    if (space_.release()) whole_ = false;  // the judge makes one of its own
    return solution;
  }

  bool take_frequency(const Problem& problem) override {
    if (!whole_) return false;  // it would be made anew
    ContactSpace space = space_.of(problem);
    near_ = last_ ? std::optional(last_->of(problem)) : std::nullopt;
    space_ = std::move(space);
    problem_ = &problem;
    return true;
  }

 private:
  // From the guess, on the vectors of the orbit at the frequency before, then on those that its force needs,
  // and where it leads to no orbit with a bar, by marching from rest.
  [[nodiscard]] ReducedOrbit find(const Start& start, const OrbitCorrectionSettings& settings) const {
    if (!start.guess) return find_cold(start, settings);
    long iterations = 0;
    if (near_) {
      ReducedOrbit near = continue_reduced_orbit(*problem_, *near_, *start.guess, settings);
      if (near.corrected.bar || start.expired()) return near;
      iterations = near.iterations;
    }
    ReducedOrbit found = polish_reduced_orbit(*problem_, space_, *start.guess, settings);
    if (!found.corrected.bar && !start.expired()) {
      iterations += found.iterations;
      const std::string of_guess = found.reason();
      found = find_cold(start, settings);
      found.failed.note("the guess", of_guess);
    }
    found.iterations += iterations;
    return found;
  }

  // Of larger structures, whose contacts may be hundreds, a series costs more than finer grids.
  [[nodiscard]] ReducedOrbit find_cold(const Start& start, const OrbitCorrectionSettings& settings) const {
    const OtherStart series = [&] {
      const int harmonics = kMarchedPerPeriod * problem_->subharmonic / kSamplesPerHarmonic;
      return series_motion(*problem_, harmonics, quarter_of(start));
    };
    return find_reduced_orbit(*problem_, space_, settings,
                              problem_->size() <= kMostInDenseFlow ? series : OtherStart());
  }

  void take(const ReducedOrbit& found, Solution& solution) const {
    const CorrectedOrbit& corrected = found.corrected;
    const ExactOrbit& orbit = corrected.orbit;
    const long vectors = corrected.solved;
    solution.work.iterations = found.iterations;
    solution.work.unknowns = 2 * vectors;
    if (orbit.trajectory) *solution.work.unknowns += std::ssize(orbit.trajectory->acting_contacts());
    solution.trajectory = orbit.trajectory;
    solution.residual = orbit.residual;
    if (!corrected.bar) {
      solution.message = fmt::format("no exact orbit of the structure reduced to {} vectors: {}", vectors,
                                     found.failed.text().empty() ? found.reason() : found.failed.text());
      return;
    }
    solution.verdict = Verdict::converged;
    solution.condition = orbit.condition;
    solution.message =
        fmt::format("{}, on {} vectors by {}; {} corrections by {} vectors; error bar {:.1e}, {}",
                    orbit.reason, vectors, found.start, corrected.defects.size() - 1, corrected.vectors,
                    *corrected.bar, orbit.describe_multipliers());
  }

  const Problem* problem_;
  ExactOrbitMethod::Options options_;
  ContactSpace space_;
  std::optional<ContactSpace> near_ = {};  // of the last orbit at the frequency before, if it has a bar
  std::optional<ContactSpace> last_ = {};  // of the last orbit
  bool whole_ = true;                      // the space, after all solves so far
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
  if (prefers_reduction(problem)) return {.ok = true, .reason = {}};
  if (problem.size() > kMostInDenseFlow) {
    return {false, fmt::format("{} coordinates: the closed-form flow is dense, at most {}; {}",
                               problem.size(), kMostInDenseFlow, reduction_obstacle(problem))};
  }
  const std::string obstacle = flow_obstacle(problem);
  return {.ok = obstacle.empty(), .reason = obstacle};
}

RepresentedLaw ExactOrbitMethod::law(const Problem& problem) const { return as_represented(problem.law()); }

std::unique_ptr<PreparedMethod> ExactOrbitMethod::prepare(const Problem& problem) const {
  if (prefers_reduction(problem)) return std::make_unique<PreparedReducedOrbit>(problem, options_);
  return std::make_unique<PreparedExactOrbit>(problem, options_);
}

Support ExactOrbitMethod::follows(const ParametrisedScene& scene) const {
  const Problem problem = scene.at(scene.middle());
  if (scene.parameter == kEnergy && highest_load_harmonic(problem) > 0)
    return {.ok = false, .reason = "a periodic load gives its motions an energy that they do not keep"};
  const std::string obstacle = continuation_obstacle(problem);
  return {.ok = obstacle.empty(), .reason = obstacle};
}

BranchDiagram ExactOrbitMethod::follow(const ParametrisedScene& scene, const CurveLimits& limits) const {
  try {
    return exact_diagram(scene, *this, limits).told();
  } catch (const std::runtime_error& error) {  // of a structure that cannot be factorised
    return {.unfinished = error.what()};
  }
}

std::optional<BranchDiagram> ExactOrbitMethod::follow_bifurcations(const ScenePlane& plane, SpecialKind kind,
                                                                   const CurveLimits& limits) const {
  if (!has_curve(kind)) return std::nullopt;
  try {
    CurveLimits of_diagram = limits;
    of_diagram.take = {};
    const OrbitDiagram diagram = exact_diagram(plane.at(plane.from), *this, of_diagram);
    BranchDiagram found{.branches = bifurcation_curves(plane, diagram, kind, limits),
                        .unfinished = diagram.unfinished};
    if (found.branches.empty() && found.unfinished.empty()) found.unfinished = why_none(plane, kind);
    return found;
  } catch (const std::runtime_error& error) {
    return BranchDiagram{.unfinished = error.what()};
  }
}

}  // namespace signorini
