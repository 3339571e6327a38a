#include "methods/refinement.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

#include "methods/structure/receptance.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::refinement_test {
namespace {

/// What a resolution is to answer: a cosine of this amplitude, or not to converge (0), or not to be prepared
/// (< 0).
using Answers = std::map<int, double>;

class Answering final : public PreparedMethod {
 public:
  Answering(double amplitude, int resolution) : amplitude_(amplitude), resolution_(resolution) {}
  Solution solve(const Start&) override {
    Solution solution{.message = "solved", .work = {.pivots = resolution_}};
    if (amplitude_ == 0.0) return solution;
    solution.verdict = Verdict::converged;
    solution.trajectory = std::make_shared<test::GivenMotion>(
        1.0, [a = amplitude_](double t) { return a * std::cos(2.0 * std::numbers::pi * t); });
    return solution;
  }

 private:
  double amplitude_;
  int resolution_;
};

/// Resolutions 10, 20 and 40; those asked for are noted.
Resolutions three(const Answers& answers, std::vector<int>& asked) {
  return {rising_resolutions(10, 2, 40),
          [answers, &asked](int resolution) -> std::unique_ptr<PreparedMethod> {
            asked.push_back(resolution);
            if (answers.at(resolution) < 0.0) throw SingularStiffness();
            return std::make_unique<Answering>(answers.at(resolution), resolution);
          }};
}

bool never(const Solution& solution) { return solution.verdict != Verdict::converged; }

double amplitude(const Solution& solution) { return solution.trajectory->sample(1).x(0, 0); }

TEST(Resolutions, RiseUpToTheFinest) {
  EXPECT_EQ(rising_resolutions(20, 2, 160), (std::vector<int>{20, 40, 80, 160}));
  EXPECT_EQ(rising_resolutions(256, 4, 4096), (std::vector<int>{256, 1024, 4096}));
  EXPECT_EQ(rising_resolutions(300, 4, 1000), (std::vector<int>{300}));
}

TEST(RefinedUntilAgreed, TakesTheFinerOfTwoThatAgree) {
  std::vector<int> asked;
  const Solution solution =
      refined_until_agreed(three({{10, 1.0}, {20, 1.04}, {40, 1.05}}, asked), {})->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(amplitude(solution), 1.04);
  EXPECT_EQ(asked, (std::vector<int>{10, 20}));
  EXPECT_EQ(solution.work.pivots, 10 + 20);
}

TEST(RefinedUntilAgreed, AsksAThirdWhereTwoDisagree) {
  std::vector<int> asked;
  const Solution solution =
      refined_until_agreed(three({{10, 3.0}, {20, 1.0}, {40, 1.01}}, asked), {})->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(amplitude(solution), 1.01);
}

TEST(RefinedUntilAgreed, PassesOverResolutionsWithoutAnAnswer) {
  std::vector<int> asked;
  const Solution solution =
      refined_until_agreed(three({{10, 1.0}, {20, -1.0}, {40, 1.0}}, asked), {})->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(solution.message, "solved; N = 40");
  const Solution alone = refined_until_agreed(three({{10, 0.0}, {20, 0.0}, {40, 1.0}}, asked), {})->solve({});
  EXPECT_EQ(alone.verdict, Verdict::converged);
  const Solution none = refined_until_agreed(three({{10, 0.0}, {20, 0.0}, {40, 0.0}}, asked), {})->solve({});
  EXPECT_EQ(none.verdict, Verdict::not_converged);
}

TEST(RefinedUntilAgreed, TakesAnAnswerThatIsNotWorthTheNextResolution) {
  std::vector<int> asked;
  const Solution solution =
      refined_until_agreed(three({{10, 0.0}, {20, 1.0}, {40, 3.0}}, asked), {.worth_refining = never})
          ->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(amplitude(solution), 1.0);
  EXPECT_EQ(asked, (std::vector<int>{10, 20}));
}

TEST(RefinedUntilAgreed, DoesNotClaimWhatItHadNoTimeToCheck) {
  std::vector<int> asked;
  const Start late{.deadline = std::chrono::steady_clock::now()};
  const Solution solution =
      refined_until_agreed(three({{10, 1.0}, {20, 1.0}, {40, 1.0}}, asked), {})->solve(late);
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solution.message, "solved; N = 10; the time was up before a finer one could be asked");
}

TEST(RefinedUntilAgreed, TakesMotionsAtRestForTheSame) {
  std::vector<int> asked;
  const Answers rounding{{10, 1e-16}, {20, 3e-16}, {40, 1e-15}};
  const Solution solution = refined_until_agreed(three(rounding, asked), {.least = 1e-6})->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(asked, (std::vector<int>{10, 20}));
}

TEST(RefinedUntilAgreed, PreparesFinerResolutionsInEverySolve) {
  std::vector<int> asked;
  const auto refined = refined_until_agreed(three({{10, 1.0}, {20, 1.0}, {40, 1.0}}, asked), {});
  refined->solve({});
  refined->solve({});
  EXPECT_EQ(asked, (std::vector<int>{10, 20, 20}));
}

/// offset + amplitude cos(2 pi t).
test::GivenMotion wave(double offset, double amplitude) {
  return {1.0, [=](double t) { return offset + amplitude * std::cos(2.0 * std::numbers::pi * t); }};
}

TEST(RelativeDistance, IsThatOfTheLargerMotionWhereverTheOriginIs) {
  const test::GivenMotion rest = wave(0.0, 0.0);
  for (const double offset : {0.0, 10.0})
    EXPECT_NEAR(signorini::relative_distance(wave(offset, 1.0), wave(offset, -3.0), 16), 4.0 / 3.0, 1e-12);
  EXPECT_EQ(signorini::relative_distance(rest, rest, 16), 0.0);
  EXPECT_NEAR(signorini::relative_distance(rest, wave(0.0, 1.0), 16), 1.0, 1e-12);
  constexpr double kDeflection = 2.0;
  EXPECT_NEAR(signorini::relative_distance(rest, wave(1.0, 0.0), 16, 1e-6 * kDeflection), 1.0 / kDeflection,
              1e-12)
      << "both at rest, at two places";
}

TEST(RefinedUntilAgreed, ClaimsTheFinestOnlyIfItIsNearTheOneBefore) {
  std::vector<int> asked;
  const Solution near = refined_until_agreed(three({{10, 5.0}, {20, 1.0}, {40, 1.3}}, asked), {})->solve({});
  EXPECT_EQ(near.verdict, Verdict::converged);
  const Solution far = refined_until_agreed(three({{10, 5.0}, {20, 1.0}, {40, 3.0}}, asked), {})->solve({});
  EXPECT_EQ(far.verdict, Verdict::not_converged);
  EXPECT_EQ(far.message, "solved; N = 40; the motion at the resolution before is 0.67 away");
}

TEST(RefinedUntilAgreed, ClaimsOnlyWhatIsConfirmedWhereThatIsAskedFor) {
  const RefinementRule strict{.resolution = "H", .only_confirmed = true};
  const auto end_of = [&](const Answers& answers) {
    std::vector<int> asked;
    return refined_until_agreed(three(answers, asked), strict)->solve({});
  };
  EXPECT_EQ(end_of({{10, 2.0}, {20, 1.0}, {40, 1.04}}).verdict, Verdict::converged);
  const Solution apart = end_of({{10, 5.0}, {20, 1.0}, {40, 1.3}});
  EXPECT_EQ(apart.verdict, Verdict::not_converged);
  EXPECT_EQ(apart.message,
            "solved; H = 40; the motion at the resolution before is 0.23 away, the limit is 0.05");
  EXPECT_EQ(amplitude(apart), 1.3);
  const Solution alone = end_of({{10, 0.0}, {20, 1.0}, {40, 0.0}});
  EXPECT_EQ(alone.verdict, Verdict::not_converged);
  EXPECT_EQ(alone.message, "solved; H = 20; no other resolution confirms it");
  EXPECT_EQ(end_of({{10, 0.0}, {20, 0.0}, {40, 0.0}}).message, "solved; H = 40");
}

TEST(RefinedUntilAgreed, AsksNoFurtherWhereAFinerResolutionWouldFailToo) {
  std::vector<int> asked;
  const RefinementRule hopeless{.worth_refining = [](const Solution&) { return false; }};
  const Solution none =
      refined_until_agreed(three({{10, 0.0}, {20, 1.0}, {40, 1.0}}, asked), hopeless)->solve({});
  EXPECT_EQ(none.verdict, Verdict::not_converged);
  EXPECT_EQ(asked, (std::vector<int>{10}));
}

}  // namespace
}  // namespace signorini::refinement_test
