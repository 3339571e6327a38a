#include "methods/closed_hbm/closed_hbm.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "methods/closed_hbm/closed_answer.hpp"
#include "methods/closed_hbm/closure_setup.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"

namespace signorini {

namespace {

/// The series of a scene with impacts closed, or where there are none to close, the series.
class ClosingSolver final : public HarmonicSolver {
 public:
  ClosingSolver(HarmonicSetup setup, const ClosureSettings& settings)
      : HarmonicSolver(std::move(setup)), closure_(closure_setup(this->setup(), settings)) {}

 private:
  HarmonicSolve solve_contacts(const Start& start, Work& work) override {
    if (!closure_) return {solve_series(setup(), start, work)};
    if (!closure_->obstacle.empty()) return refused({}, {.reason = closure_->obstacle}, work);
    ClosedAnswer closed = close_answer(setup(), *closure_, start, work);
    if (closed.answer) return {*std::move(closed.answer)};
    const bool spent = is_spent(setup().options.max_iterations, work);
    if (closure_->restitution == 1.0 && !spent) return close_own_series(std::move(closed), start, work);
    return refused({}, closed, work);
  }

  /// The same from the series of the projected equations, which has restitution 1.
  HarmonicSolve close_own_series(ClosedAnswer closed, const Start& start, Work& work) {
    Solution series = solve_series(setup(), start, work);
    if (series.verdict != Verdict::converged) return {std::move(series)};
    ClosedAnswer of_series = close_series(setup(), *closure_, series, start, work);
    if (of_series.answer) return {*std::move(of_series.answer)};
    if (closed.reason.empty()) closed.reason = std::move(of_series.reason);
    closed.harmonics_may_help = true;  // a series may have other impacts with more of them
    return refused(std::move(series), closed, work);
  }

  /// A series whose impacts cannot be closed is not claimed: with few harmonics some rattle and are near no
  /// orbit.
  [[nodiscard]] HarmonicSolve refused(Solution series, const ClosedAnswer& closed, const Work& work) const {
    series.verdict = Verdict::not_converged;
    series.message = is_spent(setup().options.max_iterations, work) ? "the limit of max_iterations is reached"
                                                                    : "impacts not closed: " + closed.reason;
    return {std::move(series), closed.harmonics_may_help};
  }

  std::optional<ClosureSetup> closure_;  ///< nothing where there are no impacts to close
};

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

double ClosedHbm::restitution(const Restitution& law) const {
  return options_.restitution == ImpactLaw::scene ? law.e : 1.0;
}

RepresentedLaw ClosedHbm::law(const Problem& problem) const {
  const Law scene_law = problem.law();
  const auto* rigid = std::get_if<Restitution>(&scene_law);
  if (rigid != nullptr) return Restitution{restitution(*rigid)};
  return ProjectedMethod::law(problem);
}

HarmonicMethod ClosedHbm::preset(const Problem& problem) const {
  const auto law = [&problem, c = options_.c](const ContactReceptance& level) {
    return lipschitz_law(problem, c, level);
  };
  return by_complementarity(law, common(), ComplementaritySolver::automatic);
}

MakeHarmonicSolver ClosedHbm::solver_of(const Problem& problem) const {
  const Law scene_law = problem.law();
  const auto* rigid = std::get_if<Restitution>(&scene_law);
  const ClosureSettings settings{.restitution = rigid != nullptr ? restitution(*rigid) : 1.0,
                                 .constant_is_chosen = options_.c.has_value()};
  return
      [settings](HarmonicSetup setup) { return std::make_unique<ClosingSolver>(std::move(setup), settings); };
}

}  // namespace signorini
