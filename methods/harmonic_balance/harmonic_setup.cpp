#include "methods/harmonic_balance/harmonic_setup.hpp"

#include <algorithm>
#include <utility>

#include "methods/hat_functions/hat_contact.hpp"

namespace signorini {

namespace {

// The law that the projected force represents whatever the scene's.
constexpr double kConservative = 1.0;
// Harmonics that the response to impacts has at least where these are closed: what is neglected beyond the
// last falls with its third power.
constexpr int kClosedResponse = 128;

/// The scene on hat functions with this restitution. Empty where it has too many contacts for as many nodes.
/// `problem` must outlive the result.
std::optional<Resolutions> affordable_hat_grids(const Problem& problem, double restitution,
                                                int max_iterations) {
  if (coarsest_hat_grid(problem) * problem.contact_count() > kMostHatUnknowns) return std::nullopt;
  return hat_grids(problem, {.max_iterations = max_iterations}, restitution);
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
                      .restitution = options.closed_restitution(problem),
                      .problem = &problem};
  const int beyond = std::max(2 * harmonics, setup.restitution ? kClosedResponse : 0);
  if (options.compensates_impacts())
    setup.compensation = response_to_impacts(problem, setup.receptance, beyond);
  if (setup.compensation && (method.solver_is_open || setup.restitution))
    setup.hat_grids =
        affordable_hat_grids(problem, setup.restitution.value_or(kConservative), options.max_iterations);
  return setup;
}

}  // namespace signorini
