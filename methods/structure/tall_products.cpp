#include "methods/structure/tall_products.hpp"

// The Fortran interface, the one that every BLAS has.
extern "C" void dgemm_(const char* transpose_a, const char* transpose_b, const int* rows, const int* columns,
                       const int* inner, const double* alpha, const double* a, const int* stride_a,
                       const double* b, const int* stride_b, const double* beta, double* c,
                       const int* stride_c);

namespace signorini {

namespace {

// C = alpha op(A) B + beta C.
void multiply(char transpose, double alpha, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double beta,
              Eigen::MatrixXd& C) {
  if (C.size() == 0) return;
  const auto rows = static_cast<int>(C.rows());
  const auto columns = static_cast<int>(C.cols());
  const auto inner = static_cast<int>(B.rows());
  const auto stride = static_cast<int>(A.rows());
  dgemm_(&transpose, "N", &rows, &columns, &inner, &alpha, A.data(), &stride, B.data(), &inner, &beta,
         C.data(), &rows);
}

}  // namespace

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd C(A.cols(), B.cols());
  multiply('T', 1.0, A, B, 0.0, C);
  return C;
}

void subtract_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& S, Eigen::MatrixXd& C) {
  multiply('N', -1.0, A, S, 1.0, C);
}

}  // namespace signorini
