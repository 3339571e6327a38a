#include "methods/complementarity/exact_quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "methods/discretisation/fourier_series.hpp"

namespace signorini::exact_quadrature_test {
namespace {

using Complex = std::complex<double>;

/// 0.3 + cos(2 pi t) + 0.4 sin(4 pi t): positive on one interval across the period's end.
Eigen::VectorXcd some_polynomial() {
  Eigen::VectorXcd y(4);
  y << 0.3, 0.5, Complex(0.0, -0.2), 0.0;
  return y;
}

double value(const Eigen::VectorXcd& y, double t) {
  double sum = y[0].real();
  for (int n = 1; n < y.size(); ++n)
    sum += 2.0 * (y[n] * std::polar(1.0, 2.0 * std::numbers::pi * n * t)).real();
  return sum;
}

TEST(PositiveIntervals, EndWhereThePolynomialVanishes) {
  const Eigen::VectorXcd y = some_polynomial();
  const auto intervals = positive_intervals(y, 64);
  ASSERT_FALSE(intervals.empty());
  for (const auto& [begin, end] : intervals) {
    EXPECT_NEAR(value(y, begin), 0.0, 1e-13);
    EXPECT_NEAR(value(y, end), 0.0, 1e-13);
    EXPECT_GT(value(y, 0.5 * (begin + end)), 0.0);
    EXPECT_GT(end, begin);
  }
}

TEST(PositiveIntervals, AreTheWholePeriodOrNothingForAConstantSign) {
  Eigen::VectorXcd y(2);
  y << 2.0, 0.5;
  const auto whole = positive_intervals(y, 16);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].end - whole[0].begin, 1.0);
  EXPECT_TRUE(positive_intervals(-y, 16).empty());
}

TEST(PositiveIntervals, ShorterThanASampleAreSeen) {
  // cos(3 theta) shifted so that its three maxima lie between samples and reach 1e-5 above zero, then
  // its minima as far below.
  for (const double sign : {1.0, -1.0}) {
    Eigen::VectorXcd y = Eigen::VectorXcd::Zero(4);
    y[0] = -sign * (1.0 - 1e-5);
    y[3] = sign * std::polar(0.5, 0.7);
    const auto intervals = positive_intervals(y, 24);
    ASSERT_EQ(intervals.size(), 3U);
    const double width = 2.0 * std::acos(1.0 - 1e-5) / (2.0 * std::numbers::pi * 3.0);
    for (const auto& [begin, end] : intervals) {
      EXPECT_NEAR(end - begin, sign > 0.0 ? width : 1.0 / 3.0 - width, 1e-12);
    }
  }
}

TEST(IndicatorSpectrum, MatchesAFineSum) {
  const std::vector<ContactInterval> intervals{{0.1, 0.25}, {0.8, 1.05}};
  const Eigen::VectorXcd spectrum = indicator_spectrum(intervals, 7);
  constexpr int kSamples = 200000;
  for (int n = 0; n <= 7; ++n) {
    Complex sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const double t = (i + 0.5) / kSamples;
      const bool inside = (t > 0.1 && t < 0.25) || t > 0.8 || t < 0.05;
      if (inside) sum += std::polar(1.0 / kSamples, -2.0 * std::numbers::pi * n * t);
    }
    EXPECT_LE(std::abs(spectrum[n] - sum), 1e-5);
  }
}

TEST(ContactIndicator, RestrictsAPolynomialToItsIntervals) {
  const Eigen::VectorXcd y = some_polynomial();
  const auto intervals = positive_intervals(y, 64);
  const Eigen::VectorXcd restricted = ContactIndicator(intervals, 3).restrict(y);
  constexpr int kSamples = 100000;
  for (int n = 0; n <= 3; ++n) {
    Complex sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      sum += std::max(0.0, value(y, t)) * std::polar(1.0 / kSamples, -2.0 * std::numbers::pi * n * t);
    }
    // max(0, y) is continuous: the sum's error is O(1/N^2) times the jumps of slope, about 2 pi * 3 here.
    EXPECT_LE(std::abs(restricted[n] - sum), 1e-8);
  }
}

TEST(HarmonicVector, KeepsTheMeanSquareAndComesBack) {
  Eigen::MatrixXcd spectrum(4, 2);
  spectrum.setRandom();
  spectrum.row(0) = spectrum.row(0).real().cast<Complex>().eval();
  const Eigen::VectorXd packed = pack_harmonics(spectrum);
  double mean_square = 0.0;
  for (int c = 0; c < 2; ++c) {
    for (int i = 0; i < 16; ++i) mean_square += std::pow(value(spectrum.col(c), i / 16.0), 2) / 16;
  }
  EXPECT_NEAR(packed.squaredNorm(), mean_square, 1e-13);
  EXPECT_LE((unpack_harmonics(packed, 3) - spectrum).norm(), 1e-15);
}

}  // namespace
}  // namespace signorini::exact_quadrature_test
