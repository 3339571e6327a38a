#pragma once
// A linear structure without its loads and contacts: the three matrices of its equation of motion.

#include <Eigen/SparseCore>
#include <memory>
#include <optional>

namespace signorini {

/// The one sparse matrix type of the project: real, compressed by columns, with int indices.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Calls visit(row, column, value) for every stored entry of a matrix, column by column.
template <class Visit>
void for_each_entry(const SparseMatrix& A, Visit visit) {
  for (int column = 0; column < A.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry)
      visit(static_cast<int>(entry.row()), column, entry.value());
  }
}

/// D and K of a rotor that turns as fast as its load, D = D_0 + omega D_1 and K = K_0 + omega K_1, omega
/// being the frequency of the load; all four matrices are Nd x Nd.
struct SpeedTerms {
  SparseMatrix damping;      ///< D_0 [N s/m]
  SparseMatrix stiffness;    ///< K_0 [N/m]
  SparseMatrix gyroscopic;   ///< D_1, skew-symmetric [N s^2/m]
  SparseMatrix circulatory;  ///< K_1, skew-symmetric [N s/m]
};

/// D = alpha M + beta K.
struct ProportionalDamping {
  double alpha = 0.0;  ///< [1/s]
  double beta = 0.0;   ///< [s]
};

/// M u'' + D u' + K u = forces; all three matrices are Nd x Nd.
struct Structure {
  SparseMatrix mass;       ///< M, symmetric positive semi-definite [kg]
  SparseMatrix damping;    ///< D [N s/m]
  SparseMatrix stiffness;  ///< K, its symmetric part positive semi-definite; a skew part circulates [N/m]
  /// What D and K are at other speeds; null where they do not follow the frequency of the load.
  std::shared_ptr<const SpeedTerms> speed = nullptr;
  /// Those that D was assembled by; none where it was assembled otherwise, or nobody has said so.
  std::optional<ProportionalDamping> proportional = {};
};

}  // namespace signorini
