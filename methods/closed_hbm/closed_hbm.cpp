#include "methods/closed_hbm/closed_hbm.hpp"

#include <memory>
#include <utility>

#include "methods/closed_hbm/closed_answer.hpp"
#include "methods/closed_hbm/closure_setup.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"

namespace signorini {

namespace {

/// A series whose impacts cannot be closed is not claimed: with few harmonics some rattle and are near no
/// orbit.
HarmonicSolve refused(const HarmonicSetup& setup, Solution series, const ClosedAnswer& closed,
                      const Work& work) {
  series.verdict = Verdict::not_converged;
  series.message = is_spent(setup.options.max_iterations, work) ? "the limit of max_iterations is reached"
                                                                : "impacts not closed: " + closed.reason;
  return {std::move(series), closed.harmonics_may_help};
}

/// The answer with impacts closed from the series of the projected equations, which has restitution 1.
HarmonicSolve close_own_series(const HarmonicSetup& setup, const ClosureSetup& closure, ClosedAnswer closed,
                               const Start& start, Work& work) {
  Solution series = solve_series(setup, start, work);
  if (series.verdict != Verdict::converged) return {std::move(series)};
  ClosedAnswer of_series = close_series(setup, closure, series, start, work);
  if (of_series.answer) return {*std::move(of_series.answer)};
  if (closed.reason.empty()) closed.reason = std::move(of_series.reason);
  closed.harmonics_may_help = true;  // a series may have other impacts with more of them
  return refused(setup, std::move(series), closed, work);
}

/// The series of a scene with impacts closed.
HarmonicSolve solve_closed(const HarmonicSetup& setup, ClosureSetup& closure, const Start& start,
                           Work& work) {
  if (!closure.obstacle.empty()) return refused(setup, {}, {.reason = closure.obstacle}, work);
  ClosedAnswer closed = close_answer(setup, closure, start, work);
  if (closed.answer) return {*std::move(closed.answer)};
  const bool spent = is_spent(setup.options.max_iterations, work);
  if (closure.restitution == 1.0 && !spent)
    return close_own_series(setup, closure, std::move(closed), start, work);
  return refused(setup, {}, closed, work);
}

}  // namespace

ClosedHbm::ClosedHbm(const Options& options)
    : ProjectedMethod({.harmonics = options.harmonics,
                       .tolerance = options.tolerance,
                       .max_iterations = options.max_iterations}),
      options_(options) {
  validate_constant(options_.c);
}

Support ClosedHbm::supports(const Problem& problem) const {
  if (Support one = supports_one_law(problem); has_impacts(problem) && !one.ok) return one;
  return ProjectedMethod::supports(problem);
}

RepresentedLaw ClosedHbm::law(const Problem& problem) const {
  const Law scene_law = problem.law();
  const auto* rigid = std::get_if<Restitution>(&scene_law);
  if (rigid == nullptr) return ProjectedMethod::law(problem);
  return Restitution{options_.restitution == ImpactLaw::scene ? rigid->e : 1.0};
}

HarmonicMethod ClosedHbm::preset(const Problem& problem) const {
  const auto law = [&problem, c = options_.c](const ContactReceptance& level) {
    return lipschitz_law(problem, c, level);
  };
  HarmonicMethod method = by_complementarity(law, common(), ComplementaritySolver::automatic);
  const ClosureSettings settings{.restitution = restitution_of(law_of_contact(this->law(problem), 0)),
                                 .constant_is_chosen = options_.c.has_value()};
  method.solver_of = [settings](const HarmonicSetup& setup) -> HarmonicSolver {
    std::optional<ClosureSetup> found = closure_setup(setup, settings);
    if (!found) return {};  // no impacts to close: the series is right as it is
    const auto closure = std::make_shared<ClosureSetup>(*std::move(found));
    return [&setup, closure](const Start& start, Work& work) {
      return solve_closed(setup, *closure, start, work);
    };
  };
  return method;
}

}  // namespace signorini
