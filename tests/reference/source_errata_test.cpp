// Equations (22), (40) and (41) of the source paper, as printed and corrected (docs/theory.md, erratum).

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/KroneckerProduct>

#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// phi(t) = [1/sqrt 2, cos wt, .., cos Mwt, sin wt, .., sin Mwt] and its derivatives (seed eq. 11-13).
Eigen::RowVectorXd phi(int harmonics, double w, double t, int derivative = 0) {
  Eigen::RowVectorXd row(2 * harmonics + 1);
  row[0] = derivative == 0 ? 1.0 / std::numbers::sqrt2 : 0.0;
  for (int n = 1; n <= harmonics; ++n) {
    const double rate = std::pow(n * w, derivative);
    const double angle = n * w * t + 0.5 * std::numbers::pi * derivative;
    row[n] = rate * std::cos(angle);
    row[harmonics + n] = rate * std::sin(angle);
  }
  return row;
}

// Integral of phi^T (d/dt)^derivative phi over a period, by a sum that is exact for it (eq. 17-19).
MatrixXd gram(int harmonics, double w, int derivative) {
  const int samples = 4 * harmonics + 4;
  const double step = 2.0 * std::numbers::pi / w / samples;
  MatrixXd sum = MatrixXd::Zero(2 * harmonics + 1, 2 * harmonics + 1);
  for (int i = 0; i < samples; ++i) {
    sum += step * phi(harmonics, w, i * step).transpose() * phi(harmonics, w, i * step, derivative);
  }
  return sum;
}

TEST(SourceErrata, Equation17IsPiOverOmegaTimesIdentity) {
  const MatrixXd expected = std::numbers::pi / 1.7 * MatrixXd::Identity(9, 9);
  EXPECT_LE((gram(4, 1.7, 0) - expected).norm(), 1e-13 * expected.norm());
}

// One mass, one stop; residuals of the contact equation summed over the grid.
class ContactEquation : public testing::Test {
 protected:
  static constexpr int kHarmonics = 12;
  static constexpr int kSamples = 384;
  static constexpr double kConstant = 10.0;
  const test::ImpactOscillator oscillator_{.damping = 0.1, .frequency = 2.2, .gap = 0.2};

  // dt sum phi^T (first + max(0, c (phi u - g) - phi lambda)): `first` is phi u in (22) as printed, where
  // phi lambda is meant.
  [[nodiscard]] double residual(const VectorXd& u, const VectorXd& lambda, bool as_printed) const {
    const double w = oscillator_.frequency, step = 2.0 * std::numbers::pi / w / kSamples;
    VectorXd sum = VectorXd::Zero(u.size());
    for (int i = 0; i < kSamples; ++i) {
      const Eigen::RowVectorXd row = phi(kHarmonics, w, i * step);
      const double y = kConstant * (row.dot(u) - oscillator_.gap) - row.dot(lambda);
      sum += step * row.transpose() * ((as_printed ? row.dot(u) : row.dot(lambda)) + std::max(0.0, y));
    }
    return sum.norm();
  }

  // (21): m L_M u + d L_D u + k L_K u - L_K (lambda + f).
  [[nodiscard]] double balance(const VectorXd& u, const VectorXd& lambda) const {
    const double w = oscillator_.frequency;
    VectorXd load = VectorXd::Zero(u.size());
    load[1] = oscillator_.load;
    return ((gram(kHarmonics, w, 2) + oscillator_.damping * gram(kHarmonics, w, 1) + gram(kHarmonics, w, 0)) *
                u -
            gram(kHarmonics, w, 0) * (lambda + load))
        .norm();
  }

  // Complex coefficients in the real basis.
  static VectorXd in_basis(const Eigen::VectorXcd& spectrum) {
    VectorXd real(2 * kHarmonics + 1);
    real[0] = std::numbers::sqrt2 * spectrum[0].real();
    for (int n = 1; n <= kHarmonics; ++n) {
      real[n] = 2.0 * spectrum[n].real();
      real[kHarmonics + n] = -2.0 * spectrum[n].imag();
    }
    return real;
  }
};

// With c g >= |f| the mass that never moves, held by lambda = -f of both signs, solves (21) and (22) as
// printed: an adhesive stop at zero. The corrected equation refuses it.
TEST_F(ContactEquation, AsPrintedIsSolvedByAMassHeldInPlace) {
  const VectorXd rest = VectorXd::Zero(2 * kHarmonics + 1);
  VectorXd hold = rest;
  hold[1] = -oscillator_.load;
  ASSERT_GE(kConstant * oscillator_.gap, oscillator_.load);
  EXPECT_LE(balance(rest, hold), 1e-13);
  EXPECT_EQ(residual(rest, hold, true), 0.0);
  EXPECT_GE(residual(rest, hold, false), 1.0);
}

TEST_F(ContactEquation, AsPrintedIsNotSolvedByTheContactMotion) {
  const Solution solution = test::solve<FourierLipschitz>(
      test::to_problem(oscillator_),
      {.common = {.harmonics = kHarmonics, .samples = kSamples, .quadrature = Quadrature::sampled},
       .c = kConstant});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const auto& data = dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data();
  const VectorXd u = in_basis(data.x.col(0)), lambda = in_basis(data.lambda.col(0));
  EXPECT_LE(balance(u, lambda), 1e-10 * lambda.norm());
  EXPECT_LE(residual(u, lambda, false), 1e-9 * lambda.norm());
  EXPECT_GE(residual(u, lambda, true), 0.1 * lambda.norm());
}

// Three masses in a row, the last one at the stop: (37)-(45) against the receptance of the structure.
class Reduction : public testing::Test {
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
    return unit_.inverse() *
           (a.bottomRightCorner(size_, size_) -
            a.bottomLeftCorner(size_, inner_) *
                a.topLeftCorner(inner_, inner_).lu().solve(a.topRightCorner(inner_, size_)));
  }

  // What (45) must be: u_2 = C_n lambda harmonic by harmonic, from the complex dynamic stiffness.
  [[nodiscard]] MatrixXd receptance() const {
    MatrixXd r = MatrixXd::Zero(size_, size_);
    for (int n = 0; n <= kHarmonics; ++n) {
      const double w = n * kOmega;
      const Eigen::MatrixXcd z =
          (stiffness_ - w * w * mass_).cast<std::complex<double>>() + std::complex<double>(0.0, w) * damping_;
      const std::complex<double> c = z.inverse()(2, 2);
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

TEST_F(Reduction, WithEquation40CorrectedIsTheReceptanceAtTheStop) {
  const MatrixXd product = reduced(false) * receptance();
  EXPECT_LE((product - MatrixXd::Identity(size_, size_)).norm(),
            1e-12 * std::sqrt(static_cast<double>(size_)));
}

TEST_F(Reduction, WithEquation40AsPrintedIsNot) {
  const MatrixXd product = reduced(true) * receptance();
  EXPECT_GE((product - MatrixXd::Identity(size_, size_)).norm(), 0.1 * std::sqrt(static_cast<double>(size_)));
}

TEST_F(Reduction, Equation41NeedsTheGramMatrixOnTheLoad) {
  const MatrixXd a = system(false);
  VectorXd load = VectorXd::Zero(3 * size_);
  load[1] = 1.0;
  load[size_ + kHarmonics + 2] = -0.7;
  const VectorXd u = a.lu().solve(Eigen::kroneckerProduct(MatrixXd::Identity(3, 3), unit_).eval() * load);
  const auto inner = a.topLeftCorner(inner_, inner_).lu();
  const VectorXd from_contact = inner.solve(a.topRightCorner(inner_, size_) * u.tail(size_));
  const VectorXd weighted =
      Eigen::kroneckerProduct(MatrixXd::Identity(2, 2), unit_).eval() * load.head(inner_);
  const VectorXd corrected = -from_contact + inner.solve(weighted);
  const VectorXd printed = -from_contact + inner.solve(load.head(inner_));
  EXPECT_LE((corrected - u.head(inner_)).norm(), 1e-12 * u.norm());
  EXPECT_GE((printed - u.head(inner_)).norm(), 0.1 * u.norm());
}

}  // namespace
}  // namespace signorini
