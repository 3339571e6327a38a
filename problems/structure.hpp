#pragma once
// A linear structure without its loads and contacts: the three matrices of its equation of motion.

#include <Eigen/SparseCore>

namespace signorini {

/// The one sparse matrix type of the project: real, compressed by columns, with int indices.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// M u'' + D u' + K u = forces; all three matrices are Nd x Nd.
struct Structure {
  SparseMatrix mass;       ///< M, symmetric positive semi-definite [kg]
  SparseMatrix damping;    ///< D [N s/m]
  SparseMatrix stiffness;  ///< K, its symmetric part positive semi-definite; a skew part circulates [N/m]
};

}  // namespace signorini
