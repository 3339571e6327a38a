#include "methods/harmonic_balance/harmonic_setup.hpp"

#include <utility>

#include "methods/hat_functions/hat_contact.hpp"

namespace signorini {

namespace {

/// The scene on hat functions with restitution 1, the law that the projected force represents whatever the
/// scene's. Empty where it has too many contacts for as many nodes. `problem` must outlive the result.
std::optional<Resolutions> conservative_hat_grids(const Problem& problem) {
  constexpr double kConservative = 1.0;
  if (coarsest_hat_grid(problem) * problem.contact_count() > kMostHatUnknowns) return std::nullopt;
  return hat_grids(problem, HatSettings{}, kConservative);
}

}  // namespace

HarmonicSetup harmonic_setup(const Problem& problem, int harmonics, const HarmonicOptions& options,
                             const HarmonicMethod& method) {
  ContactReceptance receptance = fourier_receptance(problem, harmonics);
  ProjectedLaw law = method.law_at(receptance);
  HarmonicSetup setup{.receptance = std::move(receptance),
                      .gap = contact_gaps(problem),
                      .method = method,
                      .options = options,
                      .law = std::move(law),
                      .problem = &problem};
  if (options.compensates_impacts()) setup.compensation = response_to_impacts(problem, setup.receptance);
  if (setup.compensation && method.solver_is_open) setup.hat_grids = conservative_hat_grids(problem);
  return setup;
}

}  // namespace signorini
