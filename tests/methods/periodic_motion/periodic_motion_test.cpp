#include "methods/periodic_motion/periodic_motion.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::periodic_motion_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

Solution find(const Problem& problem, const PeriodicMotionOptions& options, const Start& start = {}) {
  return find_periodic_motion(problem, ContactDynamics(problem), options, start);
}

// Outlives the dynamics that it was followed with.
TEST(FindPeriodicMotion, MarchesFromRestToTheClosedFormOrbit) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  for (const Integrator integrator : {Integrator::cvode, Integrator::modal}) {
    const Solution found = find(test::to_problem(kStop), {.tolerance = 1e-9, .integrator = integrator});
    ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
    EXPECT_LT(test::relative_error(*found.trajectory, [&](double t) { return orbit.x(t); }), 1e-7);
    EXPECT_LT(found.residual.value(), 1e-8);
    EXPECT_EQ(found.work.unknowns, 2);
  }
}

TEST(FindPeriodicMotion, ShootsFromAGuessInFewerPeriodsThanItMarches) {
  const Problem problem = test::to_problem(kStop);
  const Solution marched = find(problem, {.tolerance = 1e-6, .integrator = Integrator::modal});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  const Solution shot = find(
      problem, {.tolerance = 1e-11, .shooting = true, .integrator = Integrator::modal, .max_iterations = 20},
      {.guess = marched.trajectory});
  ASSERT_EQ(shot.verdict, Verdict::converged) << shot.message;
  EXPECT_LE(shot.work.iterations.value(), 5);
  const auto orbit = test::single_impact_orbits(kStop).front();
  EXPECT_LT(test::relative_error(*shot.trajectory, [&](double t) { return orbit.x(t); }), 1e-9);
}

/// Finite, and so large a force that the state behind it leaves the range of doubles.
class OverwhelmingPush final : public Trajectory {
 public:
  explicit OverwhelmingPush(double period) : period_(period) {}
  [[nodiscard]] int contact_count() const override { return 1; }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override {
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, 1);
    return {.x = zero, .velocity = zero, .force = Eigen::MatrixXd::Constant(count, 1, -1e308)};
  }

 private:
  double period_;
};

TEST(FindPeriodicMotion, SaysSoWhereTheMotionLeavesTheRangeOfDoubles) {
  const Problem problem = test::to_problem(kStop);
  const auto guess = std::make_shared<OverwhelmingPush>(problem.period());
  for (const bool shooting : {false, true}) {
    const Solution failed =
        find(problem, {.tolerance = 1e-9, .shooting = shooting, .max_iterations = 20}, {.guess = guess});
    EXPECT_EQ(failed.verdict, Verdict::not_converged);
    EXPECT_EQ(failed.message, "the motion is no longer finite");
    EXPECT_FALSE(failed.trajectory);
    EXPECT_TRUE(failed.work.rhs_evaluations.has_value());
  }
}

TEST(FindPeriodicMotion, EndsAtItsLimitsWithAMessage) {
  const Solution tired = find(test::to_problem(kStop), {.tolerance = 1e-9, .max_iterations = 2});
  EXPECT_EQ(tired.verdict, Verdict::not_converged);
  EXPECT_FALSE(tired.message.empty());
  const Solution late = find(test::to_problem(kStop), {.tolerance = 1e-9},
                             {.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)});
  EXPECT_EQ(late.verdict, Verdict::not_converged);
  EXPECT_FALSE(late.message.empty());
}

}  // namespace
}  // namespace signorini::periodic_motion_test
