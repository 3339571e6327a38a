#include "methods/aft_hbm/aft_hbm.hpp"

#include "methods/aft_hbm/aft_grid_solver.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/continuation/series_diagram.hpp"
#include "methods/harmonic_balance/strategy.hpp"

namespace signorini {

AftHbm::AftHbm(const Options& options) : options_(options) {
  validate(options_.common);
  require_option(!options_.c || *options_.c > 0.0, "c", options_.c, "must be positive, or auto");
  require_option(!options_.penalty || options_.penalty->value > 0.0, "penalty", options_.penalty,
                 "must be positive, or auto");
  require_option(!options_.c || options_.law == ContactLaw::dlft, "c", options_.c,
                 "must be auto unless law = dlft");
  require_option(!options_.penalty || options_.law == ContactLaw::penalty, "penalty", options_.penalty,
                 "must be auto unless law = penalty");
}

Support AftHbm::supports(const Problem& problem) const {
  return supports_harmonics(problem, options_.common);
}

RepresentedLaw AftHbm::law(const Problem& problem) const {
  return projected_method_law(problem, options_.penalty);
}

LawAt AftHbm::law_at(const Problem& problem) const {
  const HarmonicOptions& common = options_.common;
  return [&problem, law = options_.law, c = common.lipschitz_constant(options_.c),
          penalty = common.penalty(options_.penalty, problem)](const ContactReceptance& receptance) {
    return law == ContactLaw::penalty ? penalty_law(problem, penalty, receptance)
                                      : lipschitz_law(problem, c, receptance);
  };
}

std::unique_ptr<PreparedMethod> AftHbm::prepare(const Problem& problem) const {
  const HarmonicOptions& common = options_.common;
  const bool homotopy = options_.homotopy.value_or(!common.plain);
  return prepare_harmonic_balance(problem, common, [&](const Problem& solved) -> HarmonicMethod {
    return {.law_at = law_at(solved),
            .grid_solver = aft_grid_solver(
                {.tolerance = common.tolerance, .max_iterations = common.max_iterations}, homotopy),
            .solver_is_open = homotopy,
            .newton_from_guess = false};  // its own Newton method takes the guess, on the first grid
  });
}

BranchDiagram AftHbm::follow(const ParametrisedScene& scene, const CurveLimits& limits) const {
  const Problem problem = scene.at(scene.from);
  Options one_number = options_;
  one_number.common.harmonics = options_.common.first_harmonics(problem);
  const AftHbm method(one_number);
  return series_diagram(scene, series_method(method, one_number.common, law_at(problem)), limits);
}

}  // namespace signorini
