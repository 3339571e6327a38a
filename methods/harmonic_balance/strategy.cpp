// The strategy of a Fourier solve. `solve_series` is the list of its attempts, in their order. The functions
// before it are those attempts that take a few lines; the others stand in the units included below. Why
// these, and in this order: docs/theory.md, section 4.

#include "methods/harmonic_balance/strategy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/harmonic_balance/distinct_stops.hpp"
#include "methods/harmonic_balance/frequency_continuation.hpp"
#include "methods/harmonic_balance/harmonic_continuation.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/harmonic_balance/stiffness_continuation.hpp"
#include "methods/refinement.hpp"
#include "methods/structure/mean_balance.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

/// The answer that Newton's method on the exactly projected equations found; nothing where it did not. Its
/// steps are added to `work`.
std::optional<Solution> answer_of(const HarmonicSetup& setup, const ExactProjection& found,
                                  const std::string& how, Work& work) {
  count_iterations(found.iterations, work);
  if (!found.converged) return std::nullopt;
  return exact_solution(setup.equations(), found, how);
}

/// Newton's method on the exactly projected equations from the guess (exact_projection). In a sweep this is
/// all that most solves need.
std::optional<Solution> newton_from_guess(const HarmonicSetup& setup, const Start& start, Work& work) {
  if (!start.guess || !setup.without_grid() || !setup.method.newton_from_guess) return std::nullopt;
  const int harmonics = setup.receptance.harmonics();
  const ExactProjection near =
      project_exactly(setup.equations(), carried_spectrum(setup.receptance, *start.guess),
                      {.samples = kCoarseSampling * std::max(harmonics, kFewestOnGrid),
                       .tolerance = setup.options.tolerance});
  return answer_of(setup, near, "Newton from the guess", work);
}

/// Contact that never opens (permanent_contact): one small solve per harmonic and a look at signs. It comes
/// before any path of pivots, which starts with every gap open and would meet rattling motions first.
std::optional<Solution> permanent_contact(const HarmonicSetup& setup, const Start& start) {
  if (start.guess || !setup.without_grid()) return std::nullopt;
  const ExactProjection closed = solve_permanent_contact(setup.equations(), setup.options.tolerance);
  if (!closed.converged) return std::nullopt;
  return exact_solution(setup.equations(), closed, "permanent contact");
}

/// The force to which the reduced structure marches, n = 0..H; empty where it finds no periodic motion. All
/// numbers of harmonics begin at one coarse march: of motions that coexist each fine one might end at
/// another.
Eigen::MatrixXcd marched_force(const HarmonicSetup& setup, const Start& start, Work& work) {
  const int harmonics = setup.receptance.harmonics(), coarse = kMarchedPerPeriod * setup.problem->subharmonic;
  ContactMarch march(*setup.marched, march_grid(*setup.problem, coarse));
  PeriodicMarch marched = march_to_periodic_motion(march, {.deadline = start.deadline});
  count_iterations(marched.newton_steps, work);
  if (const int fine = kCoarseSampling * harmonics; marched.found() && fine > coarse) {
    ContactMarch finer(*setup.marched, march_grid(*setup.problem, fine));
    marched = march_from(finer, marched.state, {.deadline = start.deadline});
    count_iterations(marched.newton_steps, work);
  }
  if (!marched.found()) return {};
  return force_spectrum(marched.force, {}, setup.receptance.period, harmonics);
}

/// Newton's method from the motion of the reduced structure (march_to_periodic_motion): at once, or where
/// that fails through stops on springs (continue_in_stiffness). What that costs does not grow with the nodes
/// in contact, as a path of pivots does.
std::optional<Solution> newton_from_march(const HarmonicSetup& setup, const Start& start, Work& work) {
  if (start.guess || !setup.marched || !setup.without_grid()) return std::nullopt;
  const Eigen::MatrixXcd force = marched_force(setup, start, work);
  if (force.size() == 0) return std::nullopt;
  ExactProjectionSettings settings{.samples = kResolvingSamples * setup.receptance.harmonics(),
                                   .tolerance = setup.options.tolerance,
                                   .most = 12,  // from a good start fewer do
                                   .deadline = start.deadline};
  const ExactProjection near = project_exactly(setup.equations(), force, settings);
  if (auto answer = answer_of(setup, near, "Newton from a march", work)) return answer;
  const ExactProjection continued = continue_in_stiffness(setup.equations(), force, settings);
  return answer_of(setup, continued, "a march, on springs first, Newton from there", work);
}

/// The first harmonics alone and a softer law, with nothing that stands beside a solve.
HarmonicSetup with_few_harmonics(const HarmonicSetup& setup, const ContinuationPoint& few) {
  ContactReceptance receptance = truncated(setup.receptance, few.harmonics);
  ProjectedLaw law = with_stiffness_factor(setup.method.law_at(receptance), few.stiffness_factor);
  return {.receptance = std::move(receptance),
          .gap = setup.gap,
          .method = setup.method,
          .options = setup.options,
          .law = std::move(law)};
}

/// The solution with few harmonics, as permanent contact or on grids; nothing where none is found.
std::optional<Solution> solve_few_harmonics(const HarmonicSetup& setup, const ContinuationPoint& few,
                                            const Start& start, Work& work) {
  const HarmonicSetup reduced = with_few_harmonics(setup, few);
  Work spent = setup.method.counts;
  std::optional<Solution> base = permanent_contact(reduced, start);
  if (!base) base = solve_on_grids(reduced, start, spent);
  add_effort(spent, work);
  if (base->verdict != Verdict::converged) return std::nullopt;
  return base;
}

/// Continuation in harmonics (harmonic_continuation): few of them are solved, and Newton's method carries
/// that solution up to all. A path of pivots gets long with the grid, while the equations themselves change
/// little from H to 2 H.
std::optional<Solution> continuation_in_harmonics(const HarmonicSetup& setup, const Start& start,
                                                  Work& work) {
  if (start.guess || !setup.without_grid()) return std::nullopt;
  const ContinuationPoint first = continuation_start(setup.receptance);
  if (first.harmonics == 0) return std::nullopt;
  const std::optional<Solution> base = solve_few_harmonics(setup, first, start, work);
  if (!base) return std::nullopt;
  const ExactProjection continued =
      continue_in_harmonics(setup.receptance, setup.gap, setup.method.law_at, first,
                            carried_spectrum(truncated(setup.receptance, first.harmonics), *base->trajectory),
                            setup.options.tolerance, start);
  return answer_of(setup, continued, fmt::format("{} harmonics first, Newton from there", first.harmonics),
                   work);
}

/// Continuation in frequency (frequency_continuation) where a plain form asks for it.
std::optional<Solution> continuation_in_frequency(const HarmonicSetup& setup, const Start& start,
                                                  Work& work) {
  const bool asked = setup.options.continuation == Continuation::frequency && setup.problem != nullptr;
  if (start.guess || !asked) return std::nullopt;
  return continue_in_frequency(setup, start, work);
}

/// A force to begin on grids at, (H+1) x Nc [N], and where it is from.
struct NearbyForce {
  Eigen::MatrixXcd lambda;
  const char* origin = "";
};

/// For a method that finds every answer on grids: the force to which the reduced structure marches; where it
/// cannot march, that of few harmonics. Nothing where unknowns are few.
std::optional<NearbyForce> nearby_force(const HarmonicSetup& setup, const Start& start, Work& work) {
  if (start.guess || !setup.method.on_grids_only || !setup.way_is_open()) return std::nullopt;
  if (setup.marched) {
    Eigen::MatrixXcd force = marched_force(setup, start, work);
    if (force.size() == 0) return std::nullopt;
    return NearbyForce{.lambda = std::move(force), .origin = "a march"};
  }
  const ContinuationPoint few = continuation_start(setup.receptance);
  if (few.harmonics == 0 || !setup.has_many_unknowns()) return std::nullopt;
  const std::optional<Solution> base = solve_few_harmonics(setup, few, start, work);
  if (!base) return std::nullopt;
  return NearbyForce{.lambda = carried_spectrum(setup.receptance, *base->trajectory),
                     .origin = "few harmonics"};
}

/// The method's own solver on grids, at first from a nearby force where there is one. Always ends with a
/// solution, converged or not.
Solution own_solver(const HarmonicSetup& setup, const Start& start, Work& work) {
  if (std::optional<NearbyForce> near = nearby_force(setup, start, work)) {
    Solution solution = solve_on_grids(setup, start, work, std::move(near->lambda));
    solution.message = fmt::format("from {}: {}", near->origin, solution.message);
    if (solution.verdict == Verdict::converged || start.expired()) return solution;
  }
  return solve_on_grids(setup, start, work);
}

/// A scene with one number of harmonics, which notes whether more of them may help. Without contacts the
/// linear response.
class WithHarmonics final : public PreparedMethod {
 public:
  WithHarmonics(HarmonicSetup setup, bool& more_may_help)
      : setup_(std::move(setup)), more_may_help_(more_may_help) {
    if (setup_.method.solver_of) solver_ = setup_.method.solver_of(setup_);
  }

  Solution solve(const Start& start) override {
    const ContactReceptance& receptance = setup_.receptance;
    if (receptance.contacts() == 0) return contact_free_response(receptance);
    Work work = setup_.method.counts;
    work.unknowns = (2L * receptance.harmonics() + 1) * receptance.contacts();
    HarmonicSolve solve = solver_ ? solver_(start, work) : HarmonicSolve{solve_series(setup_, start, work)};
    more_may_help_ = solve.harmonics_may_help;
    solve.solution.work = work;
    return std::move(solve.solution);
  }

 private:
  const HarmonicSetup setup_;  // where solver_ finds it
  HarmonicSolver solver_;
  bool& more_may_help_;
};

class HarmonicBalance final : public PreparedMethod {
 public:
  /// A stop that stands twice makes the equations of its forces singular, and no impact on it could be
  /// closed: the scene is solved with each stop once.
  HarmonicBalance(const Problem& problem, const HarmonicOptions& options, const HarmonicMethodFor& method_for)
      : stops_(distinct_stops(problem)), problem_(stops_ ? stops_->problem : problem) {
    const HarmonicMethod method = method_for(problem_);
    const AtResolution with_harmonics = [this, options, method](int harmonics) {
      return std::make_unique<WithHarmonics>(harmonic_setup(problem_, harmonics, options, method),
                                             more_may_help_);
    };
    const int first = options.first_harmonics(problem);
    const bool left_open = !options.harmonics && !options.plain && method.solver_is_open &&
                           options.grid_is_open(first) && problem_.contact_count() > 0;
    solver_ = left_open ? refined(first, with_harmonics) : with_harmonics(first);
  }

  Solution solve(const Start& start) override {
    if (!stops_) return solver_->solve(start);
    Start reduced = start;
    if (start.guess) reduced.guess = on_distinct_stops(start.guess, *stops_);
    Solution solution = solver_->solve(reduced);
    if (solution.trajectory) solution.trajectory = on_all_contacts(solution.trajectory, *stops_);
    return solution;
  }

 private:
  /// With more and more harmonics until two answers agree. One more doubling than the load needs is allowed,
  /// for one answer alone says nothing of its error.
  [[nodiscard]] std::unique_ptr<PreparedMethod> refined(int first, const AtResolution& with_harmonics) const {
    return refined_until_agreed(
        {rising_resolutions(first, 2, std::max(kMostHarmonics, 2 * first)), with_harmonics},
        {.resolution = "H",
         .worth_refining = [this](const Solution&) { return more_may_help_; },
         .only_confirmed = true,
         .least = size_at_rest(problem_)});
  }

  std::optional<DistinctStops> stops_;  ///< where some stop stands twice
  const Problem& problem_;              ///< with each stop once
  bool more_may_help_ = true;           ///< harmonics than the last solve had
  std::unique_ptr<PreparedMethod> solver_;
};

}  // namespace

Solution solve_series(const HarmonicSetup& setup, const Start& start, Work& work) {
  std::optional<Solution> series = newton_from_guess(setup, start, work);
  if (!series) series = permanent_contact(setup, start);
  if (!series) series = newton_from_march(setup, start, work);
  if (!series) series = continuation_in_harmonics(setup, start, work);
  if (!series) series = continuation_in_frequency(setup, start, work);
  if (!series) series = own_solver(setup, start, work);
  return *std::move(series);
}

std::unique_ptr<PreparedMethod> prepare_harmonic_balance(const Problem& problem,
                                                         const HarmonicOptions& options,
                                                         const HarmonicMethodFor& method_for) {
  return std::make_unique<HarmonicBalance>(problem, options, method_for);
}

}  // namespace signorini
