#include "methods/harmonic_balance/harmonic_setup.hpp"

#include <utility>

#include "methods/harmonic_balance/witness_grids.hpp"

namespace signorini {

namespace {

/// Once impacts are compensated, the harder the law, the nearer the force is to an impulse, and the error to
/// that of truncation alone (docs/decisions/0011).
constexpr double kCompensatedStiffness = 8.0;

}  // namespace

HarmonicSetup harmonic_setup(const Problem& problem, int harmonics, const HarmonicOptions& options,
                             const HarmonicMethod& method) {
  ContactReceptance receptance = fourier_receptance(problem, harmonics);
  ProjectedLaw law = method.law_at(receptance);
  HarmonicSetup setup{
      .receptance = std::move(receptance),
      .gap = contact_gaps(problem),
      .law_at = method.law_at,
      .law = std::move(law),
      .grid_solver = method.grid_solver,
      .settings = {.samples = options.fixed_samples(harmonics),
                   .quadrature = options.contact_integral(),
                   .tolerance = options.tolerance,
                   .limit = options.max_iterations,
                   .without_grid = method.solver_is_open && options.grid_is_open(harmonics),
                   .newton_from_guess = method.newton_from_guess,
                   .compensated_stiffness = method.constant_is_chosen ? 1.0 : kCompensatedStiffness}};
  if (options.compensates_impacts()) setup.compensation = impact_compensation(problem, setup.receptance);
  if (setup.compensation && method.solver_is_open) setup.hat_grids = witness_grids(problem);
  return setup;
}

}  // namespace signorini
