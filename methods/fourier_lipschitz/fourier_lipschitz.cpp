#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/continuation/series_diagram.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"

namespace signorini {

FourierLipschitz::FourierLipschitz(const Options& options) : options_(options) {
  validate(options_.common, options_.solver);
  require_option(!options_.c || *options_.c > 0.0, "c", options_.c, "must be positive, or auto");
}

Support FourierLipschitz::supports(const Problem& problem) const {
  return supports_harmonics(problem, options_.common);
}

RepresentedLaw FourierLipschitz::law(const Problem& problem) const { return projected_method_law(problem); }

LawAt FourierLipschitz::law_at(const Problem& problem) const {
  return [&problem, c = options_.common.lipschitz_constant(options_.c)](const ContactReceptance& receptance) {
    return lipschitz_law(problem, c, receptance);
  };
}

std::unique_ptr<PreparedMethod> FourierLipschitz::prepare(const Problem& problem) const {
  return prepare_harmonic_balance(problem, options_.common, [&](const Problem& solved) -> HarmonicMethod {
    return {.law_at = law_at(solved),
            .grid_solver = lcp_grid_solver(lcp_settings(options_.common, options_.solver)),
            .solver_is_open = leaves_solver_open(options_.common, options_.solver)};
  });
}

BranchDiagram FourierLipschitz::follow(const ParametrisedScene& scene, const CurveLimits& limits) const {
  const Problem problem = scene.at(scene.from);
  Options one_number = options_;
  one_number.common.harmonics = options_.common.first_harmonics(problem);
  const FourierLipschitz method(one_number);
  return series_diagram(scene, series_method(method, one_number.common, law_at(problem)), limits);
}

}  // namespace signorini
