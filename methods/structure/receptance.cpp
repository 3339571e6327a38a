#include "methods/structure/receptance.hpp"

#include <utility>

#include "methods/structure/dynamic_stiffness.hpp"
#include "methods/structure/factorised_receptance.hpp"
#include "methods/structure/reduced_receptance.hpp"

namespace signorini {

ContactReceptance contact_receptance(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights,
                                     ReceptanceMethod method) {
  const bool large = problem.size() > kMostFactorised;
  if (method == ReceptanceMethod::reduced || (method == ReceptanceMethod::automatic && large)) {
    auto reduced = reduced_receptance(problem, harmonics, weights, kReducedTolerance);
    if (reduced) return *std::move(reduced);
  }
  const bool dense =
      method == ReceptanceMethod::dense || (method == ReceptanceMethod::automatic && prefers_dense(problem));
  return factorised_receptance(problem, harmonics, weights, dense);
}

ContactReceptance fourier_receptance(const Problem& problem, int harmonics) {
  const double base = problem.base_frequency();
  return contact_receptance(problem, harmonics, [base](int n) { return exact_weights(n * base); });
}

}  // namespace signorini
