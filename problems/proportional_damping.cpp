#include "problems/proportional_damping.hpp"

#include <Eigen/QR>

#include "problems/definiteness.hpp"

namespace signorini {

namespace {

// Entries of D - alpha M - beta K, relative to the largest of D, that count as rounding.
constexpr double kProportional = 1e-12;

/// alpha, beta that make alpha M + beta K nearest to D, entry by entry.
ProportionalDamping nearest_combination(const SparseMatrix& M, const SparseMatrix& K, const SparseMatrix& D) {
  const auto product = [](const SparseMatrix& A, const SparseMatrix& B) { return A.cwiseProduct(B).sum(); };
  const double inertia = M.norm();
  const double springs = K.norm();
  if (springs == 0.0) return {.alpha = product(M, D) / (inertia * inertia)};
  const double angle = product(M, K) / (inertia * springs);
  const Eigen::Matrix2d gram{{1.0, angle}, {angle, 1.0}};
  const Eigen::Vector2d share = gram.completeOrthogonalDecomposition().solve(
      Eigen::Vector2d(product(M, D) / inertia, product(K, D) / springs));
  return {share[0] / inertia, share[1] / springs};
}

}  // namespace

std::optional<ProportionalDamping> proportional_damping(const SparseMatrix& M, const SparseMatrix& K,
                                                        const SparseMatrix& D) {
  const double dampers = largest_entry(D);
  ProportionalDamping fit;
  SparseMatrix rest = D;
  // Least squares over all entries; the second pass takes what rounding of the first has left.
  for (int pass = 0; pass < 2 && largest_entry(rest) > 0.0; ++pass) {
    const ProportionalDamping part = nearest_combination(M, K, rest);
    fit.alpha += part.alpha;
    fit.beta += part.beta;
    rest = D - fit.alpha * M - fit.beta * K;
  }
  if (!(largest_entry(rest) <= kProportional * dampers)) return std::nullopt;
  return fit;
}

}  // namespace signorini
