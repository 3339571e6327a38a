#pragma once
// The impact law and the contact law at one instant, for a few contacts that act together.

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace signorini {

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

/// Newton's law for contacts that touch at the same instant.
struct ImpactInput {
  Eigen::MatrixXd delassus;     ///< G of the touching contacts, m x m [1/kg]
  Eigen::VectorXd approach;     ///< x'_- of each, m; <= 0 where the contact is not closing [m/s]
  Eigen::VectorXd restitution;  ///< e of each, m [-]
};

/// Impulses p <= 0 such that x'_+ = x'_- + G p satisfies
///
///     x'_+ + e max(x'_-, 0) <= 0,   p <= 0,   p_j (x'_+ + e max(x'_-, 0))_j = 0:
///
/// a contact that pushes rebounds by Newton's law, one that the others carry away gets no impulse, and a
/// resting one passes an impulse on.
/// \return p, m [N s]; empty only if G is degenerate and no solution was found
std::optional<Eigen::VectorXd> newton_impulses(const ImpactInput& input);

}  // namespace signorini
