#include "methods/solvers/damped_newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace signorini::damped_newton_test {
namespace {

/// f(x) = 0 in one unknown, with a record of the lengths tried.
struct ScalarEquation {
  std::function<double(double)> f;
  std::function<double(double)> slope;
  double x = 0.0;
  double tolerance = 1e-12;
  double longest = 1.0;
  bool nan_is_undefined = true;
  double step = 0.0;
  double trial = 0.0;
  int accepted = 0;
  std::vector<double> lengths = {};

  [[nodiscard]] bool solved() const { return std::abs(f(x)) <= tolerance; }
  [[nodiscard]] double merit() const { return std::abs(f(x)); }
  std::optional<double> find_step() {
    const double rate = slope(x);
    if (rate == 0.0) return std::nullopt;
    step = -f(x) / rate;
    return longest;
  }
  std::optional<double> merit_at(double length) {
    lengths.push_back(length);
    trial = x + length * step;
    const double value = f(trial);
    if (std::isnan(value) && nan_is_undefined) return std::nullopt;
    return std::abs(value);
  }
  void accept() {
    x = trial;
    ++accepted;
  }
};

ScalarEquation square_root_of_two(double x) {
  return {.f = [](double v) { return v * v - 2.0; }, .slope = [](double v) { return 2.0 * v; }, .x = x};
}

ScalarEquation arc_tangent(double x) {
  return {.f = [](double v) { return std::atan(v); },
          .slope = [](double v) { return 1.0 / (1.0 + v * v); },
          .x = x};
}

/// A slope of the wrong sign: every step leads uphill.
ScalarEquation uphill() {
  return {.f = [](double v) { return v; }, .slope = [](double) { return -1.0; }, .x = 1.0};
}

TEST(DampedNewton, ConvergesQuadraticallyNearARoot) {
  ScalarEquation equation = square_root_of_two(1.5);
  const DampedNewtonResult result = damped_newton(equation, {});
  EXPECT_EQ(result.end, NewtonEnd::solved);
  EXPECT_NEAR(equation.x, std::sqrt(2.0), 1e-12);
  // Errors 9e-2, 2.5e-3, 2e-6, 2e-12: the third step meets the residual of 1e-11, not of 1e-12.
  EXPECT_LE(result.steps, 4);
  EXPECT_EQ(equation.lengths, std::vector<double>(static_cast<std::size_t>(result.steps), 1.0));
}

TEST(DampedNewton, HalvesStepsThatOvershoot) {
  // The full step diverges from |x| > 1.392, where 2 x = (1 + x^2) arctan x.
  ScalarEquation equation = arc_tangent(10.0);
  const DampedNewtonResult result = damped_newton(equation, {});
  EXPECT_EQ(result.end, NewtonEnd::solved);
  EXPECT_NEAR(equation.x, 0.0, 1e-12);
  EXPECT_GT(equation.lengths.size(), static_cast<std::size_t>(result.steps));
  EXPECT_EQ(equation.accepted, result.steps);
  EXPECT_LE(result.steps, 12);
}

TEST(DampedNewton, TakesNoStepFromASolution) {
  ScalarEquation equation = arc_tangent(0.0);
  const DampedNewtonResult result = damped_newton(equation, {.max_steps = 0});
  EXPECT_EQ(result.end, NewtonEnd::solved);
  EXPECT_EQ(result.steps, 0);
}

TEST(DampedNewton, ShortensTheStepWhereTheTrialIsUndefined) {
  // From x = 3 the full step leads to 3 - 3 ln 3 < 0, where the logarithm does not exist.
  ScalarEquation equation{
      .f = [](double v) { return std::log(v); }, .slope = [](double v) { return 1.0 / v; }, .x = 3.0};
  const DampedNewtonResult result = damped_newton(equation, {});
  EXPECT_EQ(result.end, NewtonEnd::solved);
  EXPECT_NEAR(equation.x, 1.0, 1e-12);
  ASSERT_GE(equation.lengths.size(), 2U);
  EXPECT_EQ(equation.lengths[1], 0.5);
}

TEST(DampedNewton, BeginsWithTheLongestStepAllowed) {
  ScalarEquation equation = uphill();
  equation.longest = 0.8;
  const DampedNewtonResult result = damped_newton(equation, {.max_halvings = 2});
  EXPECT_EQ(result.end, NewtonEnd::stalled);
  EXPECT_EQ(equation.lengths, (std::vector{0.8, 0.4, 0.2}));
}

TEST(DampedNewton, LeavesTheIterateWhereItStalls) {
  ScalarEquation equation = uphill();
  const DampedNewtonResult result = damped_newton(equation, {.max_halvings = 0});
  EXPECT_EQ(result.end, NewtonEnd::stalled);
  EXPECT_EQ(result.steps, 1);
  EXPECT_EQ(equation.accepted, 0);
  EXPECT_EQ(equation.x, 1.0);
  EXPECT_EQ(equation.lengths, std::vector{1.0});
}

TEST(DampedNewton, AsksForTheDecreaseSet) {
  // The slope is five times too steep: a full step reduces the merit by a fifth.
  const auto creeping = [] {
    return ScalarEquation{
        .f = [](double v) { return v; }, .slope = [](double) { return 5.0; }, .x = 1.0, .tolerance = 0.5};
  };
  ScalarEquation content = creeping();
  EXPECT_EQ(damped_newton(content, {.sufficient_decrease = 0.1}).end, NewtonEnd::solved);
  ScalarEquation demanding = creeping();
  EXPECT_EQ(damped_newton(demanding, {.sufficient_decrease = 0.25}).end, NewtonEnd::stalled);
}

TEST(DampedNewton, EndsWhereThereIsNoStep) {
  // x^2 + 1 has no root; the first step from 1 leads to 0, where the slope vanishes.
  ScalarEquation equation{
      .f = [](double v) { return v * v + 1.0; }, .slope = [](double v) { return 2.0 * v; }, .x = 1.0};
  const DampedNewtonResult result = damped_newton(equation, {});
  EXPECT_EQ(result.end, NewtonEnd::singular);
  EXPECT_EQ(result.steps, 1);
  EXPECT_EQ(equation.x, 0.0);
}

TEST(DampedNewton, EndsAtItsLimits) {
  ScalarEquation few = arc_tangent(10.0);
  const DampedNewtonResult limited = damped_newton(few, {.max_steps = 2});
  EXPECT_EQ(limited.end, NewtonEnd::limit);
  EXPECT_EQ(limited.steps, 2);
  ScalarEquation late = arc_tangent(10.0);
  const DampedNewtonResult interrupted =
      damped_newton(late, {.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)});
  EXPECT_EQ(interrupted.end, NewtonEnd::interrupted);
  EXPECT_EQ(interrupted.steps, 0);
  EXPECT_TRUE(late.lengths.empty());
}

TEST(DampedNewton, NeverAcceptsAMeritThatIsNotANumber) {
  for (const double beyond :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ScalarEquation equation{.f = [beyond](double v) { return v < 1.0 ? beyond : v; },
                            .slope = [](double) { return 1.0; },
                            .x = 1.0,
                            .nan_is_undefined = false};
    EXPECT_EQ(damped_newton(equation, {.max_halvings = 5}).end, NewtonEnd::stalled);
    EXPECT_EQ(equation.accepted, 0);
  }
}

}  // namespace
}  // namespace signorini::damped_newton_test
