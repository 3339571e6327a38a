#include "problems/linear_algebra/complex_lu.hpp"

#include <cmath>
#include <complex>
#include <limits>

#include "problems/linear_algebra/lapack.hpp"

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
  if (!is_for_lapack(A)) return ComplexLuFactors(A).solve(b);
  constexpr int kOne = 1;
  const auto n = static_cast<int>(A.rows());
  Eigen::MatrixXcd factors = A;
  Eigen::VectorXcd x = b;
  Eigen::VectorXi pivots(n);
  int info = 0;
  zgesv_(&n, &kOne, factors.data(), &n, pivots.data(), x.data(), &n, &info);
  if (info != 0) x.setConstant(std::numeric_limits<double>::quiet_NaN());
  return x;
}

Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& A) { return ComplexLuFactors(A).inverse(); }

bool invert(Eigen::MatrixXcd& A) {
  using Small = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                              kMostInverted, kMostInverted>;
  const Eigen::PartialPivLU<Small> lu{Small(A)};
  for (const std::complex<double>& pivot : lu.matrixLU().diagonal())
    if (!(modulus(pivot) > 0.0)) return false;
  A = lu.inverse();
  return true;
}

double reciprocal_condition(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& inverse) {
  constexpr double kOfModuli = 2.0;  // |re| + |im| is at most sqrt(2) times the modulus
  const double product = largest_column(A) * largest_column(inverse);
  return std::isfinite(product) && product > 0.0 ? kOfModuli / product : 0.0;
}

}  // namespace signorini
