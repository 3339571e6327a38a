#include "methods/linear_flow/harmonic_integrals.hpp"

#include <gtest/gtest.h>

#include <complex>

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

TEST(HarmonicIntegrals, OfNothingAreZero) {
  const Eigen::MatrixXcd sums =
      harmonic_integrals(Eigen::VectorXcd::Ones(1), Eigen::MatrixXcd::Zero(1, 1), 0.0, 1.0, 1.0, 4);
  EXPECT_TRUE(sums.isZero(0.0));
}

}  // namespace
}  // namespace signorini::harmonic_integrals_test
