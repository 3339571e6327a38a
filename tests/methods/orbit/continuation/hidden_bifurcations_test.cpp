// Which steps may hide two bifurcations: of test functions and multipliers with known zeros.

#include "methods/orbit/continuation/hidden_bifurcations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>

namespace signorini::hidden_bifurcations_test {
namespace {

// (s - 1)^2 + height has its zeros at 1 - d and 1 + d, d^2 = -height.
double valley(double s, double height) { return (s - 1.0) * (s - 1.0) + height; }

TEST(MayHideBifurcations, WhereATestFunctionTurnsNearZeroBetweenTwoPoints) {
  const auto tests = [](double value) {
    BifurcationTests at;
    at.values[static_cast<std::size_t>(SpecialKind::fold)] = value;
    return at;
  };
  const auto hides = [&](double height) {
    const TestsBefore before{.tests = tests(valley(0.3, height)), .length = 0.3};
    return may_hide_bifurcations(before, tests(valley(0.6, height)), 0.7, tests(valley(1.3, height)));
  };
  EXPECT_TRUE(hides(-0.01));
  EXPECT_TRUE(hides(1e-4));
  EXPECT_FALSE(hides(0.1));
  EXPECT_FALSE(may_hide_bifurcations({}, tests(0.15), 0.7, tests(0.08))) << "without a point before";
}

TEST(MayHideBifurcations, WhereMoreMultipliersHaveLeftTheCircleThanSignsTell) {
  BifurcationTests before, after;
  const auto sign = [](BifurcationTests& tests, SpecialKind kind, double value) {
    tests.values[static_cast<std::size_t>(kind)] = value;
  };
  before.multipliers = Eigen::Vector3cd(0.9, 0.8, 0.1);
  after.multipliers = Eigen::Vector3cd(1.2, 1.1, 0.1);
  EXPECT_TRUE(may_hide_bifurcations({}, before, 0.1, after));
  after.multipliers = Eigen::Vector3cd(1.2, -1.1, 0.1);
  for (const SpecialKind kind : {SpecialKind::fold, SpecialKind::period_doubling}) {
    EXPECT_TRUE(may_hide_bifurcations({}, before, 0.1, after));
    sign(before, kind, 1.0);
    sign(after, kind, -1.0);
  }
  EXPECT_FALSE(may_hide_bifurcations({}, before, 0.1, after)) << "one through 1, one through -1";
}

TEST(MayHideBifurcations, OfNoPairThatMeetsOutsideTheCircle) {
  BifurcationTests before, after;
  before.multipliers = Eigen::Vector2cd(std::polar(2.6, 3.1), std::polar(2.6, -3.1));
  after.multipliers = Eigen::Vector2cd(-2.7, -2.5);
  EXPECT_FALSE(may_hide_bifurcations({}, before, 0.1, after));
  after.multipliers = Eigen::Vector2cd(-0.9, -0.8);
  EXPECT_TRUE(may_hide_bifurcations({}, before, 0.1, after)) << "both have come inside";
}

// The determinant has the sign of the multiplier, and fades as another one passes -1 at a distance: what it
// says by its magnitude is of that other one.
struct Watched {
  const char* what;
  std::complex<double> direction;  // of the multiplier that leaves the circle and returns
};
void PrintTo(const Watched& watched, std::ostream* out) { *out << watched.what; }

class MayHideBifurcationsOfMultipliers : public testing::TestWithParam<Watched> {
 protected:
  // Multipliers at s: |mu| = exp(-valley) of the one watched, a pair that turns, and what has faded.
  [[nodiscard]] BifurcationTests at(double s, double height) const {
    const std::complex<double> mu = std::exp(-valley(s, height)) * GetParam().direction,
                               turning = 0.99 * std::polar(1.0, 3.0 * s + 1.0);
    BifurcationTests tests;
    for (auto& value : tests.values) value = std::pow(10.0, -4.0 * s);
    if (mu.imag() == 0.0)
      tests.multipliers = Eigen::Vector4cd(mu, turning, std::conj(turning), 1e-12 * s);
    else
      tests.multipliers = Eigen::Vector4cd(mu, std::conj(mu), 0.3, 1e-12 * s);
    return tests;
  }
  [[nodiscard]] bool hides(double height, bool with_test_for_pairs = true) const {
    BifurcationTests end = at(1.3, height);
    if (!with_test_for_pairs) end.values[static_cast<std::size_t>(SpecialKind::neimark_sacker)].reset();
    return may_hide_bifurcations(TestsBefore{.tests = at(0.3, height), .length = 0.3}, at(0.6, height), 0.7,
                                 end);
  }
};

TEST_P(MayHideBifurcationsOfMultipliers, WhoseTestFunctionFadesByDecades) {
  EXPECT_TRUE(hides(-0.01)) << "outside between two points inside";
  EXPECT_TRUE(hides(1e-4));
  EXPECT_FALSE(hides(0.1)) << "comes no nearer to the circle than a tenth";
  const bool pair = GetParam().direction.imag() != 0.0;
  EXPECT_EQ(hides(-0.01, false), !pair) << "of motions whose pairs stay on their circle";
}

INSTANTIATE_TEST_SUITE_P(Sorts, MayHideBifurcationsOfMultipliers,
                         testing::Values(Watched{"fold", 1.0}, Watched{"doubling", -1.0},
                                         Watched{"pair", std::polar(1.0, 2.0)}));

// Of two points only the largest are known: those that have no counterpart there are not looked at.
TEST(MayHideBifurcations, ByTheMultipliersThatAllPointsTellOf) {
  const auto hides = [](double height) {
    const auto at = [height](double s, bool leading) {
      BifurcationTests tests{.leading = leading};
      const double mu = std::exp(-valley(s, height));
      tests.multipliers = Eigen::Vector4cd(mu, -0.3, 0.2, 0.1);
      if (leading) tests.multipliers = Eigen::Vector2cd(mu, -0.3);
      return tests;
    };
    return may_hide_bifurcations(TestsBefore{.tests = at(0.3, true), .length = 0.3}, at(0.6, false), 0.7,
                                 at(1.3, true));
  };
  EXPECT_TRUE(hides(-0.01));
  EXPECT_FALSE(hides(0.1));
}

TEST(MayHideBifurcations, OfNoMultipliersThatAreOneToRounding) {
  const auto tests = [](double error) {
    BifurcationTests at;
    at.multipliers = Eigen::Vector2cd(1.0 + error, 1.0 - error);
    return at;
  };
  const TestsBefore before{.tests = tests(3e-9), .length = 0.1};
  EXPECT_FALSE(may_hide_bifurcations(before, tests(1e-9), 0.1, tests(2e-9)));
}

}  // namespace
}  // namespace signorini::hidden_bifurcations_test
