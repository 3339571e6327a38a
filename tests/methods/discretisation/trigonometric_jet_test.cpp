#include "methods/discretisation/trigonometric_jet.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini {
namespace {

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

}  // namespace
}  // namespace signorini
