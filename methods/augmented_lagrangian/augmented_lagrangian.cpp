#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"

#include "methods/augmented_lagrangian/multiplier_grid_solver.hpp"

namespace signorini {

AugmentedLagrangian::AugmentedLagrangian(const Options& options)
    : ProjectedMethod({.harmonics = options.harmonics,
                       .quadrature = Quadrature::exact,
                       .tolerance = options.tolerance,
                       .max_iterations = options.max_iterations},
                      options.penalty),
      options_(options) {
  require_option(options_.max_updates >= 1 && options_.max_updates <= 100000, "max_updates",
                 options_.max_updates, "must be from 1 to 100000");
}

RepresentedLaw AugmentedLagrangian::law(const Problem& problem) const {
  return projected_method_law(problem);
}

HarmonicMethod AugmentedLagrangian::preset(const Problem& problem) const {
  const SolverSettings settings{.tolerance = common().tolerance, .max_iterations = common().max_iterations};
  return {.law_at = [&problem, penalty = options_.penalty](
                        const ContactReceptance& level) { return augmented_law(problem, penalty, level); },
          .grid_solver = multiplier_grid_solver(settings, options_.max_updates, options_.plain),
          .solver_is_open = !options_.plain,
          .on_grids_only = true,
          .many_unknowns = 400,  // after pivots a soft penalty is still to be hardened
          .counts = options_.plain ? Work{.iterations = 0} : Work{.iterations = 0, .pivots = 0}};
}

ProjectedLaw augmented_law(const Problem& problem, const std::optional<Scaled>& penalty,
                           const ContactReceptance& receptance) {
  const Eigen::VectorXd unasked = kAugmentedMultiple * highest_dynamic_stiffness(receptance);
  ProjectedLaw law = penalty_law(problem, {.asked = penalty}, receptance);
  law.multiplier_weight.setOnes();
  for (Eigen::Index j = 0; j < law.constant.size(); ++j) {
    const auto* spring = std::get_if<Spring>(&problem.contacts[static_cast<std::size_t>(j)].law);
    if (spring != nullptr)
      law.multiplier_weight[j] -= law.constant[j] / spring->stiffness;
    else if (!penalty)
      law.constant[j] = unasked[j];
  }
  return law;
}

}  // namespace signorini
