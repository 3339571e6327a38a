#include "methods/harmonic_balance/witness_grids.hpp"

#include "methods/hat_functions/hat_grids.hpp"

namespace signorini {

namespace {

constexpr int kNodesPerHarmonic = 4;             // fewer do not carry the harmonics asked for
constexpr int kNodesInAll = 2 * kFinestHatGrid;  // nodes times contacts that a grid may have

}  // namespace

std::optional<Resolutions> witness_grids(const Problem& problem) {
  constexpr double kConservative = 1.0;
  if (coarsest_hat_grid(problem) * problem.contact_count() > kNodesInAll) return std::nullopt;
  return hat_grids(problem, HatSettings{}, kConservative);
}

bool carries_harmonics(int nodes, const ContactReceptance& receptance) {
  return nodes >= kNodesPerHarmonic * receptance.harmonics() &&
         static_cast<long>(nodes) * receptance.contacts() <= kNodesInAll;
}

}  // namespace signorini
