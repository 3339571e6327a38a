#include "problems/linear_algebra/sparse/sparse_products.hpp"

#include <algorithm>

namespace signorini {

using Sparse = Eigen::SparseMatrix<double>;

Eigen::VectorXd sparse_image(const Sparse& A, const Eigen::Ref<const Eigen::VectorXd>& v) { return A * v; }

void subtract_sparse_image(const Sparse& A, const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::VectorXd& y) {
  y.noalias() -= A * v;
}

Eigen::VectorXd sparse_image_by_transposed(const Sparse& A, const Eigen::Ref<const Eigen::VectorXd>& v) {
  return A.transpose() * v;
}

Eigen::MatrixXd sparse_product(const Sparse& A, const Eigen::MatrixXd& B) { return A * B; }

Eigen::MatrixXd product_by_rows(const Sparse& A, const Eigen::MatrixXd& B) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::MatrixXd C(A.rows(), B.cols());
  for (Eigen::Index first = 0; first < B.cols(); first += kColumnsAtOnce) {
    const Eigen::Index count = std::min(kColumnsAtOnce, B.cols() - first);
    const RowMajor rows = B.middleCols(first, count);
    C.middleCols(first, count) = RowMajor(A * rows);
  }
  return C;
}

Sparse sparse_product(const Sparse& A, const Sparse& B) { return A * B; }

Eigen::MatrixXd sparse_product_of_transposed(const Sparse& A, const Eigen::MatrixXd& B) {
  return A.transpose() * B;
}

Sparse sparse_product_of_transposed(const Sparse& A, const Sparse& B) { return A.transpose() * B; }

Eigen::MatrixXd product_by_sparse(const Eigen::MatrixXd& B, const Sparse& A) { return B * A; }

Sparse sparse_columns(const Sparse& A, Eigen::Index first, Eigen::Index count) {
  return A.middleCols(first, count);
}

Sparse sparse_sum(double a, const Sparse& A, double b, const Sparse& B) { return a * A + b * B; }

}  // namespace signorini
