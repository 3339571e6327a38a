#pragma once
// QR factors of a small dense matrix that gains and loses rows and columns one at a time.

#include <Eigen/Core>

namespace signorini {

/// G = Q R with Q orthogonal (rows x rows) and R upper triangular, kept up to date by Givens rotations
/// in O(m^2) per change, backward stable. G need not be square between two changes, but has at most one
/// column more than rows or one row more than columns.
/// Source: [golub2013], section 6.5.
class UpdatedQr {
 public:
  /// Starts over with the factors of a square matrix.
  void factorise(const Eigen::MatrixXd& matrix);

  void append_column(const Eigen::VectorXd& column);  ///< column: as long as G has rows
  void append_row(const Eigen::VectorXd& row);        ///< row: as long as G has columns
  void remove_column(int index);                      ///< index: of a column
  void remove_row(int index);                         ///< index: of a row

  /// Estimated condition number of square G (triangular_condition).
  [[nodiscard]] double condition() const;

  /// Solves G x = b for square G, in place. A zero pivot gives infinities: check the result.
  void solve(Eigen::VectorXd& b) const;

 private:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void reserve(int size);
  /// Rotates rows i and k of Q^T and R so that R(k, col) vanishes against R(i, col).
  void annihilate(int i, int k, int col);

  int rows_ = 0;
  int cols_ = 0;
  RowMajor qt_;  // Q^T in the leading rows_ x rows_ block
  RowMajor r_;   // R in the leading rows_ x cols_ block
  mutable Eigen::VectorXd work_;
};

}  // namespace signorini
