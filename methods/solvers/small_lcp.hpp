#pragma once
// Complementarity at one instant, for a few contacts that act together.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/solvers/lcp.hpp"

namespace signorini {

/// The problem w = q + A z of a single instant, for the solvers of any complementarity problem.
/// \param matrix  A as an array, m x m
/// \param offset  q, m
Lcp dense_lcp(Eigen::MatrixXd matrix, Eigen::VectorXd offset);

/// Finds z with w = A z + q, z_i w_i = 0, z_i >= 0, w_i >= 0, except that indices in `held` are
/// equalities: w_i = 0, z_i of any sign.
///
/// \param A     m x m, symmetric positive semi-definite with a positive diagonal (a Delassus matrix)
/// \param q     m
/// \param held  one flag per index
/// \return m; unique when A is positive definite. For a singular A, where w is unique but z is not, z is
///         the one of least norm on its support. Empty if there is none, or if rounding decides.
/// Block principal pivoting, by the least index where that stagnates [judice1994]; then, for a singular A,
/// Lemke's method. A dense solve of the active set per pivot.
std::optional<Eigen::VectorXd> solve_small_lcp(const Eigen::MatrixXd& A, const Eigen::VectorXd& q,
                                               const std::vector<bool>& held);

}  // namespace signorini
