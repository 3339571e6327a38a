#pragma once
// The one sparse matrix type of the project.

#include <Eigen/SparseCore>

namespace signorini {

/// Real, compressed by columns, with int indices.
using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace signorini
