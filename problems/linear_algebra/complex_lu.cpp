#include "problems/linear_algebra/complex_lu.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace signorini {

namespace {

double modulus(const std::complex<double>& z) { return std::abs(z.real()) + std::abs(z.imag()); }

double largest_column(const Eigen::MatrixXcd& A) {
  double largest = 0.0;
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < A.rows(); ++i) sum += modulus(A(i, j));
    if (sum > largest || std::isnan(sum)) largest = sum;  // what is not a number stays
  }
  return largest;
}

}  // namespace

ComplexLuFactors::ComplexLuFactors(const Eigen::MatrixXcd& A) : lu_(A) {}

void ComplexLuFactors::compute(const Eigen::MatrixXcd& A) { lu_.compute(A); }

Eigen::VectorXcd ComplexLuFactors::solve(const Eigen::VectorXcd& b) const { return lu_.solve(b); }

Eigen::MatrixXcd ComplexLuFactors::solve(const Eigen::MatrixXcd& B) const { return lu_.solve(B); }

Eigen::MatrixXcd ComplexLuFactors::inverse() const { return lu_.inverse(); }

double ComplexLuFactors::reciprocal_condition() const {
  // Behind a pivot that is zero the estimate is made of what division by it leaves.
  if (lu_.rows() > 0 && lu_.matrixLU().diagonal().cwiseAbs().minCoeff() == 0.0) return 0.0;
  return lu_.rcond();
}

CompleteComplexLuFactors::CompleteComplexLuFactors(const Eigen::MatrixXcd& A) : lu_(A) {}

Eigen::MatrixXcd CompleteComplexLuFactors::solve(const Eigen::MatrixXcd& B) const { return lu_.solve(B); }

Eigen::MatrixXcd CompleteComplexLuFactors::inverse() const { return lu_.inverse(); }

double CompleteComplexLuFactors::reciprocal_condition() const { return lu_.rcond(); }

Eigen::VectorXcd lu_solve(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b) {
  return ComplexLuFactors(A).solve(b);
}

Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& A) { return ComplexLuFactors(A).inverse(); }

bool invert(Eigen::MatrixXcd& A) {
  const Eigen::Index n = A.rows();
  std::array<Eigen::Index, kMostInverted> exchanged{};
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index row = k;
    for (Eigen::Index i = k + 1; i < n; ++i)
      if (modulus(A(i, k)) > modulus(A(row, k))) row = i;
    exchanged[static_cast<std::size_t>(k)] = row;
    if (row != k) A.row(k).swap(A.row(row));
    if (!(modulus(A(k, k)) > 0.0)) return false;
    const std::complex<double> pivot = 1.0 / A(k, k);
    for (Eigen::Index j = 0; j < n; ++j) {
      if (j == k) continue;
      const std::complex<double> share = A(k, j) * pivot;
      for (Eigen::Index i = 0; i < n; ++i) A(i, j) -= A(i, k) * share;
      A(k, j) = share;
    }
    for (Eigen::Index i = 0; i < n; ++i) A(i, k) *= -pivot;
    A(k, k) = pivot;
  }
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    const Eigen::Index column = exchanged[static_cast<std::size_t>(k)];
    if (column != k) A.col(k).swap(A.col(column));
  }
  return true;
}

double reciprocal_condition(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& inverse) {
  constexpr double kOfModuli = 2.0;  // |re| + |im| is at most sqrt(2) times the modulus
  const double product = largest_column(A) * largest_column(inverse);
  return std::isfinite(product) && product > 0.0 ? kOfModuli / product : 0.0;
}

}  // namespace signorini
