#include "harness/responses/curve_comparison.hpp"

#include <gtest/gtest.h>

#include "tests/harness/responses/drawn_responses.hpp"

namespace signorini::curve_comparison_test {
namespace {

using test::level_branch;
using test::moving;

const ResponseMetric kMetric(1.0, 1.0);

CurveComparison compared(const ResponseCurve& exact, const ResponseCurve& curve) {
  return compare_curves(exact, curve, kMetric, 1.0);
}

const ResponseCurve kExact{.branches = {level_branch(1.0, 2.0, 11)}};

TEST(CompareCurves, FindsACurveInItselfWhateverItsPoints) {
  for (const int points : {2, 300}) {
    const CurveComparison same = compared(kExact, {.branches = {level_branch(1.0, 2.0, points)}});
    EXPECT_NEAR(same.close.covered, 1.0, 1e-12);
    EXPECT_NEAR(same.wide.covered, 1.0, 1e-12);
    EXPECT_NEAR(same.wide.false_share, 0.0, 1e-12);
    EXPECT_NEAR(same.exact_length, 1.0, 1e-12);
    EXPECT_NEAR(same.right_length, 1.0, 1e-12);
  }
}

TEST(CompareCurves, CoversWhatIsWithinTolerance) {
  const CurveComparison half = compared(kExact, {.branches = {level_branch(1.0, 1.5, 11)}});
  EXPECT_NEAR(half.close.covered, 0.5 + kCloseTolerance, kElementLength);
  EXPECT_NEAR(half.wide.covered, 0.5 + kWideTolerance, kElementLength);
  // 0.03 away in the mean square: between the two tolerances.
  const CurveComparison near = compared(kExact, {.branches = {level_branch(1.0, 2.0, 11, 1.0424)}});
  EXPECT_EQ(near.close.covered, 0.0);
  EXPECT_NEAR(near.close.false_share, 1.0, 1e-12);
  EXPECT_NEAR(near.wide.covered, 1.0, 1e-12);
  EXPECT_NEAR(near.wide.false_share, 0.0, 1e-12);
}

TEST(CompareCurves, CountsWhatIsNotThereByItsLength) {
  const CurveComparison more =
      compared(kExact, {.branches = {level_branch(1.0, 2.0, 11), level_branch(1.0, 1.25, 500, 2.0)}});
  EXPECT_NEAR(more.wide.covered, 1.0, 1e-12);
  EXPECT_NEAR(more.wide.false_share, 0.2, 1e-12);
  EXPECT_NEAR(more.length, 1.25, 1e-12);
  EXPECT_NEAR(more.right_length, 1.0, 1e-12);
}

TEST(CompareCurves, AddATrueMotionThatTheExactResponseLacksAndChargeALie) {
  ResponseBranch third = level_branch(1.0, 1.25, 11), lie = level_branch(1.0, 1.25, 11, 2.0);
  for (ResponsePoint& point : third.points) point = moving(point.frequency, 1.0, 3, 0.5);
  const CurveComparison beside =
      compare_curves(kExact, {.branches = {third, lie}}, kMetric, 1.0,
                     {.is_true = [](const ResponsePoint& point) { return point.order == 3; }});
  EXPECT_NEAR(beside.right_length, 0.25, 1e-12);
  EXPECT_NEAR(beside.wide.false_share, 0.5, 1e-12);
  EXPECT_NEAR(compared(kExact, {.branches = {third, lie}}).wide.false_share, 1.0, 1e-12);
}

TEST(CompareCurves, AskForMotionsOfSomeOrdersAndTakeAllForTrue) {
  ResponseBranch third = level_branch(1.0, 2.0, 11);
  for (ResponsePoint& point : third.points) point = moving(point.frequency, 1.0, 3, 0.5);
  for (std::size_t i = 0; i < third.points.size(); ++i) third.points[i].stable = true;
  const ResponseCurve exact{.branches = {level_branch(1.0, 2.0, 11), third},
                            .located = {{.kind = SpecialKind::fold, .frequency = 1.5, .order = 3}}};
  const CurveComparison both = compare_curves(exact, {.branches = {third}}, kMetric, 1.0, {.orders = 2});
  EXPECT_NEAR(both.exact_length, 1.0, 1e-12);
  EXPECT_NEAR(both.wide.false_share, 0.0, 1e-12);
  EXPECT_NEAR(both.close.covered, 0.0, 1e-12);
  EXPECT_NEAR(both.close.covered_stable.value(), 1.0, 1e-12);
  EXPECT_TRUE(both.points.empty());
}

TEST(BesideBranches, AreTheOrbitsOfStepsThatLieOnNoneEachOnce) {
  ResponseCurve steps;
  for (const double turn : {0.0, 1.0}) {  // up and down
    ResponseBranch pass{.by_arc_length = false};
    for (int i = 0; i <= 20; ++i) {
      const double frequency = 1.0 + 0.05 * (turn > 0.0 ? 20 - i : i);
      pass.points.push_back(moving(frequency, frequency > 1.4 && frequency < 1.6 ? 3.0 : 1.0));
    }
    steps.branches.push_back(std::move(pass));
  }
  const std::vector<ResponseBranch> beside = beside_branches(kExact, steps, kMetric, 1.0);
  ASSERT_EQ(beside.size(), 1U);
  ASSERT_EQ(beside[0].points.size(), 3U);
  EXPECT_FALSE(beside[0].by_arc_length);
  EXPECT_NEAR(beside[0].points.front().frequency, 1.45, 1e-12);
  EXPECT_TRUE(beside_branches(kExact, kExact, kMetric, 1.0).empty());
}

// A method that answers everything would cover all, and be false in nearly all of it.
TEST(CompareCurves, IsNotImpressedByACloudOfAnswers) {
  ResponseCurve cloud;
  for (int size = 0; size < 40; ++size) {
    ResponseBranch scattered{.by_arc_length = false};
    for (int i = 0; i <= 100; ++i) {  // too far apart in frequency's order to be joined
      scattered.points.push_back(moving(1.0 + 0.01 * ((i * 37) % 101), 0.1 * size));
    }
    cloud.branches.push_back(std::move(scattered));
  }
  const CurveComparison all = compared(kExact, cloud);
  EXPECT_NEAR(all.wide.covered, 1.0, 1e-12);
  EXPECT_GT(all.wide.false_share, 0.9);
}

TEST(CompareCurves, DoesNotTakeAMotionOfOnePeriodForOneOfTwo) {
  ResponseCurve doubled;
  for (int i = 0; i <= 10; ++i) {
    if (i == 0) doubled.branches.emplace_back();
    doubled.branches.front().points.push_back(moving(1.0 + 0.1 * i, 1.0, 2, 0.01));
  }
  EXPECT_EQ(compared(kExact, doubled).wide.covered, 0.0);
  EXPECT_NEAR(compared(doubled, kExact).wide.false_share, 1.0, 1e-12);
}

TEST(CompareCurves, TellsTheStablePart) {
  ResponseCurve exact = kExact;
  for (ResponsePoint& point : exact.branches[0].points) point.stable = point.frequency < 1.45;
  const CurveComparison half = compared(exact, {.branches = {level_branch(1.0, 1.5, 11)}});
  EXPECT_NEAR(half.close.covered_stable.value(), 1.0, 1e-12);
  EXPECT_FALSE(compared(kExact, kExact).close.covered_stable.has_value());
}

TEST(CompareCurves, FindsNothingInNothing) {
  const CurveComparison nothing = compared(kExact, {});
  EXPECT_EQ(nothing.wide.covered, 0.0);
  EXPECT_EQ(nothing.wide.false_share, 0.0);
  EXPECT_EQ(nothing.length, 0.0);
}

TEST(CompareCurves, MatchesLocatedPointsOneToOneNearestFirst) {
  ResponseCurve exact = kExact, curve = kExact;
  exact.located = {{SpecialKind::fold, 1.2, 1},
                   {SpecialKind::fold, 1.2 + 1e-9, 1},  // located from both of the branches that meet there
                   {SpecialKind::fold, 1.23, 1},
                   {SpecialKind::fold, 1.8, 2},
                   {SpecialKind::grazing, 1.5, 1}};
  curve.located = {{SpecialKind::fold, 1.22, 1},
                   {SpecialKind::fold, 1.8, 1},  // of another order
                   {SpecialKind::contact_change, 1.51, 1},
                   {SpecialKind::period_doubling, 1.2, 1}};
  const CurveComparison found = compared(exact, curve);
  ASSERT_EQ(found.points.size(), 4U);
  EXPECT_EQ(found.points[0].exact.frequency, 1.2);
  EXPECT_FALSE(found.points[0].frequency.has_value());
  EXPECT_EQ(found.points[1].frequency, 1.22);  // nearer to 1.23
  EXPECT_EQ(found.points[2].frequency, 1.51);
  EXPECT_FALSE(found.points[3].frequency.has_value());
  ASSERT_EQ(found.invented.size(), 2U);
}

TEST(CompareCurves, DoesNotMatchPointsFarAway) {
  ResponseCurve exact = kExact, curve = kExact;
  exact.located = {{SpecialKind::fold, 1.2, 1}};
  curve.located = {{SpecialKind::fold, 1.26, 1}};
  const CurveComparison found = compared(exact, curve);
  EXPECT_FALSE(found.points[0].frequency.has_value());
  EXPECT_EQ(found.invented.size(), 1U);
}

}  // namespace
}  // namespace signorini::curve_comparison_test
