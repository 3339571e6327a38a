#include "harness/judge/measures/force_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/harness/fake_method.hpp"

namespace signorini::force_error_test {
namespace {

constexpr double kPeriod = std::numbers::pi;  // of one_mass(): omega = 2

/// cos 2 t, impulses by shares of the period, and a force.
Motion motion(const std::vector<std::pair<double, double>>& impulses, double constant = 0.0,
              double varying = 0.0, int harmonic = 1) {
  std::vector<Impulse> list;
  for (const auto& [share, value] : impulses) list.push_back({0, share * kPeriod, -value});
  return sample_motion(
      test::one_mass(),
      test::FormulaMotion(
          kPeriod, [](double t) { return std::cos(2.0 * t); },
          [](double t) { return -2.0 * std::sin(2.0 * t); },
          [=](double t) { return -constant + varying * std::cos(2.0 * harmonic * t); }, list));
}

double error(const Motion& answer, const Motion& orbit) {
  return force_errors(answer, orbit).worst().value();
}

TEST(ForceErrors, OfAnImpulseIsItsShare) {
  const Motion orbit = motion({{0.2, 2.0}});
  EXPECT_NEAR(error(motion({{0.2, 1.02}}), orbit), 0.49, 1e-12);
  EXPECT_NEAR(error(motion({{0.2, 3.9}}), orbit), 0.95, 1e-12);
  EXPECT_NEAR(error(motion({}), orbit), 1.0, 1e-12);
  EXPECT_NEAR(error(motion({{0.2, 2.0}, {0.7, 0.48}}), orbit), 0.24, 1e-12) << "one that did not happen";
}

TEST(ForceErrors, CountHowLateAnImpulseIs) {
  const Motion orbit = motion({{0.2, 1.0}});
  // |exp(-2 pi i n d) - 1|^2 = 4 sin^2(pi n d), summed with the weights by hand.
  const auto late = [](double d) {
    double apart = 0.0, whole = 1.0;
    for (int n = 1; n <= 512; ++n) {
      const double weight = 2.0 / std::pow(1.0 + n * n, 2);
      apart += weight * 4.0 * std::pow(std::sin(std::numbers::pi * n * d), 2);
      whole += weight;
    }
    return std::sqrt(apart / whole);
  };
  for (const double d : {0.04, 0.14, 0.001})
    EXPECT_NEAR(error(motion({{0.2 + d, 1.0}}), orbit), late(d), 1e-9);
  EXPECT_NEAR(late(0.001), 0.98 * 2.0 * std::numbers::pi * 0.001, 1e-4);
  EXPECT_GT(late(0.04), 0.2);
}

TEST(ForceErrors, OfAContactThatPushesThroughoutAreOfWhatVaries) {
  EXPECT_NEAR(error(motion({}, 3.0), motion({}, 3.0, 2.0)), 1.0, 1e-9) << "its mean in its place";
  // cos 2 t: (1/2)^2 of two sides with the weight 1/2 is 0.5 * 0.5 / sqrt(2), less than a tenth of the mean.
  EXPECT_NEAR(error(motion({}, 30.0), motion({}, 30.0, 0.5)), 0.5 * 0.5 * std::numbers::sqrt2 / 2.0 / 3.0,
              1e-3);
}

TEST(ForceErrors, AreTakenOverTheCommonPeriodAndAreNoneWithoutForce) {
  EXPECT_EQ(force_errors(motion({{0.2, 1.0}}), motion({})).worst(), std::nullopt);
  Motion twice = motion({{0.1, 1.0}, {0.6, 1.0}});  // as one period of two of the load
  twice.order = 2;
  twice.forcing_period = kPeriod / 2.0;
  Motion once = motion({{0.2, 1.0}});
  once.forcing_period = kPeriod / 2.0;
  once.impulses.front().time = 0.2 * kPeriod / 2.0;
  EXPECT_NEAR(error(once, twice), 0.0, 1e-12);
}

TEST(ForceErrors, OfACoarseAnswerAreThoseOfItsHarmonics) {
  Motion coarse = motion({}, 1.0, 0.0);
  coarse.bandwidth = 1;
  const Motion orbit = motion({}, 1.0, 0.9, 2);
  EXPECT_NEAR(error(coarse, orbit), 0.0, 1e-9);
  coarse.shown = 2;
  EXPECT_GT(error(coarse, orbit), 0.5) << "its x shows the harmonic that its force lacks";
}

TEST(ForceErrorUpTo, SeesWhatIsChopped) {
  const Motion orbit = motion({}, 1.0);
  Motion chopped = orbit;
  for (Eigen::Index i = 0; i < chopped.samples.force.rows(); ++i)
    chopped.samples.force.row(i) *= i * 80 / chopped.samples.force.rows() % 2 == 0 ? 2.0 : 0.0;
  EXPECT_LT(error(chopped, orbit), 0.01);
  EXPECT_NEAR(force_error_up_to(10.0, chopped, orbit).value(), 0.0, 1e-2);
  // A square wave of 0 and 2 is off by 1, of which its first harmonic has 8 / pi^2.
  EXPECT_NEAR(force_error_up_to(50.0, chopped, orbit).value(), std::sqrt(8.0) / std::numbers::pi, 1e-2);
}

}  // namespace
}  // namespace signorini::force_error_test
