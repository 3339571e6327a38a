#include "problems/linear_algebra/products.hpp"

#include <cblas.h>

#include <span>

namespace signorini {

using Complex = std::complex<double>;
using Eigen::Index;

Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                        const Eigen::Ref<const Eigen::MatrixXd>& B) {
  Eigen::MatrixXd C(A.rows(), B.cols());
  set_product(C, A, B);
  return C;
}

void set_product(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::Ref<const Eigen::MatrixXd>& A,
                 const Eigen::Ref<const Eigen::MatrixXd>& B) {
  if (C.size() * A.cols() < kLeastForBlas) {
    C.noalias() = A * B;
    return;
  }
  const auto size = [](Index n) { return static_cast<int>(n); };
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, size(C.rows()), size(C.cols()), size(A.cols()), 1.0,
              A.data(), size(A.outerStride()), B.data(), size(B.outerStride()), 0.0, C.data(),
              size(C.outerStride()));
}

Eigen::MatrixXcd product_of_complex(const Eigen::MatrixXd& A, const Eigen::MatrixXcd& B) { return A * B; }

void add_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, Eigen::MatrixXd& C) {
  C.noalias() += A * B;
}

Eigen::MatrixXcd product_by_real(const Eigen::MatrixXcd& A, const Eigen::MatrixXd& B) { return A * B; }

Eigen::MatrixXcd product_by_real_transposed(const Eigen::MatrixXcd& A, const Eigen::MatrixXd& B) {
  return A * B.transpose();
}

Eigen::MatrixXd product_of_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.transpose() * B;
}

Eigen::MatrixXd product_by_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A * B.transpose();
}

void set_product_by_transposed(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::MatrixXd& A,
                               const Eigen::MatrixXd& B) {
  C.noalias() = A * B.transpose();
}

void subtract_product_of_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, Eigen::MatrixXd& C) {
  C.noalias() -= A.transpose() * B;
}

Eigen::MatrixXd plus_product_of_transposed(const Eigen::MatrixXd& C, const Eigen::MatrixXd& A,
                                           const Eigen::MatrixXd& B) {
  return C + A.transpose() * B;
}

Eigen::MatrixXd plus_product_by_transposed(const Eigen::MatrixXd& C, const Eigen::MatrixXd& A,
                                           const Eigen::MatrixXd& B) {
  return C + A * B.transpose();
}

Eigen::MatrixXcd complex_product(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) { return A * B; }

Eigen::MatrixXcd complex_product(Complex factor, const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B) {
  return factor * (A * B);
}

Eigen::MatrixXcd complex_product_of_transposed(const Eigen::Ref<const Eigen::MatrixXcd>& A,
                                               const Eigen::Ref<const Eigen::MatrixXcd>& B) {
  return A.transpose() * B;
}

Eigen::MatrixXcd product_in_complex(const Eigen::MatrixXd& A, const Eigen::MatrixXcd& B) {
  return A.cast<Complex>() * B;
}

Eigen::MatrixXcd minus_product_in_complex(const Eigen::MatrixXcd& C, const Eigen::MatrixXd& A,
                                          const Eigen::MatrixXcd& B) {
  return C - A.cast<Complex>() * B;
}

Eigen::VectorXd image(const Eigen::Ref<const Eigen::MatrixXd>& A,
                      const Eigen::Ref<const Eigen::VectorXd>& v) {
  return A * v;
}

void add_image(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::Ref<const Eigen::VectorXd>& v,
               Eigen::VectorXd& y) {
  y.noalias() += A * v;
}

Eigen::VectorXd negative_image(const Eigen::MatrixXd& A, const Eigen::Ref<const Eigen::VectorXd>& v) {
  return -A * v;
}

Eigen::VectorXd image_by_transposed(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                    const Eigen::Ref<const Eigen::VectorXd>& v) {
  return A.transpose() * v;
}

Eigen::RowVectorXd row_image(const Eigen::Ref<const Eigen::RowVectorXd>& r,
                             const Eigen::Ref<const Eigen::MatrixXd>& A) {
  return r * A;
}

Eigen::VectorXcd image_of_complex(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::VectorXcd& v) {
  return A * v;
}

void subtract_image_of_complex(const Eigen::MatrixXd& A, const Eigen::VectorXcd& v, Eigen::VectorXcd& y) {
  y.noalias() -= A * v;
}

Eigen::VectorXcd image_in_complex(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                  const Eigen::Ref<const Eigen::VectorXcd>& v) {
  return A.cast<Complex>() * v;
}

Eigen::VectorXcd image_in_complex(Complex factor, const Eigen::MatrixXd& A,
                                  const Eigen::Ref<const Eigen::VectorXcd>& v) {
  return factor * (A.cast<Complex>() * v);
}

Eigen::VectorXcd complex_image(const Eigen::Ref<const Eigen::MatrixXcd>& A, const Eigen::VectorXcd& v) {
  return A * v;
}

Eigen::VectorXcd image_of_complex_by_transposed(const Eigen::MatrixXd& A, const Eigen::VectorXcd& v) {
  return A.transpose() * v;
}

// Column by column, so that no columns are copied.
Eigen::VectorXd image_by_columns(const Eigen::MatrixXd& A, const std::vector<int>& J,
                                 const Eigen::VectorXd& v) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(A.rows());
  for (std::size_t j = 0; j < J.size(); ++j) result += v[static_cast<Index>(j)] * A.col(J[j]);
  return result;
}

Eigen::VectorXd image_by_transposed_columns(const Eigen::MatrixXd& A, const std::vector<int>& J,
                                            const Eigen::Ref<const Eigen::VectorXd>& v) {
  Eigen::VectorXd result(static_cast<Index>(J.size()));
  for (std::size_t j = 0; j < J.size(); ++j) {
    double sum = 0.0;
    for (Index i = 0; i < A.rows(); ++i) sum += A(i, J[j]) * v[i];
    result[static_cast<Index>(j)] = sum;
  }
  return result;
}

// Of spans: a view by a vector of indices copies it.
Eigen::MatrixXd columns_of(const Eigen::MatrixXd& A, const std::vector<int>& J) {
  return A(Eigen::all, std::span(J));
}

Eigen::MatrixXcd rows_of(const Eigen::MatrixXcd& A, const std::vector<int>& I) {
  return A(std::span(I), Eigen::all);
}

Eigen::MatrixXd block_of(const Eigen::MatrixXd& A, const std::vector<int>& I, const std::vector<int>& J) {
  return A(std::span(I), std::span(J));
}

Eigen::VectorXd entries_of(const Eigen::VectorXd& v, const std::vector<int>& I) { return v(std::span(I)); }

void set_rows(Eigen::MatrixXd& A, const std::vector<int>& I, const Eigen::MatrixXd& B) {
  A(std::span(I), Eigen::all) = B;
}

}  // namespace signorini
