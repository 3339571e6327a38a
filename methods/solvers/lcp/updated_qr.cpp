#include "methods/solvers/lcp/updated_qr.hpp"

#include <Eigen/Jacobi>
#include <algorithm>

#include "methods/solvers/condition_estimate.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

void UpdatedQr::reserve(int size) {
  if (size <= qt_.rows()) return;
  const int capacity = std::max(16, 2 * size);
  RowMajor qt = RowMajor::Zero(capacity, capacity);
  RowMajor r = RowMajor::Zero(capacity, capacity);
  qt.topLeftCorner(rows_, rows_) = qt_.topLeftCorner(rows_, rows_);
  r.topLeftCorner(rows_, cols_) = r_.topLeftCorner(rows_, cols_);
  qt_.swap(qt);
  r_.swap(r);
  work_.resize(capacity);
}

void UpdatedQr::factorise(const Eigen::MatrixXd& matrix) {
  rows_ = cols_ = 0;  // nothing to keep when the memory grows
  const auto size = static_cast<int>(matrix.rows());
  reserve(size + 1);
  const QrFactors qr = householder_qr(matrix);
  qt_.topLeftCorner(size, size) = qr.Q.transpose();
  r_.topLeftCorner(size, size) = qr.R;
  rows_ = size;
  cols_ = size;
}

void UpdatedQr::annihilate(int i, int k, int col) {
  Eigen::JacobiRotation<double> rotation;
  rotation.makeGivens(r_(i, col), r_(k, col));
  r_.block(0, col, rows_, cols_ - col).applyOnTheLeft(i, k, rotation.adjoint());
  qt_.block(0, 0, rows_, rows_).applyOnTheLeft(i, k, rotation.adjoint());
  r_(k, col) = 0.0;
}

// [G, c] = Q [R, Q^T c]: the new column is full; rotating neighbouring rows from the bottom up clears it
// below the diagonal and touches nothing to its left, where those rows of R are zero.
void UpdatedQr::append_column(const Eigen::VectorXd& column) {
  reserve(std::max(rows_, cols_ + 1));
  r_.col(cols_).head(rows_).noalias() = qt_.topLeftCorner(rows_, rows_) * column;
  ++cols_;
  for (int k = rows_ - 1; k >= cols_; --k) annihilate(k - 1, k, cols_ - 1);
}

// [G; g] = diag(Q, 1) [R; g]: the new last row is rotated away entry by entry against the rows above it.
void UpdatedQr::append_row(const Eigen::VectorXd& row) {
  reserve(rows_ + 1);
  qt_.row(rows_).head(rows_ + 1).setZero();
  qt_.col(rows_).head(rows_).setZero();
  qt_(rows_, rows_) = 1.0;
  r_.row(rows_).head(cols_) = row.transpose();
  ++rows_;
  for (int k = 0; k < std::min(cols_, rows_ - 1); ++k) annihilate(k, rows_ - 1, k);
}

// Columns to the right move one place to the left and have one entry below the diagonal each, an upper
// Hessenberg block, which one rotation per column makes triangular again.
void UpdatedQr::remove_column(int index) {
  for (int j = index; j + 1 < cols_; ++j) r_.col(j).head(rows_) = r_.col(j + 1).head(rows_);
  --cols_;
  for (int j = index; j < std::min(cols_, rows_ - 1); ++j) annihilate(j, j + 1, j);
}

void UpdatedQr::remove_row(int index) {
  // Rotate from the bottom up until row `index` of Q is the first unit vector: then the first row of
  // R carries nothing but that row of G, and both can be dropped.
  for (int k = rows_ - 2; k >= 0; --k) {
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(qt_(k, index), qt_(k + 1, index));
    const int first = std::min(k, cols_);
    r_.block(0, first, rows_, cols_ - first).applyOnTheLeft(k, k + 1, rotation.adjoint());
    qt_.block(0, 0, rows_, rows_).applyOnTheLeft(k, k + 1, rotation.adjoint());
  }
  for (int i = 0; i + 1 < rows_; ++i) {
    r_.row(i).head(cols_) = r_.row(i + 1).head(cols_);
    qt_.row(i).head(index) = qt_.row(i + 1).head(index);
    qt_.row(i).segment(index, rows_ - 1 - index) = qt_.row(i + 1).segment(index + 1, rows_ - 1 - index);
  }
  --rows_;
}

double UpdatedQr::condition() const { return triangular_condition(r_.topLeftCorner(rows_, rows_)); }

void UpdatedQr::solve(Eigen::VectorXd& b) const {
  auto head = work_.head(rows_);
  head.noalias() = qt_.topLeftCorner(rows_, rows_) * b;
  r_.topLeftCorner(rows_, rows_).triangularView<Eigen::Upper>().solveInPlace(head);
  b = head;
}

}  // namespace signorini
