#include "methods/penalty_hbm/penalty_hbm.hpp"

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/continuation/series_diagram.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"

namespace signorini {

PenaltyHbm::PenaltyHbm(const Options& options) : options_(options) {
  validate(options_.common, options_.solver);
  require_option(!options_.penalty || options_.penalty->value > 0.0, "penalty", options_.penalty,
                 "must be positive, or auto");
}

Support PenaltyHbm::supports(const Problem& problem) const {
  return supports_harmonics(problem, options_.common);
}

RepresentedLaw PenaltyHbm::law(const Problem& problem) const {
  return projected_method_law(problem, options_.penalty);
}

LawAt PenaltyHbm::law_at(const Problem& problem) const {
  return [&problem, penalty = options_.common.penalty(options_.penalty, problem)](
             const ContactReceptance& receptance) { return penalty_law(problem, penalty, receptance); };
}

std::unique_ptr<PreparedMethod> PenaltyHbm::prepare(const Problem& problem) const {
  return prepare_harmonic_balance(problem, options_.common, [&](const Problem& solved) -> HarmonicMethod {
    return {.law_at = law_at(solved),
            .grid_solver = lcp_grid_solver(lcp_settings(options_.common, options_.solver)),
            .solver_is_open = leaves_solver_open(options_.common, options_.solver)};
  });
}

BranchDiagram PenaltyHbm::follow(const ParametrisedScene& scene, const CurveLimits& limits) const {
  const Problem problem = scene.at(scene.from);
  Options one_number = options_;
  one_number.common.harmonics = options_.common.first_harmonics(problem);
  const PenaltyHbm method(one_number);
  return series_diagram(scene, series_method(method, one_number.common, law_at(problem)), limits);
}

}  // namespace signorini
