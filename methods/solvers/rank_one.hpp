#pragma once
// Eigenpairs of a diagonal matrix to which a matrix of rank one is added.

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace signorini {

/// (diag(poles) + strength z z^T) V = V diag(values).
struct RankOneEigenpairs {
  std::vector<long double> values;  ///< n, ascending
  Eigen::MatrixXd vectors;          ///< V, n x n, orthonormal
};

/// By the roots of the secular equation 1 + strength sum_i z_i^2 / (poles_i - x) = 0, one above each pole.
/// They are distances from the nearest pole, so that the least value is known to as many digits as the
/// largest however far they spread, and V to rounding: some 50 n^2 operations in extended precision. A pole
/// whose z_i is within rounding of the largest stays. None where two others are nearer than 1e-12 of them, or
/// something is not finite. Source: [bunch1978]. \param poles  n, ascending, >= 0 \param z  n \param strength
/// > 0
std::optional<RankOneEigenpairs> add_rank_one(const std::vector<long double>& poles, const Eigen::VectorXd& z,
                                              double strength);

}  // namespace signorini
