#include "methods/harmonic_balance/harmonic_setup.hpp"

#include <utility>

#include "methods/structure/contact_reduction.hpp"

namespace signorini {

namespace {

/// The reduced structure to march, from the receptance's own space where there is one.
std::optional<ContactReduction> reduction_to_march(const HarmonicSetup& setup, ContactReduction found) {
  const Problem& problem = *setup.problem;
  const bool wanted =
      marches_several(problem) || (setup.has_many_unknowns() && march_obstacle(problem).empty());
  if (!setup.way_is_open() || !wanted) return std::nullopt;
  if (!found.obstacle.empty() && problem.size() <= kMostFactorised) found = reduce_to_contacts(problem);
  if (!found.obstacle.empty()) return std::nullopt;
  return found;
}

}  // namespace

HarmonicSetup harmonic_setup(const Problem& problem, int harmonics, const HarmonicOptions& options,
                             const HarmonicMethod& method) {
  const double base = problem.base_frequency();
  ReducedReceptance found =
      reduced_contact_receptance(problem, harmonics, [base](int n) { return exact_weights(n * base); });
  ContactReceptance receptance = std::move(found.value);
  ProjectedLaw law = method.law_at(receptance);
  HarmonicSetup setup{.receptance = std::move(receptance),
                      .gap = contact_gaps(problem),
                      .method = method,
                      .options = options,
                      .law = std::move(law),
                      .problem = &problem};
  setup.marched = reduction_to_march(setup, std::move(found.reduction));
  return setup;
}

}  // namespace signorini
