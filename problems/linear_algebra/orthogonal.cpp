#include "problems/linear_algebra/orthogonal.hpp"

#include <limits>

namespace signorini {

namespace {

// In place of Eigen's answer for a matrix that is not finite: rank 0, and zero.
Eigen::MatrixXd no_numbers(Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

PivotedQr::PivotedQr(const Eigen::MatrixXd& A) : qr_(A) {}

Eigen::Index PivotedQr::rank() const { return qr_.rank(); }

Eigen::VectorXd PivotedQr::diagonal() const { return qr_.matrixR().diagonal(); }

Eigen::MatrixXd PivotedQr::basis(Eigen::Index count) const {
  return qr_.householderQ() * Eigen::MatrixXd::Identity(qr_.rows(), count);
}

Eigen::MatrixXd householder_basis(const Eigen::MatrixXd& A) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(A).householderQ();
}

QrFactors householder_qr(const Eigen::MatrixXd& A) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(A);
  return {.Q = qr.householderQ(), .R = qr.matrixQR().triangularView<Eigen::Upper>()};
}

Eigen::VectorXd full_rank_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  if (A.size() == 0) return Eigen::VectorXd::Zero(A.cols());
  return A.householderQr().solve(b);
}

Eigen::VectorXd pivoted_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  if (A.size() == 0) return Eigen::VectorXd::Zero(A.cols());
  return A.colPivHouseholderQr().solve(b);
}

Eigen::VectorXd least_norm_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  if (A.size() == 0) return Eigen::VectorXd::Zero(A.cols());
  if (!A.allFinite()) return no_numbers(A.cols(), 1);
  return A.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd least_norm_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  if (A.size() == 0) return Eigen::MatrixXd::Zero(A.cols(), B.cols());
  if (!A.allFinite()) return no_numbers(A.cols(), B.cols());
  return A.completeOrthogonalDecomposition().solve(B);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return Eigen::MatrixXd::Zero(A.cols(), A.rows());
  if (!A.allFinite()) return no_numbers(A.cols(), A.rows());
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace signorini
