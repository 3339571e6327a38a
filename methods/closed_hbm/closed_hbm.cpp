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

ClosedHbm::ClosedHbm(const Options& options) : options_(options) {
  validate(common());
  require_option(!options_.c || *options_.c > 0.0, "c", options_.c, "must be positive, or auto");
}

HarmonicOptions ClosedHbm::common() const {
  return {.harmonics = options_.harmonics,
          .tolerance = options_.tolerance,
          .max_iterations = options_.max_iterations};
}

Support ClosedHbm::supports(const Problem& problem) const { return supports_harmonics(problem, common()); }

double ClosedHbm::restitution(const Restitution& law) const {
  return options_.restitution == ImpactLaw::scene ? law.e : 1.0;
}

RepresentedLaw ClosedHbm::law(const Problem& problem) const {
  const auto* rigid = std::get_if<Restitution>(&problem.law);
  if (rigid != nullptr) return Restitution{restitution(*rigid)};
  return projected_method_law(problem);
}

std::unique_ptr<PreparedMethod> ClosedHbm::prepare(const Problem& problem) const {
  const HarmonicOptions shared = common();
  const auto* rigid = std::get_if<Restitution>(&problem.law);
  const ClosureSettings settings{.restitution = rigid != nullptr ? restitution(*rigid) : 1.0,
                                 .constant_is_chosen = options_.c.has_value()};
  const auto method_for = [&](const Problem& solved) -> HarmonicMethod {
    const auto law = [&solved, c = options_.c](const ContactReceptance& receptance) {
      return lipschitz_law(solved, c, receptance);
    };
    return {.law_at = law,
            .grid_solver = lcp_grid_solver(lcp_settings(shared, ComplementaritySolver::automatic))};
  };
  return prepare_harmonic_balance(problem, shared, method_for, [settings](HarmonicSetup setup) {
    return std::make_unique<ClosingSolver>(std::move(setup), settings);
  });
}

}  // namespace signorini
