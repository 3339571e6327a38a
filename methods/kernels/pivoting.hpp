#pragma once
// Lemke's method as a homotopy in the gap, on the active set alone.

#include <chrono>
#include <optional>
#include <vector>

#include "methods/kernels/lcp.hpp"

namespace signorini {

struct PivotingOptions {
  long max_pivots = 0;              ///< 0: 6000 + 10 * size [-]
  double tolerance = 1e-10;         ///< on LcpResult::residual [-]
  Eigen::VectorXd cover = {};       ///< own covering vector d > 0, size of q; empty: nearly constant
  Eigen::VectorXd guess = {};       ///< warm start: z of a nearby problem; empty: cold start
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Follows the solution of w = q + tau d + A z, z >= 0, w >= 0, z^T w = 0 from a tau so large that z = 0
/// (every gap is open) down to tau = 0. With d = 1 the parameter is an added gap. The path is piecewise
/// linear; each pivot updates the QR factors of the bordered active block [A_RB, d_R], one row and column
/// larger than the number of positive z: O(|active|^2 + N Nc |active|) per pivot, memory
/// O(N Nc^2 + |active|^2).
///
/// The default d varies smoothly by one part in a thousand with an irrational period, so that the ties
/// of symmetric problems, where pivoting could cycle, do not occur; the answer does not depend on d
/// beyond which of several solutions is met first.
/// Warm start: d is chosen so that the guess solves the problem at tau = 1, and the path begins there.
///
/// Guarantee: `solved` means residual <= tolerance. With strictly copositive-plus A no ray can occur
/// [cottle2009, theorem 4.4.12]; for the periodic contact problems see docs/theory.md.
LcpResult solve_by_pivoting(Lcp& lcp, const PivotingOptions& options = {});

/// d_i = 1 + amplitude * (fractional part of (i + 1) times the golden ratio - 1/2): the default cover.
Eigen::VectorXd smooth_cover(int size, double amplitude = 1e-3, double ratio = 0.6180339887498949);

}  // namespace signorini
