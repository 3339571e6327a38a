#pragma once
// How many digits a triangular solve may lose.

#include <Eigen/Core>
#include <limits>

namespace signorini {

/// The condition of a singular matrix, as far as records can tell.
inline constexpr double kSingular = std::numeric_limits<double>::max();

/// The condition number behind its reciprocal as Eigen's decompositions estimate it, at most kSingular.
inline double condition_from(double reciprocal) {
  return reciprocal * kSingular > 1.0 ? 1.0 / reciprocal : kSingular;
}

/// Estimates |R|_1 |R^{-1}|_1 for upper triangular R (m x m) in O(m^2) by Hager's method: a lower bound,
/// rarely by more than a factor of three. With G = Q R it tells the condition of G to a factor of m.
/// \return >= 1, finite: kSingular if R is singular or not finite; 1 for m = 0
/// Source: [hager1984].
double triangular_condition(const Eigen::MatrixXd& r);

}  // namespace signorini
