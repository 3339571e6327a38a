#include "methods/discretisation/real_fft.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace signorini::real_fft_test {
namespace {

class RealFftOfSize : public testing::TestWithParam<int> {};

Eigen::VectorXd some_signal(int samples) {
  Eigen::VectorXd values(samples);
  for (int i = 0; i < samples; ++i) values[i] = std::sin(1.7 * i) + 0.3 * (i % 5);
  return values;
}

TEST_P(RealFftOfSize, CoefficientsMatchDirectSums) {
  const int samples = GetParam();
  const Eigen::VectorXd values = some_signal(samples);
  RealFft fft(samples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  fft.forward(values, spectrum);
  for (int n = 0; n < fft.coefficients(); ++n) {
    std::complex<double> direct = 0.0;
    for (int i = 0; i < samples; ++i) {
      direct += values[i] * std::polar(1.0 / samples, -2.0 * std::numbers::pi * n * i / samples);
    }
    EXPECT_NEAR(std::abs(spectrum[n] - direct), 0.0, 1e-13 * values.norm()) << "n = " << n;
  }
}

TEST_P(RealFftOfSize, InverseUndoesForward) {
  const int samples = GetParam();
  const Eigen::VectorXd values = some_signal(samples);
  RealFft fft(samples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  Eigen::VectorXd back(samples);
  fft.forward(values, spectrum);
  fft.inverse(spectrum, back);
  EXPECT_NEAR((back - values).norm(), 0.0, 1e-14 * samples * values.norm());
}

INSTANTIATE_TEST_SUITE_P(EvenAndOdd, RealFftOfSize,
                         testing::Values(1, 2, 3, 4, 8, 15, 16, 32, 64, 128, 160, 256, 512));

TEST(RealFft, MissingCoefficientsAreZero) {
  RealFft fft(8);
  Eigen::VectorXcd spectrum(2);
  spectrum << 1.0, std::complex<double>(0.0, -0.5);  // 1 + sin
  Eigen::VectorXd values(8);
  fft.inverse(spectrum, values);
  EXPECT_NEAR(values[2], 2.0, 1e-15);
  EXPECT_NEAR(values[6], 0.0, 1e-15);
}

// cos(N/2 t) at the nodes: what stands at 0 and N/2 has no imaginary part, whatever is given there.
TEST(RealFft, TakesTheRealPartsOfTheMeanAndOfTheHighestCoefficient) {
  for (const int samples : {6, 64}) {
    RealFft fft(samples);
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero(fft.coefficients());
    spectrum[0] = std::complex<double>(2.0, 5.0);
    spectrum[samples / 2] = std::complex<double>(1.0, -3.0);
    Eigen::VectorXd values(samples);
    fft.inverse(spectrum, values);
    for (int i = 0; i < samples; ++i) EXPECT_NEAR(values[i], i % 2 == 0 ? 3.0 : 1.0, 1e-14) << samples;
  }
}

TEST(RealFft, TwoTransformsOfOneSizeDoNotDisturbEachOther) {
  RealFft first(6);
  RealFft second(6);
  Eigen::VectorXcd a(4);
  Eigen::VectorXcd b(4);
  first.forward(Eigen::VectorXd::Ones(6), a);
  second.forward(2.0 * Eigen::VectorXd::Ones(6), b);
  EXPECT_EQ(a[0].real(), 1.0);
  EXPECT_EQ(b[0].real(), 2.0);
}

}  // namespace
}  // namespace signorini::real_fft_test
