#include "methods/structure/tall_products.hpp"

#include <cblas.h>

namespace signorini {

namespace {

// C = alpha op(A) B + beta C.
void multiply(CBLAS_TRANSPOSE transpose, double alpha, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
              double beta, Eigen::MatrixXd& C) {
  if (C.size() == 0) return;
  const auto rows = static_cast<int>(C.rows());
  const auto columns = static_cast<int>(C.cols());
  const auto inner = static_cast<int>(B.rows());
  const auto stride = static_cast<int>(A.rows());
  cblas_dgemm(CblasColMajor, transpose, CblasNoTrans, rows, columns, inner, alpha, A.data(), stride, B.data(),
              inner, beta, C.data(), rows);
}

}  // namespace

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd C(A.cols(), B.cols());
  multiply(CblasTrans, 1.0, A, B, 0.0, C);
  return C;
}

void subtract_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& S, Eigen::MatrixXd& C) {
  multiply(CblasNoTrans, -1.0, A, S, 1.0, C);
}

}  // namespace signorini
