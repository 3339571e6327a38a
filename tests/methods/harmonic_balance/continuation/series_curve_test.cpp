#include "methods/harmonic_balance/continuation/series_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "methods/discretisation/fourier_series.hpp"
#include "tests/methods/harmonic_balance/continuation/series_families.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::series_curve_test {
namespace {

using test::family_of;

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

Eigen::MatrixXcd random_force(int harmonics, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXcd lambda(harmonics + 1, 1);
  for (auto& value : lambda.reshaped()) value = {normal(random), normal(random)};
  lambda.row(0) = lambda.row(0).real();
  return lambda;
}

TEST(SeriesCurve, JacobianWithTheFrequencyIsThatOfDifferences) {
  std::mt19937 random(7);
  for (const bool penalty : {false, true}) {
    for (const int multiple : {1, 2}) {
      const SeriesFamily family = family_of(test::to_problem(kStop), 6, penalty);
      SeriesCurve curve(family, multiple);
      const Eigen::VectorXd x = curve.unknowns(0.1 * random_force(6 * multiple, random), 1.6);
      ASSERT_TRUE(curve.evaluate(x));
      ASSERT_FALSE(curve.contacts().front().empty());
      const Eigen::MatrixXd jacobian = curve.jacobian();
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        constexpr double kStep = 1e-6;
        const auto at = [&](double step) {
          EXPECT_TRUE(curve.evaluate(x + step * Eigen::VectorXd::Unit(x.size(), i)));
          return curve.residual();
        };
        const Eigen::VectorXd slope = (at(kStep) - at(-kStep)) / (2.0 * kStep);
        EXPECT_LT((slope - jacobian.col(i)).norm(), 1e-7 * slope.norm()) << i << " of " << multiple;
      }
    }
  }
}

TEST(SeriesCurve, UnknownsAndForceAreInverse) {
  std::mt19937 random(3);
  const SeriesFamily family = family_of(test::to_problem(kStop), 5);
  const SeriesCurve curve(family, 1);
  const Eigen::MatrixXcd lambda = random_force(5, random);
  EXPECT_LT((curve.force(curve.unknowns(lambda, 2.0)) - lambda).norm(), 1e-13);
}

// The oracle shares no code with doubled_jacobian: differences of the equations of twice the period, whose
// unknowns have all harmonics.
TEST(SeriesCurve, DoubledJacobianIsABlockOfTheEquationsOfTwiceThePeriod) {
  std::mt19937 random(11);
  constexpr int kHarmonics = 5;
  const SeriesFamily family = family_of(test::to_problem(kStop), kHarmonics);
  SeriesCurve one(family, 1), two(family, 2);
  const Eigen::MatrixXcd lambda = random_force(kHarmonics, random);
  ASSERT_TRUE(one.evaluate(one.unknowns(lambda, 2.3)));
  const Eigen::MatrixXd block = one.doubled_jacobian();
  Eigen::MatrixXcd twice = Eigen::MatrixXcd::Zero(2 * kHarmonics + 1, 1);
  for (int n = 0; n <= kHarmonics; ++n) twice.row(2 * n) = lambda.row(n);
  const Eigen::VectorXd x = two.unknowns(twice, 2.3);
  // The residual is in the units of the unknowns; here both are wanted in those of lambda.
  const auto force_residual = [&](const Eigen::VectorXd& at) {
    EXPECT_TRUE(two.evaluate(at));
    return Eigen::VectorXd(two.residual().cwiseQuotient(two.weight()));
  };
  EXPECT_LT((unpack_harmonics(force_residual(x), 2 * kHarmonics)(Eigen::seqN(0, kHarmonics + 1, 2), 0) -
             unpack_harmonics(one.residual().cwiseQuotient(one.weight()), kHarmonics).col(0))
                .norm(),
            1e-9)
      << "the motion of one period solves the equations of two as well or ill";
  for (int m = 0; m < kHarmonics; ++m) {
    for (int part = 0; part < 2; ++part) {
      constexpr double kStep = 1e-6;
      const Eigen::Index place = 2 * (2 * m + 1) - 1 + part;  // of harmonic m + 1/2
      const Eigen::VectorXd step = kStep * two.weight()[place] * Eigen::VectorXd::Unit(x.size(), place);
      const Eigen::VectorXd slope = (force_residual(x + step) - force_residual(x - step)) / (2.0 * kStep);
      for (int n = 0; n <= 2 * kHarmonics; ++n) {
        for (int row = 0; row < (n == 0 ? 1 : 2); ++row) {
          const double found = slope[n == 0 ? 0 : 2 * n - 1 + row];
          const double expected = n % 2 == 0 ? 0.0 : block(n - 1 + row, 2 * m + part);
          EXPECT_NEAR(found, expected, 1e-5 * (1.0 + std::abs(expected))) << n << " " << m;
        }
      }
    }
  }
}

TEST(SeriesCurve, SignedPivotsAreASignAndAMean) {
  Eigen::Matrix3d A;
  A << 0.0, 2.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 36.0;  // determinant -216
  EXPECT_NEAR(signed_pivots(A), -6.0, 1e-14);
  A(2, 2) = 0.0;
  EXPECT_EQ(signed_pivots(A), 0.0);
}

TEST(SeriesCurve, IsNotDefinedAtNegativeFrequencies) {
  const SeriesFamily family = family_of(test::to_problem(kStop), 5);
  SeriesCurve curve(family, 1);
  EXPECT_FALSE(curve.evaluate(curve.unknowns(Eigen::MatrixXcd::Zero(6, 1), -1.0)));
  EXPECT_TRUE(curve.evaluate(curve.unknowns(Eigen::MatrixXcd::Zero(6, 1), 1.0)));
}

}  // namespace
}  // namespace signorini::series_curve_test
