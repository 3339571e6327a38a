#include "methods/penalty_hbm/penalty_hbm.hpp"

#include <utility>

#include "methods/complementarity/projected_law.hpp"
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

std::unique_ptr<PreparedMethod> PenaltyHbm::prepare(const Problem& problem) const {
  LawAt law_at = [&problem, penalty = options_.common.penalty(options_.penalty, problem)](
                     const ContactReceptance& receptance) {
    return penalty_law(problem, penalty, receptance);
  };
  return prepare_harmonic_balance(
      problem, options_.common,
      {.law_at = std::move(law_at),
       .grid_solver = lcp_grid_solver(lcp_settings(options_.common, options_.solver)),
       .constant_is_chosen = options_.penalty.has_value() || options_.common.plain,
       .solver_is_open = leaves_solver_open(options_.common, options_.solver)});
}

}  // namespace signorini
