#include "methods/solvers/bracketed_zero.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace signorini::bracketed_zero_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A function with one change of sign in [low, high], at `zero`.
struct Case {
  std::string name;
  std::function<double(double)> f;
  std::function<double(double)> slope;
  double low, high, zero;
  int evaluations;         ///< of bracketed_zero
  int newton_evaluations;  ///< of newton_zero_between

  friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

double power(double t, int n) { return std::pow(t - 1.0 / 3.0, n); }

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"CosineOfAQuarterTurn", [](double t) { return std::cos(t); }, [](double t) { return -std::sin(t); },
       1.0, 2.0, std::numbers::pi / 2.0, 7, 4},
      {"CubeRootOfTwo", [](double t) { return t * t * t - 2.0; }, [](double t) { return 3.0 * t * t; }, 0.0,
       2.0, std::cbrt(2.0), 8, 6},
      {"SteepExponential", [](double t) { return std::exp(-20.0 * (t - 0.1)) - 1.0; },
       [](double t) { return -20.0 * std::exp(-20.0 * (t - 0.1)); }, 0.0, 1.0, 0.1, 12, 9},
      {"SmoothedJump", [](double t) { return std::atan(100.0 * (t - 0.9)); },
       [](double t) { return 100.0 / (1.0 + 1e4 * (t - 0.9) * (t - 0.9)); }, -1.0, 1.0, 0.9, 13, 10},
      {"TripleZero", [](double t) { return power(t, 3); }, [](double t) { return 3.0 * power(t, 2); }, 0.0,
       1.0, 1.0 / 3.0, 65, 93},
      {"FlatZero", [](double t) { return power(t, 9); }, [](double t) { return 9.0 * power(t, 8); }, 0.0, 1.0,
       1.0 / 3.0, 93, 93},
      {"Jump", [](double t) { return t < 1.0 / 3.0 ? -1.0 : 2.0; }, [](double) { return 0.0; }, 0.0, 1.0,
       1.0 / 3.0, 55, 55},
      {"JumpAtTheEnd", [](double t) { return t < 1.0 ? 1.0 : -1.0; }, [](double) { return 0.0; }, 0.0, 1.0,
       1.0, 55, 55},
      {"Pole", [](double t) { return -1.0 / (t - 1.0 / 3.0); }, [](double t) { return 1.0 / power(t, 2); },
       0.0, 1.0, 1.0 / 3.0, 58, 58}};
  return all;
}

class ZeroBetween : public testing::TestWithParam<Case> {};

TEST_P(ZeroBetween, IsFoundToRoundingInSoManyEvaluations) {
  const Case& sought = GetParam();
  const double rounding = 2.0 * kEpsilon * std::abs(sought.zero);
  for (const auto& [a, b] : {std::pair{sought.low, sought.high}, std::pair{sought.high, sought.low}}) {
    int count = 0;
    const auto f = [&](double t) {
      ++count;
      EXPECT_TRUE(t > sought.low && t < sought.high) << t;
      return sought.f(t);
    };
    const auto found = bracketed_zero(f, {a, sought.f(a), b, sought.f(b)}, 0.0);
    ASSERT_TRUE(found);
    EXPECT_LE(count, sought.evaluations);
    EXPECT_NEAR(found->a, sought.zero, rounding);
    EXPECT_EQ(found->f_a, sought.f(found->a));
    EXPECT_EQ(found->f_b, sought.f(found->b));
    if (found->f_a == 0.0) continue;
    EXPECT_NE(found->f_a > 0.0, found->f_b > 0.0);
    EXPECT_NEAR(found->b, sought.zero, rounding);
  }
}

TEST_P(ZeroBetween, IsFoundByNewtonsMethodToRoundingInSoManyEvaluations) {
  const Case& sought = GetParam();
  int count = 0;
  const auto f = [&](double t) {
    ++count;
    EXPECT_TRUE(t > sought.low && t < sought.high) << t;
    return ValueAndSlope{sought.f(t), sought.slope(t)};
  };
  const bool rises = sought.f(sought.high) > 0.0;
  const auto found = newton_zero_between(
      f, {.negative = rises ? sought.low : sought.high, .positive = rises ? sought.high : sought.low}, 0.0);
  ASSERT_TRUE(found);
  EXPECT_LE(count, sought.newton_evaluations);
  EXPECT_NEAR(*found, sought.zero, 2.0 * kEpsilon * std::abs(sought.zero));
}

INSTANTIATE_TEST_SUITE_P(Closed, ZeroBetween, testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.name; });

TEST(BracketedZero, NeedsNoEvaluationWhereAnEndIsZero) {
  const auto never = [](double) -> double { throw std::logic_error("evaluated"); };
  EXPECT_EQ(bracketed_zero(never, {1.0, 2.0, 3.0, 0.0}, 0.0)->a, 3.0);
  EXPECT_EQ(bracketed_zero(never, {1.0, 0.0, 3.0, 2.0}, 0.0)->a, 1.0);
  EXPECT_EQ(bracketed_zero(never, {1.0, 0.0, 3.0, 0.0}, 0.0)->f_a, 0.0);
  EXPECT_EQ(bracketed_zero(never, {1.0, -1.0, 1.1, 2.0}, 0.2)->a, 1.0);  // as narrow as asked for
}

TEST(BracketedZero, TellsWhereSignsDoNotDifferOrAreNone) {
  const auto line = [](double t) { return t; };
  EXPECT_FALSE(bracketed_zero(line, {1.0, 1.0, 2.0, 2.0}, 0.0));
  EXPECT_FALSE(bracketed_zero(line, {-1.0, -1.0, -2.0, -2.0}, 0.0));
  EXPECT_FALSE(bracketed_zero(line, {-1.0, kNaN, 2.0, 2.0}, 0.0));
  EXPECT_FALSE(bracketed_zero(line, {-1.0, -1.0, 2.0, kNaN}, 0.0));
  EXPECT_FALSE(bracketed_zero(line, {1.0, 1e-300, 2.0, 1e-300}, 0.0));  // whose product is zero
  EXPECT_TRUE(bracketed_zero(line, {-1.0, -1e-300, 2.0, 1e-300}, 0.0));
}

TEST(BracketedZero, TellsWhereTheFunctionIsNotANumber) {
  int count = 0;
  const auto f = [&](double t) { return ++count > 3 ? kNaN : t * t * t - 2.0; };
  EXPECT_FALSE(bracketed_zero(f, {0.0, -2.0, 2.0, 6.0}, 0.0));
  EXPECT_EQ(count, 4);
}

TEST(BracketedZero, TakesInfiniteValues) {
  const auto f = [](double t) { return t < 1.0 / 3.0 ? -kInfinity : kInfinity; };
  const auto found = bracketed_zero(f, {0.0, -kInfinity, 1.0, kInfinity}, 1e-9);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->a, 1.0 / 3.0, 1e-9);
}

TEST(BracketedZero, IsAsNarrowAsAskedForInFewerEvaluations) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    int count = 0;
    const auto f = [&](double t) {
      ++count;
      return std::cos(t);
    };
    const auto found = bracketed_zero(f, {1.0, std::cos(1.0), 2.0, std::cos(2.0)}, tolerance);
    ASSERT_TRUE(found);
    EXPECT_LE(std::abs(found->b - found->a), tolerance);
    EXPECT_LE(count, 6);
  }
}

/// A function that makes interpolation useless: piecewise constant, with values over many decades.
class Stairs {
 public:
  explicit Stairs(std::mt19937& random) {
    std::uniform_real_distribution<double> place(0.0, 1.0), decade(-30.0, 30.0);
    zero_ = place(random);
    for (double& exponent : exponents_) exponent = decade(random);
  }
  double operator()(double t) const {
    const double size = std::pow(10.0, exponents_[std::hash<double>()(t) % exponents_.size()]);
    return t < zero_ ? -size : size;
  }
  [[nodiscard]] double zero() const { return zero_; }

 private:
  double zero_;
  std::vector<double> exponents_ = std::vector<double>(64);
};

TEST(BracketedZero, TakesAtMostFortyEvaluationsMoreThanBisection) {
  constexpr double kTolerance = 1e-12;
  const int bisections = static_cast<int>(std::ceil(std::log2(1.0 / kTolerance)));
  std::mt19937 random(20);
  for (int k = 0; k < 1000; ++k) {
    const Stairs stairs(random);
    int count = 0;
    const auto f = [&](double t) {
      ++count;
      return stairs(t);
    };
    const auto found = bracketed_zero(f, {0.0, stairs(0.0), 1.0, stairs(1.0)}, kTolerance);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->a, stairs.zero(), kTolerance);
    EXPECT_LE(count, bisections + 40);
    count = 0;
    const auto newton = newton_zero_between(
        [&](double t) {
          const double value = f(t);
          return ValueAndSlope{value, 1e3 * value};  // steps that creep to the left
        },
        {.negative = 0.0, .positive = 1.0}, kTolerance);
    ASSERT_TRUE(newton);
    EXPECT_NEAR(*newton, stairs.zero(), 2.0 * kTolerance);
    EXPECT_LE(count, bisections + 40);
  }
}

TEST(NewtonZeroBetween, FindsTheZeroOfALineAtOnce) {
  int count = 0;
  const auto line = [&](double t) {
    ++count;
    return ValueAndSlope{3.0 - 2.0 * t, -2.0};
  };
  EXPECT_EQ(newton_zero_between(line, {.negative = 5.0, .positive = 0.0}, 0.0), 1.5);
  EXPECT_EQ(count, 2);
}

TEST(NewtonZeroBetween, GoesOnBySlopesOfTheWrongSign) {
  const auto f = [](double t) { return ValueAndSlope{std::cos(t), std::sin(t)}; };
  const auto found = newton_zero_between(f, {.negative = 2.0, .positive = 1.0}, 1e-12);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, std::numbers::pi / 2.0, 2e-12);
}

TEST(NewtonZeroBetween, TellsWhereTheFunctionIsNotANumber) {
  EXPECT_FALSE(newton_zero_between(
      [](double) {
        return ValueAndSlope{kNaN, 1.0};
      },
      {.negative = 0.0, .positive = 1.0}, 0.0));
}

ValueAndSlope square_less_two(double t) { return {t * t - 2.0, 2.0 * t}; }
ValueAndSlope square(double t) { return {t * t, 2.0 * t}; }

TEST(NewtonZeroNear, FindsASimpleZeroInFiveEvaluations) {
  int count = 0;
  const auto f = [&](double t) {
    ++count;
    return square_less_two(t);
  };
  const auto found = newton_zero_near(f, {.guess = 1.5, .reach = 0.5, .settled = 4.0 * kEpsilon});
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, std::numbers::sqrt2, 2.0 * kEpsilon);
  EXPECT_LE(count, 5);
}

TEST(NewtonZeroNear, TellsWhereAStepLeadsOutOfReach) {
  EXPECT_FALSE(newton_zero_near(square_less_two, {.guess = 1.5, .reach = 0.05}));
  EXPECT_FALSE(newton_zero_near(square_less_two, {.guess = 0.0, .reach = 1e9}));  // of slope 0
}

TEST(NewtonZeroNear, TellsWhereValueOrSlopeAreNotNumbers) {
  EXPECT_FALSE(newton_zero_near([](double) { return ValueAndSlope{kNaN, 1.0}; }, {.reach = 1.0}));
  EXPECT_FALSE(newton_zero_near([](double) { return ValueAndSlope{1.0, kNaN}; }, {.reach = 1.0}));
}

TEST(NewtonZeroNear, HalvesTheWayToADoubleZeroTwentyTimes) {
  const double last = std::ldexp(1.0, -20);
  EXPECT_EQ(newton_zero_near(square, {.guess = 1.0, .reach = 2.0}), last);
  EXPECT_EQ(newton_zero_near(square, {.guess = 1.0, .reach = 2.0, .accepted = last}), last);
  EXPECT_FALSE(newton_zero_near(square, {.guess = 1.0, .reach = 2.0, .accepted = 0.9 * last}));
  EXPECT_EQ(newton_zero_near(square, {.guess = 1.0, .reach = 2.0, .settled = 0.25}), 0.25);
}

}  // namespace
}  // namespace signorini::bracketed_zero_test
