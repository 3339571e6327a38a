#pragma once
// Equal finite elements in a row along x, first free at both ends, then clamped at x = 0.

#include <Eigen/Core>
#include <vector>

#include "problems/sparse_matrix.hpp"

namespace signorini {

/// Sum of `elements` copies of one symmetric element matrix (2 d x 2 d: the d coordinates of its left node,
/// then those of its right one) along elements + 1 nodes: d (elements + 1) square, node by node from x = 0.
SparseMatrix sum_of_elements(int elements, const Eigen::MatrixXd& element);

/// The square matrices one after the other along the diagonal: structures side by side.
SparseMatrix block_diagonal(const std::vector<SparseMatrix>& parts);

/// A without its first `coordinates` rows and columns: these are held at rest.
SparseMatrix clamped(const SparseMatrix& A, int coordinates);

}  // namespace signorini
