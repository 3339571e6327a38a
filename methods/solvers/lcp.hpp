#pragma once
// The complementarity problem that every periodic method ends in, and the result of solving it.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "methods/discretisation/block_circulant.hpp"

namespace signorini {

/// Finds z >= 0 with w = q + A z >= 0 and z^T w = 0, A block-circulant. Entries of A are of order one
/// on the diagonal (the assembly scales them), q may have any size.
struct Lcp {
  BlockCirculant matrix;   ///< A
  Eigen::VectorXd offset;  ///< q
};

/// How a solve ended.
enum class LcpStatus {
  solved,       ///< residual below tolerance
  ray,          ///< the path of the pivoting solver ends in an unbounded direction
  stalled,      ///< the line search of the Newton solver found no descent
  limit,        ///< pivots or iterations used up
  breakdown,    ///< the active block is singular to working precision
  interrupted,  ///< the time budget ran out
};

/// The answer of a solver, or its best iterate.
struct LcpResult {
  LcpStatus status = LcpStatus::breakdown;  ///< how it ended
  Eigen::VectorXd z = {};                   ///< of the size of q
  double residual = 0.0;                 ///< max |min(z, w)| / max(max |q|, max |z|), NaN-safe (infinity) [-]
  long pivots = 0;                       ///< pivoting solver
  long iterations = 0;                   ///< Newton solver
  long factorisations = 0;               ///< dense factorisations from scratch
  std::optional<double> condition = {};  ///< estimate for the block of A on which z > 0; empty: none [-]
};

/// max_i |min(z_i, w_i)| / max(max |q|, max |z|) with w recomputed from z; infinity if anything is not
/// finite. The scale is the larger of the load on the constraint and the answer.
double natural_residual(Lcp& lcp, const Eigen::VectorXd& z);

/// One sentence on how a solve ended.
std::string describe(LcpStatus status);

}  // namespace signorini
