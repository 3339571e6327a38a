#include "methods/discretisation/fourier_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace signorini::fourier_series_test {
namespace {

TEST(RepeatedSeries, IsTheSameFunctionOverSeveralPeriods) {
  constexpr int kInstants = 7;
  Eigen::MatrixXcd y(3, 2);
  y << 0.5, -1.0, std::complex<double>(1.5, 0.2), 0.3, std::complex<double>(0.0, 1.0), -0.7;
  const Eigen::MatrixXcd three = repeated(y, 3);
  EXPECT_EQ(three.rows(), 7);
  EXPECT_LT((sample_series(three, 3 * kInstants) - sample_series(y, kInstants).replicate(3, 1)).norm(),
            1e-13);
  EXPECT_EQ(repeated(y, 1), y);
}

TEST(TrigonometricJet, OfAnElementaryFunctionIsItsValueAndDerivatives) {
  // y = 0.5 + 3 cos(2 pi t) - 2 sin(4 pi t).
  Eigen::VectorXcd y(3);
  y << 0.5, 1.5, std::complex<double>(0.0, 1.0);
  constexpr double kPi = std::numbers::pi;
  for (const double t : {0.0, 0.13, 0.5, 0.77, -1.4}) {
    const Jet jet = trigonometric_jet(y, t);
    EXPECT_NEAR(jet.value, 0.5 + 3.0 * std::cos(2 * kPi * t) - 2.0 * std::sin(4 * kPi * t), 1e-14);
    EXPECT_NEAR(jet.slope, -6 * kPi * std::sin(2 * kPi * t) - 8 * kPi * std::cos(4 * kPi * t), 1e-12);
    EXPECT_NEAR(jet.curvature,
                -12 * kPi * kPi * std::cos(2 * kPi * t) + 32 * kPi * kPi * std::sin(4 * kPi * t), 1e-11);
  }
}

TEST(TrigonometricJet, HasTheDifferenceQuotientsOfItsValues) {
  Eigen::VectorXcd y = Eigen::VectorXcd::Random(30);
  y[0] = 0.2;
  constexpr double kH = 1e-5;
  for (double t = 0.0; t < 1.0; t += 0.093) {
    const double before = trigonometric_jet(y, t - kH).value;
    const double after = trigonometric_jet(y, t + kH).value;
    const Jet jet = trigonometric_jet(y, t);
    EXPECT_NEAR(jet.slope, (after - before) / (2 * kH), 1e-2);                        // of some 1e3
    EXPECT_NEAR(jet.curvature, (after - 2.0 * jet.value + before) / (kH * kH), 5.0);  // of some 1e5
  }
}

TEST(TrigonometricJet, OfAConstantDoesNotMove) {
  const Jet jet = trigonometric_jet(Eigen::VectorXcd::Constant(1, 4.0), 0.3);
  EXPECT_EQ(jet.value, 4.0);
  EXPECT_EQ(jet.slope, 0.0);
  EXPECT_EQ(jet.curvature, 0.0);
}

TEST(HarmonicVector, HasTheRootMeanSquareInTimeForItsNorm) {
  constexpr int kSamples = 64;
  Eigen::MatrixXcd spectrum = Eigen::MatrixXcd::Random(6, 2);
  spectrum.row(0) = spectrum.row(0).real().cast<std::complex<double>>();
  double mean_square = 0.0;
  for (Eigen::Index c = 0; c < 2; ++c) {
    for (int k = 0; k < kSamples; ++k) {
      double value = spectrum(0, c).real();
      for (int n = 1; n < 6; ++n)
        value += 2.0 * (spectrum(n, c) * std::polar(1.0, 2.0 * std::numbers::pi * n * k / kSamples)).real();
      mean_square += value * value / kSamples;
    }
  }
  EXPECT_NEAR(pack_harmonics(spectrum).squaredNorm(), mean_square, 1e-12 * mean_square);
}

TEST(HarmonicVector, IsOrderedByContactAndHarmonic) {
  Eigen::MatrixXcd spectrum(2, 2);
  spectrum << 1.0, 4.0, std::complex<double>(2.0, 3.0), std::complex<double>(5.0, 6.0);
  Eigen::VectorXd expected(6);
  const double root = std::sqrt(2.0);
  expected << 1.0, 2.0 * root, 3.0 * root, 4.0, 5.0 * root, 6.0 * root;
  EXPECT_LE((pack_harmonics(spectrum) - expected).norm(), 1e-14);
}

TEST(HarmonicVector, IsUnpackedToWhereItCameFrom) {
  Eigen::MatrixXcd spectrum = Eigen::MatrixXcd::Random(4, 3);
  spectrum.row(0) = spectrum.row(0).real().cast<std::complex<double>>();
  EXPECT_LE((unpack_harmonics(pack_harmonics(spectrum), 3) - spectrum).norm(), 1e-15);
  const Eigen::VectorXd packed = Eigen::VectorXd::Random(21);
  EXPECT_LE((pack_harmonics(unpack_harmonics(packed, 3)) - packed).norm(), 1e-15 * packed.norm() * 21);
}

TEST(HarmonicVector, DropsTheImaginaryPartOfTheMean) {
  Eigen::MatrixXcd spectrum(1, 1);
  spectrum << std::complex<double>(1.5, 7.0);
  EXPECT_EQ(pack_harmonics(spectrum)[0], 1.5);
}

}  // namespace
}  // namespace signorini::fourier_series_test
