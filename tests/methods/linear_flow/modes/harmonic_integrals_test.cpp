#include "methods/linear_flow/modes/harmonic_integrals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "methods/solvers/constants.hpp"

namespace signorini::harmonic_integrals_test {
namespace {

using Complex = std::complex<double>;

// Simpson's rule on many intervals, whose error is that of the fourth power of their length. The terms decay,
// decay fast, stand still, and turn with a harmonic, exactly and nearly, so that both ways to a quotient are
// taken.
TEST(HarmonicIntegrals, AreThoseOfSimpsonsRule) {
  constexpr int kHarmonics = 300, kIntervals = 1 << 16;
  constexpr double kBegin = 0.3, kEnd = 1.7, kRate = 1.1;
  const Eigen::VectorXcd rates{
      {{-0.3, 2.0}, {-40.0, 0.0}, {0.0, 0.0}, {0.0, 7.0 * kRate}, {-1e-9, 12.0 * kRate + 1e-7}}};
  Eigen::MatrixXcd terms(rates.size(), 2);
  terms << Complex(1.0, 0.5), Complex(0.0, 1.0), Complex(2.0, 0.0), Complex(-1.0, 0.0), Complex(0.7, 0.0),
      Complex(0.1, 0.0), Complex(0.0, -0.4), Complex(3.0, 1.0), Complex(0.2, 0.2), Complex(0.0, 0.0);
  const Eigen::MatrixXcd closed = harmonic_integrals(rates, terms, kBegin, kEnd, kRate, kHarmonics);
  ASSERT_EQ(closed.rows(), kHarmonics + 1);
  for (const int n : {0, 1, 7, 12, 255, 256, 300}) {
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(2);
    for (int i = 0; i <= 2 * kIntervals; ++i) {
      const double t = kBegin + (kEnd - kBegin) * i / (2.0 * kIntervals);
      const double weight = i == 0 || i == 2 * kIntervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      const Eigen::VectorXcd grown = (rates * (t - kBegin)).array().exp();
      const Eigen::VectorXd value = (terms.transpose() * grown).real();
      sum += weight * std::polar(1.0, -n * kRate * t) * value.cast<Complex>();
    }
    sum *= (kEnd - kBegin) / (6.0 * kIntervals);
    EXPECT_LT((closed.row(n).transpose() - sum).norm(), 1e-10) << n;
  }
}

// Far above a rate its quotients are left to the motion's derivatives at both ends. The same numbers as in
// one quotient per term and harmonic, at harmonics on both sides of where each rate becomes slow.
TEST(HarmonicIntegrals, AreThoseOfQuotientsAtHighHarmonics) {
  constexpr int kHarmonics = 3000, kTerms = 40;
  constexpr double kBegin = 0.25, kRate = 1.3;
  Eigen::VectorXcd rates(kTerms);
  Eigen::MatrixXcd terms(kTerms, 3);
  for (int k = 0; k < kTerms; ++k) {  // 0 and |nu| from 1 to 5e3, from undamped to overdamped
    const double size = k == 0 ? 0.0 : std::pow(5e3, (k - 1.0) / (kTerms - 2.0));
    rates[k] = std::polar(size, std::numbers::pi * (0.5 + 0.5 * (k % 5) / 4.0));
    for (int j = 0; j < 3; ++j) terms(k, j) = std::polar(1.0 / (1.0 + k), 1.0 * k * (j + 1));
  }
  // (e^z - 1) / z
  const auto mean = [](Complex z) {
    constexpr double kSmall = 1e-2;
    if (std::abs(z) > kSmall) return (std::exp(z) - 1.0) / z;
    Complex sum = 1.0;
    for (int k = 7; k > 1; --k) sum = 1.0 + sum * z / static_cast<double>(k);
    return sum;
  };
  for (const double duration : {0.75, 0x1p-7, 0x1p-13, 0x1p-17, 0x1p-30}) {  // no rounding of the end
    const Eigen::MatrixXcd closed =
        harmonic_integrals(rates, terms, kBegin, kBegin + duration, kRate, kHarmonics);
    for (const int n : {255, 256, 257, 511, 512, 700, 1023, 1024, 2047, 2048, 2999, 3000}) {
      Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(3);
      const Complex turn(0.0, n * kRate);
      for (int k = 0; k < kTerms; ++k) {
        sum += 0.5 * mean((rates[k] - turn) * duration) * terms.row(k).transpose();
        sum += 0.5 * mean((std::conj(rates[k]) - turn) * duration) * terms.row(k).adjoint();
      }
      sum *= duration * std::exp(-turn * kBegin);
      const double rounding = 1e-15 * terms.norm() / std::abs(turn);
      EXPECT_LT((closed.row(n).transpose() - sum).norm(), 1e-13 * sum.norm() + rounding)
          << n << ' ' << duration;
    }
  }
}

TEST(HarmonicIntegrals, OfNothingAreZero) {
  const Eigen::MatrixXcd sums =
      harmonic_integrals(Eigen::VectorXcd::Ones(1), Eigen::MatrixXcd::Zero(1, 1), 0.0, 1.0, 1.0, 4);
  EXPECT_TRUE(sums.isZero(0.0));
}

}  // namespace
}  // namespace signorini::harmonic_integrals_test
