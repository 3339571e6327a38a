#include "methods/solvers/ratio_test.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/support/random_lcp.hpp"

namespace signorini {
namespace {

using Kind = Blocking::Kind;

TEST(FindBlocking, TakesTheSmallestRatioWhereNoTwoAreNear) {
  std::mt19937 random(31);
  for (int trial = 0; trial < 500; ++trial) {
    const PathVariables value{test::random_vector(4, random).cwiseAbs(),
                              test::random_vector(6, random).cwiseAbs()};
    const PathVariables rate{test::random_vector(4, random), test::random_vector(6, random)};
    double least = std::numeric_limits<double>::infinity();
    Kind kind = Kind::none;
    int position = 0;
    const auto meet = [&](Kind of, int at, double v, double r) {
      if (r >= 0.0 || v / -r >= least) return;
      least = v / -r;
      kind = of;
      position = at;
    };
    for (int k = 0; k < 4; ++k) meet(k == 2 ? Kind::tau : Kind::z, k, value.basic[k], rate.basic[k]);
    for (int i = 0; i < 6; ++i) meet(Kind::w, i, value.w[i], rate.w[i]);
    const Blocking blocking = find_blocking(value, rate, 2, 1.0);
    ASSERT_EQ(blocking.kind, kind) << "trial " << trial;
    if (kind == Kind::none) continue;
    EXPECT_EQ(blocking.position, position);
    EXPECT_DOUBLE_EQ(blocking.step, least);
  }
}

TEST(FindBlocking, AmongTiesTakesTheLargestPivot) {
  const Eigen::Vector3d basic(1.0, 2.0, 0.5);
  const Eigen::Vector3d rates(-1.0, -2.0, -0.5);
  const Blocking blocking =
      find_blocking({basic, Eigen::Vector2d(3.0, 3.0)}, {rates, Eigen::Vector2d(-3.0, 1.0)}, -1, 1.0);
  EXPECT_EQ(blocking.kind, Kind::w);
  EXPECT_EQ(blocking.position, 0);
}

TEST(FindBlocking, PrefersALargePivotToOneThatRoundingMadeFirst) {
  // The first ratio is smaller by less than rounding, its pivot a billion times smaller.
  const double tiny = 1e-9;
  const PathVariables value{Eigen::Vector2d(tiny * (1.0 - 1e-16), 1.0), Eigen::VectorXd::Ones(1)};
  const PathVariables rate{Eigen::Vector2d(-tiny, -1.0), Eigen::VectorXd::Zero(1)};
  EXPECT_EQ(find_blocking(value, rate, -1, 1.0).position, 1);
}

TEST(FindBlocking, LetsTauGoFirstAmongTies) {
  const PathVariables value{Eigen::Vector2d(1.0, 1.0), Eigen::VectorXd::Ones(1)};
  const PathVariables rate{Eigen::Vector2d(-1.0, -1.0), Eigen::VectorXd::Constant(1, -1.0)};
  EXPECT_EQ(find_blocking(value, rate, 1, 1.0).kind, Kind::tau);
  EXPECT_EQ(find_blocking(value, rate, -1, 1.0).kind, Kind::z);
}

TEST(FindBlocking, CountsAValuePushedBelowZeroByRoundingAsZero) {
  const PathVariables value{Eigen::VectorXd::Constant(1, -1e-16), Eigen::VectorXd::Ones(1)};
  const PathVariables rate{Eigen::VectorXd::Constant(1, -1.0), Eigen::VectorXd::Zero(1)};
  const Blocking blocking = find_blocking(value, rate, -1, 1.0);
  EXPECT_EQ(blocking.kind, Kind::z);
  EXPECT_EQ(blocking.step, 0.0);
}

TEST(FindBlocking, FindsARayWhereNothingFalls) {
  const PathVariables value{Eigen::VectorXd::Ones(2), Eigen::VectorXd::Ones(2)};
  const PathVariables rate{Eigen::VectorXd::Zero(2), Eigen::VectorXd::Constant(2, 1.0)};
  EXPECT_EQ(find_blocking(value, rate, 0, 1.0).kind, Kind::none);
}

}  // namespace
}  // namespace signorini
