#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"

#include "methods/augmented_lagrangian/multiplier_grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"

namespace signorini {

AugmentedLagrangian::AugmentedLagrangian(const Options& options) : options_(options) {
  validate(common());
  require_option(!options_.penalty || options_.penalty->value > 0.0, "penalty", options_.penalty,
                 "must be positive, or auto");
  require_option(options_.max_updates >= 1 && options_.max_updates <= 100000, "max_updates",
                 options_.max_updates, "must be from 1 to 100000");
}

HarmonicOptions AugmentedLagrangian::common() const {
  return {.harmonics = options_.harmonics,
          .quadrature = Quadrature::exact,
          .tolerance = options_.tolerance,
          .max_iterations = options_.max_iterations};
}

Support AugmentedLagrangian::supports(const Problem& problem) const {
  return supports_harmonics(problem, common());
}

RepresentedLaw AugmentedLagrangian::law(const Problem& problem) const {
  return projected_method_law(problem);
}

std::unique_ptr<PreparedMethod> AugmentedLagrangian::prepare(const Problem& problem) const {
  constexpr int kManyUnknowns = 400;  // after pivots a soft penalty is still to be hardened
  const HarmonicOptions shared = common();
  return prepare_harmonic_balance(problem, shared, [&](const Problem& solved) -> HarmonicMethod {
    return {.law_at =
                [&solved, penalty = options_.penalty](const ContactReceptance& receptance) {
                  return augmented_law(solved, penalty, receptance);
                },
            .grid_solver = multiplier_grid_solver(
                {.tolerance = shared.tolerance, .max_iterations = shared.max_iterations},
                options_.max_updates, options_.plain),
            .solver_is_open = !options_.plain,
            .on_grids_only = true,
            .many_unknowns = kManyUnknowns};
  });
}

ProjectedLaw augmented_law(const Problem& problem, const std::optional<Scaled>& penalty,
                           const ContactReceptance& receptance) {
  constexpr double kMultiple = 32.0;  // an update then leaves less than a sixth of an error, up to H = 20
  const auto* stop = std::get_if<Penalty>(&problem.law);
  ProjectedLaw law = penalty_law(problem, penalty, receptance);
  if (!penalty && stop == nullptr) law.constant = kMultiple * highest_dynamic_stiffness(receptance);
  law.multiplier_weight.setOnes();
  for (Eigen::Index j = 0; stop != nullptr && j < law.constant.size(); ++j)
    law.multiplier_weight[j] -= law.constant[j] / stop->stiffness[static_cast<std::size_t>(j)];
  return law;
}

}  // namespace signorini
