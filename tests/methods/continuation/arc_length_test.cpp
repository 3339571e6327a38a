#include "methods/continuation/arc_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::arc_length_test {
namespace {

/// x^2 + p^2 = 1: folds at p = 1 and p = -1.
class Circle {
 public:
  [[nodiscard]] Eigen::Index size() const { return 1; }
  bool evaluate(const Eigen::VectorXd& x) {
    x_ = x;
    return x.allFinite();
  }
  [[nodiscard]] Eigen::VectorXd residual() const {
    return Eigen::VectorXd::Constant(1, x_.squaredNorm() - 1.0);
  }
  [[nodiscard]] Eigen::MatrixXd jacobian() const { return 2.0 * x_.transpose(); }
  [[nodiscard]] double noise() const { return 1e-16; }
  [[nodiscard]] const Eigen::VectorXd& x() const { return x_; }

 private:
  Eigen::VectorXd x_;
};

TEST(ArcLength, GoesOnceAroundACircle) {
  Circle circle;
  Eigen::VectorXd x = Eigen::Vector2d(1.0, 0.0), tangent = Eigen::Vector2d(0.0, 1.0);
  double travelled = 0.0;
  int folds = 0;
  for (int k = 0; k < 40; ++k) {
    // Steps of this length to either side are one fortieth of the circle.
    ASSERT_TRUE(correct(circle, Eigen::VectorXd(x + std::sin(std::numbers::pi / 20.0) * tangent), tangent));
    travelled += std::acos(x.dot(circle.x()));
    const auto next = tangent_of(circle, tangent);
    ASSERT_TRUE(next);
    folds += (*next)[1] * tangent[1] < 0.0 ? 1 : 0;
    x = circle.x();
    tangent = *next;
    EXPECT_NEAR(x.norm(), 1.0, 1e-13);
    EXPECT_NEAR(tangent.dot(x), 0.0, 1e-13);
  }
  EXPECT_NEAR(travelled, 2.0 * std::numbers::pi, 1e-10);
  EXPECT_EQ(folds, 2);
}

TEST(ArcLength, LocatesAFoldToRounding) {
  Circle circle;
  const Eigen::VectorXd x = Eigen::Vector2d(std::sin(0.3), std::cos(0.3));
  const Eigen::VectorXd tangent = Eigen::Vector2d(-std::cos(0.3), std::sin(0.3));
  const auto slope = [&](Circle& at) {
    const auto there = tangent_of(at, tangent);
    return there ? std::optional((*there)[1]) : std::nullopt;
  };
  ASSERT_TRUE(correct(circle, Eigen::VectorXd(x + 0.5 * tangent), tangent));
  ASSERT_TRUE(locate(circle, {x, tangent, 0.5}, slope, tangent[1], *slope(circle)));
  EXPECT_NEAR(circle.x()[0], 0.0, 1e-14);
  EXPECT_NEAR(circle.x()[1], 1.0, 1e-14);
}

TEST(ArcLength, FailsWhereThereIsNoCurve) {
  Circle circle;
  const Eigen::VectorXd beyond = Eigen::Vector2d(0.0, 1.5);
  EXPECT_FALSE(correct_at_parameter(circle, beyond));
}

TEST(ArcLength, FirstTangentIsTheNullVector) {
  Circle circle;
  ASSERT_TRUE(circle.evaluate(Eigen::Vector2d(0.6, 0.8)));
  const Eigen::VectorXd tangent = first_tangent(circle);
  EXPECT_NEAR(std::abs(tangent.dot(Eigen::Vector2d(0.8, -0.6))), 1.0, 1e-14);
}

/// x^2 + y^2 = p, said twice: any point of a circle is as good as another, so x and y move along its radius.
class Paraboloid {
 public:
  [[nodiscard]] Eigen::Index size() const { return 2; }
  bool evaluate(const Eigen::VectorXd& x) {
    x_ = x;
    return x.allFinite();
  }
  [[nodiscard]] Eigen::VectorXd residual() const {
    return (x_.head(2).squaredNorm() - x_[2]) * Eigen::Vector2d(1.0, -3.0);
  }
  [[nodiscard]] Eigen::MatrixXd jacobian() const {
    return Eigen::Vector2d(1.0, -3.0) * Eigen::RowVector3d(2.0 * x_[0], 2.0 * x_[1], -1.0);
  }
  [[nodiscard]] Eigen::MatrixXd conditions() const { return Eigen::RowVector3d(-x_[1], x_[0], 0.0); }
  [[nodiscard]] double noise() const { return 1e-16; }
  [[nodiscard]] const Eigen::VectorXd& x() const { return x_; }

 private:
  Eigen::VectorXd x_;
};

TEST(ArcLength, HoldsConditionsWhereEquationsAreDependent) {
  Paraboloid paraboloid;
  const Eigen::Vector3d begin(0.6, 0.8, 1.0), along = Eigen::Vector3d(0.6, 0.8, 2.0).normalized();
  ASSERT_TRUE(paraboloid.evaluate(begin));
  EXPECT_NEAR(std::abs(first_tangent(paraboloid).dot(along)), 1.0, 1e-14);
  const auto tangent = tangent_of(paraboloid, Eigen::Vector3d(0.0, 0.0, 1.0));
  ASSERT_TRUE(tangent);
  EXPECT_NEAR(tangent->dot(along), 1.0, 1e-14);
  ASSERT_TRUE(correct_at_parameter(paraboloid, Eigen::Vector3d(0.6, 0.8, 4.0)));
  EXPECT_NEAR((paraboloid.x() - Eigen::Vector3d(1.2, 1.6, 4.0)).norm(), 0.0, 1e-12);
}

/// x_k + .1 sin(x_{k+1}) = p for k = 0, ..., n - 1, x_n = p: from the last unknown backwards in closed form.
class LongChain {
 public:
  explicit LongChain(Eigen::Index count) : count_(count) {}
  [[nodiscard]] Eigen::Index size() const { return count_; }
  bool evaluate(const Eigen::VectorXd& x) {
    ++jacobians;
    J_ = Eigen::MatrixXd::Identity(count_, count_ + 1);
    for (Eigen::Index k = 0; k < count_; ++k) J_(k, k + 1) = 0.1 * std::cos(x[k + 1]);
    J_.col(count_).array() -= 1.0;
    x_ = x;
    return x.allFinite();
  }
  bool evaluate_motion(const Eigen::VectorXd& x) {
    ++motions;
    x_ = x;
    return moves;
  }
  [[nodiscard]] Eigen::VectorXd residual() const {
    return (x_.head(count_).array() + 0.1 * x_.tail(count_).array().sin() - x_[count_]).matrix();
  }
  [[nodiscard]] Eigen::MatrixXd jacobian() const { return J_; }
  [[nodiscard]] double noise() const { return 1e-16; }
  [[nodiscard]] Eigen::VectorXd solution(double p) const {
    Eigen::VectorXd x = Eigen::VectorXd::Constant(count_ + 1, p);
    for (Eigen::Index k = count_ - 1; k >= 0; --k) x[k] = p - 0.1 * std::sin(x[k + 1]);
    return x;
  }
  [[nodiscard]] const Eigen::VectorXd& x() const { return x_; }

  int jacobians = 0, motions = 0;
  bool moves = true;

 private:
  Eigen::Index count_;
  Eigen::VectorXd x_;
  Eigen::MatrixXd J_;
};

TEST(ArcLength, ManyEquationsAreSolvedBySecantsFromTheFactorsBefore) {
  LongChain chain(80);
  const Eigen::VectorXd begin = chain.solution(0.4);
  ASSERT_TRUE(chain.evaluate(begin));
  const Eigen::VectorXd along = Eigen::VectorXd::Unit(begin.size(), begin.size() - 1);
  Eigen::VectorXd predicted = begin;
  predicted[chain.size()] = 0.9;
  const CurveFactors factors(chain, along);
  const auto steps = correct(chain, predicted, along, {.near = &factors});
  EXPECT_EQ(steps, (chain.motions + 1) / 3) << "three secant steps, one less than the motions, count as one";
  EXPECT_LT((chain.x() - chain.solution(0.9)).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_EQ(chain.jacobians, 2) << "where it begins, and where it ends";
  const int before = chain.jacobians;
  ASSERT_TRUE(correct(chain, predicted, along, {}));
  EXPECT_LT((chain.x() - chain.solution(0.9)).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_GT(chain.jacobians, before + 2) << "of Newton's method";
}

TEST(ArcLength, FactorsTellTangentAndDeterminant) {
  LongChain chain(70);
  const Eigen::VectorXd x = chain.solution(0.4);
  ASSERT_TRUE(chain.evaluate(x));
  Eigen::VectorXd row = Eigen::VectorXd::Constant(x.size(), 0.1);
  row[3] = -0.7;
  const CurveFactors factors(chain, row);
  const auto tangent = factors.tangent(), other = tangent_of(chain, row);
  ASSERT_TRUE(tangent && other);
  EXPECT_LT((*tangent - *other).norm(), 1e-14);
  const Eigen::MatrixXd B = bordered_jacobian(chain, *tangent);
  const double determinant = LuFactors(B).determinant() / B.rowwise().norm().prod();
  EXPECT_NEAR(factors.relative_determinant(), determinant, 1e-12 * std::abs(determinant));
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(chain.size(), -1.0, 1.0);
  const Eigen::VectorXd step = factors.solve(right, *tangent);
  EXPECT_NEAR(tangent->dot(step), 0.0, 1e-13);
  EXPECT_LT((chain.jacobian() * step - right).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(ArcLength, NewtonGoesOnWhereSecantsFail) {
  LongChain chain(80);
  const Eigen::VectorXd begin = chain.solution(0.4);
  ASSERT_TRUE(chain.evaluate(begin));
  const Eigen::VectorXd along = Eigen::VectorXd::Unit(begin.size(), begin.size() - 1);
  Eigen::VectorXd predicted = begin;
  predicted[chain.size()] = 0.9;
  const CurveFactors factors(chain, along);
  chain.moves = false;
  ASSERT_TRUE(correct(chain, predicted, along, {.near = &factors}));
  EXPECT_LT((chain.x() - chain.solution(0.9)).lpNorm<Eigen::Infinity>(), 1e-12);
}

TEST(ArcLength, LocatesOnManyEquationsBySecantsFromTheFirstPoint) {
  constexpr double kLength = 6.0;  // p rises by .7
  LongChain chain(80);
  const Eigen::VectorXd begin = chain.solution(0.4), there = chain.solution(0.9);
  ASSERT_TRUE(chain.evaluate(begin));
  const Eigen::VectorXd tangent = first_tangent(chain, true);
  ASSERT_TRUE(correct(chain, Eigen::VectorXd(begin + kLength * tangent), tangent));
  int evaluations = 0;
  const auto beyond = [&](LongChain& at) {
    ++evaluations;
    return std::optional(at.x()[0] - there[0]);
  };
  const double last = chain.x()[0] - there[0];
  chain.jacobians = 0;
  ASSERT_TRUE(locate(chain, {begin, tangent, kLength, true}, beyond, begin[0] - there[0], last));
  EXPECT_LT((chain.x() - there).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_GT(evaluations, 3);
  EXPECT_LE(chain.jacobians, evaluations + 5) << "more than one a point, where Newton's steps led to it";
}

TEST(ArcLength, StepsGrowWithEaseAndNeverBeyondTheLargest) {
  EXPECT_GT(next_step(0.01, 2, 0.0, 1.0), 0.01);
  EXPECT_LT(next_step(0.01, 6, 0.0, 1.0), 0.01);
  EXPECT_LT(next_step(0.01, 2, 0.2, 1.0), 0.01);
  EXPECT_EQ(next_step(0.09, 2, 0.0, 0.1), 0.1);
}

TEST(FirstTarget, IsWhatTheStepMeetsFirstOfValuesAndTheEndsOfTheInterval) {
  const std::vector<double> values{1.2, 1.6, 1.9};
  const auto within = first_target(values, 1.0, 2.0, 1.5, 1.95);
  ASSERT_TRUE(within);
  EXPECT_EQ(within->value, 1.6);
  EXPECT_FALSE(within->leaves);
  const auto before_the_end = first_target(values, 1.0, 2.0, 1.7, 2.1);
  ASSERT_TRUE(before_the_end);
  EXPECT_EQ(before_the_end->value, 1.9) << "though the step leaves the interval";
  const auto end = first_target(values, 1.0, 2.0, 1.1, 0.9);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->value, 1.0);
  EXPECT_TRUE(end->leaves);
  EXPECT_FALSE(first_target(values, 1.0, 2.0, 1.6, 1.7)) << "where it begins";
}

TEST(ArcLength, StepsGrowWithTheMotionBeyondAFewUnits) {
  EXPECT_EQ(longest_step(0.1, 0.5), 0.1);
  EXPECT_EQ(longest_step(0.1, 5.0), 0.1);
  EXPECT_GT(longest_step(0.1, 1e3), 5.0);
}

TEST(FirstTarget, IsToldFromTheBeginningInUnitsOfTheInterval) {
  const auto near = first_target({1.5e-12}, 0.0, 2e-12, 1e-12, 1.9e-12);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->value, 1.5e-12);
}

// On p = 1.5 - (s - 1/2)^2 / 4, which turns at 1.5 and begins and ends at 1.4375.
TEST(TurnsPast, IsWhereAFoldLiesBeyondAValueThatBothEndsHaveNotReached) {
  const ParameterAt begin{1.4375, 0.25}, end{1.4375, -0.25};
  EXPECT_TRUE(turns_past({1.45}, 1.0, 2.0, begin, end));
  EXPECT_TRUE(turns_past({1.49}, 1.0, 2.0, begin, end));
  EXPECT_FALSE(turns_past({1.51}, 1.0, 2.0, begin, end)) << "the fold does not reach it";
  EXPECT_FALSE(turns_past({1.40}, 1.0, 2.0, begin, end)) << "both ends are beyond it";
  EXPECT_FALSE(turns_past({1.45}, 1.0, 1.44, begin, end)) << "outside the interval";
  EXPECT_FALSE(turns_past({1.45}, 1.0, 2.0, begin, {1.6, 0.25})) << "no fold: the ends tell";
  EXPECT_TRUE(turns_past({1.4375}, 1.0, 2.0, begin, {1.43, -0.3})) << "back over where it begins";
}

}  // namespace
}  // namespace signorini::arc_length_test
