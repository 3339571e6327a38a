// What every answer must look like, and how solves end.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "tests/conformance/method_case.hpp"

namespace signorini {
namespace {

using test::MethodCase;

class Answer : public testing::TestWithParam<MethodCase> {
 protected:
  MethodCase pair_ = GetParam();
  test::MethodTraits traits_ = test::traits_of(pair_.method);
  Problem problem_ = test::scene_of(pair_);
  std::unique_ptr<Method> method_ = test::method_of(pair_);
};

void expect_sound(const Problem& problem, const Trajectory& trajectory, int count) {
  const Samples samples = trajectory.sample(count);
  for (const Eigen::MatrixXd* values : {&samples.x, &samples.velocity, &samples.force}) {
    ASSERT_EQ(values->rows(), count);
    ASSERT_EQ(values->cols(), problem.contact_count());
    EXPECT_TRUE(values->allFinite()) << count << " samples";
  }
  EXPECT_TRUE((samples.force.array() <= 0.0).all()) << count << " samples";
}

void expect_sound_impulses(const Problem& problem, const Trajectory& trajectory) {
  double before = 0.0;
  for (const Impulse& impulse : trajectory.impulses()) {
    EXPECT_GE(impulse.contact, 0);
    EXPECT_LT(impulse.contact, problem.contact_count());
    EXPECT_LE(impulse.value, 0.0);
    EXPECT_TRUE(std::isfinite(impulse.value));
    EXPECT_GE(impulse.time, before) << "impulses out of order";
    EXPECT_LT(impulse.time, trajectory.period());
    before = impulse.time;
  }
}

// Values at the instants that two sampling rates share.
void expect_same_at_common_instants(const Trajectory& trajectory, int few, int many, double scale,
                                    double tolerance) {
  const Samples coarse = trajectory.sample(few), fine = trajectory.sample(many);
  const int common = std::gcd(few, many);
  const double velocity_scale = scale * 2.0 * std::numbers::pi / trajectory.period() * many;
  const double force_scale = std::max(fine.force.cwiseAbs().maxCoeff(), coarse.force.cwiseAbs().maxCoeff());
  for (int i = 0; i < common; ++i) {
    const int a = i * (few / common), b = i * (many / common);
    SCOPED_TRACE(testing::Message() << "instant " << i << "/" << common << " of the period, " << few
                                    << " and " << many);
    EXPECT_LE((coarse.x.row(a) - fine.x.row(b)).cwiseAbs().maxCoeff(), tolerance * scale);
    EXPECT_LE((coarse.velocity.row(a) - fine.velocity.row(b)).cwiseAbs().maxCoeff(),
              tolerance * velocity_scale);
    EXPECT_LE((coarse.force.row(a) - fine.force.row(b)).cwiseAbs().maxCoeff(), tolerance * force_scale);
  }
}

TEST_P(Answer, IsASoundTrajectoryHoweverItIsSampled) {
  const Support support = method_->supports(problem_);
  if (!support.ok) GTEST_SKIP() << support.reason;
  const Solution& solution = test::base_answer(pair_);
  EXPECT_FALSE(solution.message.empty());
  ASSERT_TRUE(solution.verdict != Verdict::converged || solution.trajectory);
  if (!solution.trajectory) GTEST_SKIP() << "no iterate: " << solution.message;
  const Trajectory& trajectory = *solution.trajectory;
  ASSERT_EQ(trajectory.contact_count(), problem_.contact_count());
  const double periods = trajectory.period() * problem_.frequency / (2.0 * std::numbers::pi);
  EXPECT_GE(std::round(periods), 1.0);
  EXPECT_NEAR(periods, std::round(periods), 1e-9 * periods);
  constexpr int kCounts[] = {1, 2, 7, 64, 1000};
  for (const int count : kCounts) expect_sound(problem_, trajectory, count);
  expect_sound_impulses(problem_, trajectory);
  if (problem_.contact_count() == 0) return;
  const double scale = test::displacement_scale(problem_, trajectory.sample(1000));
  for (const int few : kCounts) {
    for (const int many : kCounts) {
      if (few < many) expect_same_at_common_instants(trajectory, few, many, scale, traits_.identity);
    }
  }
}

TEST_P(Answer, IsRefusedOnlyWithAReason) {
  const Support support = method_->supports(problem_);
  EXPECT_EQ(support.ok, support.reason.empty()) << support.reason;
  if (!support.ok) return;
  EXPECT_NO_THROW((void)method_->law(problem_));
  EXPECT_NO_THROW((void)method_->prepare(problem_));
}

// A budget that is spent before the start: the answer may be there, a hang or an exception may not.
TEST_P(Answer, ComesEvenWhenTheTimeIsUp) {
  if (!method_->supports(problem_).ok) GTEST_SKIP() << method_->supports(problem_).reason;
  Start start;
  start.deadline = std::chrono::steady_clock::now() - std::chrono::hours(1);
  const Solution solution = method_->prepare(problem_)->solve(start);
  EXPECT_FALSE(solution.message.empty());
  ASSERT_TRUE(solution.verdict != Verdict::converged || solution.trajectory);
  if (solution.trajectory) expect_sound(problem_, *solution.trajectory, 16);
}

INSTANTIATE_TEST_SUITE_P(Conformance, Answer, testing::ValuesIn(test::all_cases()), test::CaseName());

// How many scenes of the catalogue each method converges on at the suite's cheap resolution.
TEST(Catalogue, EveryMethodConvergesOnAlmostEveryScene) {
  std::map<std::string, std::vector<std::string>> failures;
  for (const MethodCase& pair : test::all_cases()) {
    if (!test::method_of(pair)->supports(test::scene_of(pair)).ok) continue;
    auto& failed = failures[pair.method];
    if (test::base_answer(pair).verdict != Verdict::converged) failed.push_back(pair.scene);
  }
  for (const auto& [method, failed] : failures) {
    // Measured: two each (rays at damping ratios below 0.002 with these few samples), aft-hbm three.
    EXPECT_LE(failed.size(), 3U) << method << " fails on " << testing::PrintToString(failed);
  }
}

}  // namespace
}  // namespace signorini
