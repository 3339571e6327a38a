// Equations (31)-(45) of the source paper [shi2015], as printed and corrected: several coordinates, one stop.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/KroneckerProduct>

#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/reference/source_basis.hpp"

namespace signorini::source_reduction_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::gram;
using test::phi;

// Three masses in a row, the last one at the stop: (37)-(45) against the receptance of the structure.
class SourceReduction : public testing::Test {
 protected:
  static constexpr int kHarmonics = 3;
  static constexpr double kOmega = 1.3;
  const MatrixXd mass_ = Eigen::Vector3d(1.0, 2.0, 1.5).asDiagonal();
  const MatrixXd stiffness_ = (MatrixXd(3, 3) << 5.0, -2.0, 0.0, -2.0, 3.5, -1.5, 0.0, -1.5, 1.5).finished();
  const MatrixXd damping_ = 0.05 * stiffness_ + 0.02 * mass_;
  const MatrixXd unit_ = gram(kHarmonics, kOmega, 0);  // L_K
  const Eigen::Index size_ = 2 * kHarmonics + 1;
  const Eigen::Index inner_ = 2 * size_;  // unknowns of the two masses without a stop

  // (40), with L_K or the printed I in the block K_22.
  [[nodiscard]] MatrixXd system(bool as_printed) const {
    MatrixXd a = Eigen::kroneckerProduct(mass_, gram(kHarmonics, kOmega, 2)).eval() +
                 Eigen::kroneckerProduct(damping_, gram(kHarmonics, kOmega, 1)).eval() +
                 Eigen::kroneckerProduct(stiffness_, unit_).eval();
    if (as_printed) {
      a.bottomRightCorner(size_, size_) += stiffness_(2, 2) * (MatrixXd::Identity(size_, size_) - unit_);
    }
    return a;
  }

  // A_r of (43).
  [[nodiscard]] MatrixXd reduced(bool as_printed) const {
    const MatrixXd a = system(as_printed);
    return LuFactors(unit_).inverse() *
           (a.bottomRightCorner(size_, size_) -
            a.bottomLeftCorner(size_, inner_) *
                lu_solve(a.topLeftCorner(inner_, inner_), MatrixXd(a.topRightCorner(inner_, size_))));
  }

  // What (45) must be: u_2 = C_n lambda harmonic by harmonic, from the complex dynamic stiffness.
  [[nodiscard]] MatrixXd receptance() const {
    MatrixXd r = MatrixXd::Zero(size_, size_);
    for (int n = 0; n <= kHarmonics; ++n) {
      const double w = n * kOmega;
      const Eigen::MatrixXcd z =
          (stiffness_ - w * w * mass_).cast<std::complex<double>>() + std::complex<double>(0.0, w) * damping_;
      const std::complex<double> c = inverse(z)(2, 2);
      r(n, n) = c.real();
      if (n == 0) continue;
      // a cos + b sin = Re((a - i b) e^{iwt}).
      r(kHarmonics + n, kHarmonics + n) = c.real();
      r(kHarmonics + n, n) = -c.imag();
      r(n, kHarmonics + n) = c.imag();
    }
    return r;
  }
};

// (31)-(33): what the integrals over a period of (I x phi)^T M (I x phi'') and its like come to.
TEST_F(SourceReduction, Equations31To33AreKroneckerProducts) {
  const int samples = 4 * kHarmonics + 4;
  const double step = 2.0 * std::numbers::pi / kOmega / samples;
  const MatrixXd identity = MatrixXd::Identity(3, 3);
  int derivative = 0;
  for (const MatrixXd& matrix : {stiffness_, damping_, mass_}) {
    MatrixXd sum = MatrixXd::Zero(3 * size_, 3 * size_);
    for (int i = 0; i < samples; ++i) {
      const MatrixXd left = Eigen::kroneckerProduct(identity, phi(kHarmonics, kOmega, i * step));
      const MatrixXd right = Eigen::kroneckerProduct(identity, phi(kHarmonics, kOmega, i * step, derivative));
      sum += step * left.transpose() * matrix * right;
    }
    const MatrixXd product = Eigen::kroneckerProduct(matrix, gram(kHarmonics, kOmega, derivative));
    EXPECT_LE((sum - product).norm(), 1e-13 * product.norm()) << "derivative " << derivative;
    ++derivative;
  }
}

TEST_F(SourceReduction, WithEquation40CorrectedIsTheReceptanceAtTheStop) {
  const MatrixXd product = reduced(false) * receptance();
  EXPECT_LE((product - MatrixXd::Identity(size_, size_)).norm(),
            1e-12 * std::sqrt(static_cast<double>(size_)));
}

TEST_F(SourceReduction, WithEquation40AsPrintedIsNot) {
  const MatrixXd product = reduced(true) * receptance();
  EXPECT_GE((product - MatrixXd::Identity(size_, size_)).norm(), 0.1 * std::sqrt(static_cast<double>(size_)));
}

TEST_F(SourceReduction, Equation41NeedsTheGramMatrixOnTheLoad) {
  const MatrixXd a = system(false);
  VectorXd load = VectorXd::Zero(3 * size_);
  load[1] = 1.0;
  load[size_ + kHarmonics + 2] = -0.7;
  const VectorXd u =
      lu_solve(a, VectorXd(Eigen::kroneckerProduct(MatrixXd::Identity(3, 3), unit_).eval() * load));
  const LuFactors inner(a.topLeftCorner(inner_, inner_));
  const VectorXd from_contact = inner.solve(VectorXd(a.topRightCorner(inner_, size_) * u.tail(size_)));
  const VectorXd weighted =
      Eigen::kroneckerProduct(MatrixXd::Identity(2, 2), unit_).eval() * load.head(inner_);
  const VectorXd corrected = -from_contact + inner.solve(weighted);
  const VectorXd printed = -from_contact + inner.solve(VectorXd(load.head(inner_)));
  EXPECT_LE((corrected - u.head(inner_)).norm(), 1e-12 * u.norm());
  EXPECT_GE((printed - u.head(inner_)).norm(), 0.1 * u.norm());
}

// (42)-(45) with a load on every mass: what is printed follows from (39).
TEST_F(SourceReduction, Equations42To45FollowFromTheWholeSystem) {
  const MatrixXd a = system(false);
  const MatrixXd weigh = Eigen::kroneckerProduct(MatrixXd::Identity(3, 3), unit_).eval();
  const VectorXd load = VectorXd::LinSpaced(3 * size_, 1.0, -0.6);
  const VectorXd lambda = VectorXd::LinSpaced(size_, -0.8, 0.3);
  VectorXd push = load;
  push.tail(size_) += lambda;
  const VectorXd u = lu_solve(a, VectorXd(weigh * push));
  const VectorXd inner = lu_solve(a.topLeftCorner(inner_, inner_),
                                  VectorXd(weigh.topLeftCorner(inner_, inner_) * load.head(inner_)));
  const VectorXd reduced_load =
      LuFactors(unit_).inverse() * (unit_ * load.tail(size_) - a.bottomLeftCorner(size_, inner_) * inner);
  EXPECT_LE((reduced(false) * u.tail(size_) - lambda - reduced_load).norm(), 1e-12 * load.norm());
}

}  // namespace
}  // namespace signorini::source_reduction_test
