#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

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
  return A.householderQr().solve(b);
}

Eigen::VectorXd pivoted_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double threshold) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A.rows(), A.cols());
  if (threshold > 0.0) qr.setThreshold(threshold);
  return qr.compute(A).solve(b);
}

Eigen::VectorXd least_norm_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

Eigen::MatrixXd least_norm_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.completeOrthogonalDecomposition().solve(B);
}

Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A) {
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

}  // namespace signorini
