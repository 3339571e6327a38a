#pragma once
// Lemke's method as a homotopy in the gap, on the active set alone.

#include <chrono>
#include <optional>
#include <vector>

#include "methods/solvers/lcp.hpp"

namespace signorini {

/// Where the path begins and when it must end.
struct PivotingOptions {
  long max_pivots = 0;         ///< 0: 6000 + 10 * size [-]
  double tolerance = 1e-10;    ///< on LcpResult::residual [-]
  Eigen::VectorXd cover = {};  ///< own covering vector d > 0, size of q; empty: smooth_cover without a wave
  Eigen::VectorXd guess = {};  ///< warm start: z of a nearby problem; empty: cold start
  /// The end of the time budget.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Follows the solution of w = q + tau d + A z, z >= 0, w >= 0, z^T w = 0 from a tau so large that z = 0
/// (every gap is open) down to tau = 0. With d = 1 the parameter is an added gap. The path is piecewise
/// linear; each pivot updates the QR factors of the bordered active block [A_RB, d_R], one row and column
/// larger than the number of positive z: per pivot O(|active|^2) and |active| columns of A, memory of vectors
/// and of |active|^2.
///
/// The default d is constant but for one part in 1e9 of irregular variation, which separates the ties of
/// symmetric problems, where pivoting could cycle. The answer depends on d only in which of several
/// solutions is met first; the path's length depends on it strongly: a d that is rough in time excites
/// high harmonics all along, smooth ones do not (docs/decisions/0005).
/// Warm start: d is chosen so that the guess solves the problem at tau = 1, and the path begins there.
///
/// Guarantee: `solved` means residual <= tolerance. With strictly copositive-plus A no ray can occur
/// [cottle2009, theorem 4.4.12]; for the periodic contact problems see docs/theory.md.
LcpResult solve_by_pivoting(const Lcp& lcp, const PivotingOptions& options = {});

}  // namespace signorini
