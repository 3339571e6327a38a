#include "methods/solvers/dense_products.hpp"

#include <cblas.h>

#include <algorithm>

namespace signorini {

namespace {

// C = alpha op(A) B + beta C; beta is 0 or 1.
void multiply(CBLAS_TRANSPOSE transpose, double alpha, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
              double beta, Eigen::MatrixXd& C) {
  if (C.size() == 0) return;
  constexpr Eigen::Index kSmall = 4096;  // products of numbers, for which a call of the BLAS does not pay
  if (C.size() * B.rows() < kSmall) {
    if (beta == 0.0) C.setZero();
    if (transpose == CblasTrans)
      C.noalias() += alpha * A.transpose() * B;
    else
      C.noalias() += alpha * A * B;
    return;
  }
  const auto rows = static_cast<int>(C.rows());
  const auto columns = static_cast<int>(C.cols());
  const auto inner = static_cast<int>(B.rows());
  const int stride = std::max(1, static_cast<int>(A.rows()));  // the BLAS refuses 0, which an empty sum has
  cblas_dgemm(CblasColMajor, transpose, CblasNoTrans, rows, columns, inner, alpha, A.data(), stride, B.data(),
              std::max(1, inner), beta, C.data(), rows);
}

}  // namespace

Eigen::MatrixXd dense_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd C(A.rows(), B.cols());
  multiply(CblasNoTrans, 1.0, A, B, 0.0, C);
  return C;
}

Eigen::MatrixXcd dense_product(const Eigen::MatrixXd& A, const Eigen::MatrixXcd& B) {
  Eigen::MatrixXcd result(A.rows(), B.cols());
  result.real() = dense_product(A, Eigen::MatrixXd(B.real()));
  result.imag() = dense_product(A, Eigen::MatrixXd(B.imag()));
  return result;
}

Eigen::MatrixXcd scaled_product(const Eigen::MatrixXd& A, const Eigen::VectorXcd& d,
                                const Eigen::MatrixXd& B) {
  Eigen::MatrixXcd result(A.rows(), B.cols());
  result.real() = dense_product(A, Eigen::MatrixXd(d.real().asDiagonal() * B));
  result.imag() = dense_product(A, Eigen::MatrixXd(d.imag().asDiagonal() * B));
  return result;
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd C(A.cols(), B.cols());
  multiply(CblasTrans, 1.0, A, B, 0.0, C);
  return C;
}

void subtract_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& S, Eigen::MatrixXd& C) {
  multiply(CblasNoTrans, -1.0, A, S, 1.0, C);
}

void map_work_space_of_products() {
  // C = A A^T of one number: of the products this is one that takes work space at any size.
  const double a = 1.0;
  double c = 0.0;
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, 1, 1, 1.0, &a, 1, 0.0, &c, 1);
}

}  // namespace signorini
