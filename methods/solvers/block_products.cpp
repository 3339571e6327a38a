#include "methods/solvers/block_products.hpp"

#include <cstddef>

namespace signorini {

Eigen::MatrixXd block_product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                              const Eigen::Ref<const Eigen::MatrixXd>& B) {
  return A * B;
}

void set_product(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::Ref<const Eigen::MatrixXd>& A,
                 const Eigen::Ref<const Eigen::MatrixXd>& B) {
  C.noalias() = A * B;
}

Eigen::MatrixXd transposed_times(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.transpose() * B;
}

Eigen::MatrixXd times_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A * B.transpose();
}

void set_times_transposed(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  C.noalias() = A * B.transpose();
}

Eigen::MatrixXcd complex_block_product(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) { return A * B; }

Eigen::VectorXd transposed_times_vector(const Eigen::MatrixXd& A,
                                        const Eigen::Ref<const Eigen::VectorXd>& v) {
  return A.transpose() * v;
}

Eigen::VectorXd minus_times(const Eigen::MatrixXd& A, const Eigen::VectorXd& v) { return -A * v; }

Eigen::VectorXd times(const Eigen::Ref<const Eigen::MatrixXd>& A,
                      const Eigen::Ref<const Eigen::VectorXd>& v) {
  return A * v;
}

Eigen::RowVectorXd row_times(const Eigen::Ref<const Eigen::RowVectorXd>& r,
                             const Eigen::Ref<const Eigen::MatrixXd>& A) {
  return r * A;
}

Eigen::VectorXd columns_times(const Eigen::MatrixXd& A, const std::vector<int>& J, const Eigen::VectorXd& v) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(A.rows());
  for (std::size_t j = 0; j < J.size(); ++j) {
    const double factor = v[static_cast<Eigen::Index>(j)];
    for (Eigen::Index i = 0; i < A.rows(); ++i) result[i] += factor * A(i, J[j]);
  }
  return result;
}

Eigen::VectorXd transposed_columns_times(const Eigen::MatrixXd& A, const std::vector<int>& J,
                                         const Eigen::VectorXd& v) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(J.size()));
  for (std::size_t j = 0; j < J.size(); ++j) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < A.rows(); ++i) sum += A(i, J[j]) * v[i];
    result[static_cast<Eigen::Index>(j)] = sum;
  }
  return result;
}

Eigen::MatrixXd chosen_columns(const Eigen::MatrixXd& A, const std::vector<int>& J) {
  Eigen::MatrixXd result(A.rows(), static_cast<Eigen::Index>(J.size()));
  for (std::size_t j = 0; j < J.size(); ++j) result.col(static_cast<Eigen::Index>(j)) = A.col(J[j]);
  return result;
}

}  // namespace signorini
