#include "harness/responses/response_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/harness/responses/drawn_responses.hpp"

namespace signorini::response_curve_test {
namespace {

using test::level_branch;
using test::moving;

const ResponseMetric kMetric(1.0, 1.0);

double length_of(const ResponseCurve& curve) {
  double length = 0.0;
  for (const CurveElement& element : elements_of(curve, kMetric)) {
    EXPECT_LE(element.length, kElementLength * (1.0 + 1e-12));
    length += element.length;
  }
  return length;
}

TEST(ElementsOf, HaveTheLengthOfTheCurveHoweverManyPointsItHas) {
  for (const int points : {2, 7, 1001}) {
    EXPECT_NEAR(length_of({.branches = {level_branch(1.0, 2.0, points)}}), 1.0, 1e-12) << points;
  }
}

TEST(ElementsOf, RunThroughTheMotionsBetweenNeighbours) {
  const ResponseCurve curve{.branches = {{.points = {moving(1.0, 1.0), moving(1.0, 1.2)}}}};
  EXPECT_NEAR(length_of(curve), 0.2 / std::sqrt(2.0), 1e-12);
  for (const CurveElement& element : elements_of(curve, kMetric)) {
    EXPECT_GT(element.middle.motion(0, 0), 1.0);
    EXPECT_LT(element.middle.motion(0, 0), 1.2);
  }
}

TEST(ElementsOf, BridgeAJumpByArcLengthButNotByStepsOfTheFrequency) {
  const auto jumping = [](bool by_arc_length) {
    return ResponseCurve{
        .branches = {{.points = {moving(1.0, 1.0), moving(1.05, 1.0), moving(1.1, 3.0), moving(1.15, 3.0)},
                      .by_arc_length = by_arc_length}}};
  };
  EXPECT_NEAR(length_of(jumping(false)), 0.1, 1e-12);
  EXPECT_NEAR(length_of(jumping(true)), 0.1 + 2.0 / std::sqrt(2.0), 1e-12);
}

TEST(ElementsOf, CountAPointWithoutNeighboursAsOneElement) {
  EXPECT_NEAR(length_of({.branches = {{.points = {moving(1.0, 1.0)}}}}), kElementLength, 1e-15);
  const ResponseCurve apart{.branches = {{.points = {moving(1.0, 1.0), moving(1.5, 1.0), moving(2.0, 1.0)},
                                          .by_arc_length = false}}};
  EXPECT_NEAR(length_of(apart), 3.0 * kElementLength, 1e-15);
  EXPECT_EQ(length_of({}), 0.0);
}

TEST(ElementsOf, HaveTheLeastPeriodOfTheirMotion) {
  const ResponseCurve curve{.branches = {{.points = {moving(1.0, 1.0, 2, 0.0), moving(1.0, 1.0, 2, 0.2)}}}};
  const std::vector<CurveElement> elements = elements_of(curve, kMetric);
  EXPECT_EQ(elements.back().middle.order, 2);
}

TEST(CurveOfDiagram, HoldsPointsLocatedPointsAndWhatIsLeftOpen) {
  SolutionPoint point{.parameter = 2.0, .frequency = 2.0, .order = 2, .stability = OrbitStability::stable};
  point.motion = moving(2.0, 1.0, 2).motion;
  Branch branch{.points = {point, point}};
  branch.points[1].stability = OrbitStability::undefined;
  branch.special.push_back({.kind = SpecialKind::period_doubling, .point = point});
  branch.special.back().point.amplitude = {0.5, 0.75};
  const ResponseCurve curve =
      curve_of(BranchDiagram{.branches = {branch}, .unfinished = "the time is up", .notes = {"a corner"}});
  ASSERT_EQ(curve.branches.size(), 1U);
  EXPECT_EQ(curve.branches[0].points[0].stable, true);
  EXPECT_FALSE(curve.branches[0].points[1].stable.has_value());
  EXPECT_TRUE(curve.branches[0].by_arc_length);
  ASSERT_EQ(curve.located.size(), 1U);
  EXPECT_EQ(curve.located[0].kind, SpecialKind::period_doubling);
  EXPECT_EQ(curve.located[0].frequency, 2.0);
  EXPECT_EQ(curve.located[0].order, 2);
  EXPECT_EQ(curve.located[0].amplitude, 0.75);
  EXPECT_EQ(curve.open_ends, (std::vector<std::string>{"the time is up", "a corner"}));
}

SweepPoint step(double frequency, Status status, int periods) {
  SweepPoint point{.frequency = frequency, .status = status};
  SweptMotion motion{.period = 2.0 * std::numbers::pi * periods / frequency};
  std::vector<double>& x = motion.x.emplace_back();
  for (int i = 0; i < 1000; ++i) x.push_back(std::cos(2.0 * std::numbers::pi * i * periods / 1000.0));
  point.motion = std::move(motion);
  return point;
}

TEST(CurveOfSteps, IsCutWhereASolveFailsAndTakesThePeriodOfEachAnswer) {
  const ResponseCurve curve =
      curve_of({step(1.0, Status::converged, 1), step(1.02, Status::converged, 2),
                step(1.04, Status::not_converged, 1), step(1.06, Status::converged, 1)});
  ASSERT_EQ(curve.branches.size(), 2U);
  EXPECT_EQ(curve.branches[0].points.size(), 2U);
  EXPECT_FALSE(curve.branches[0].by_arc_length);
  EXPECT_EQ(curve.branches[0].points[1].order, 2);
  EXPECT_EQ(curve.branches[0].points[1].motion.rows(), 2 * kComparedPhases);
  const Eigen::MatrixXd expected = moving(1.0, 1.0).motion;
  EXPECT_LT((curve.branches[0].points[0].motion - expected).lpNorm<Eigen::Infinity>(), 1e-4);
}

TEST(CurveOfSteps, LeavesOutWhatIsNoWholeNumberOfForcingPeriods) {
  SweepPoint odd = step(1.0, Status::converged, 1);
  odd.motion->period *= 1.1;
  EXPECT_TRUE(curve_of({odd}).branches.empty());
}

TEST(Thinned, KeepsTheEndsOfAStraightBranchAndWhatStandsBesideAChangeOfStability) {
  ResponseBranch straight = level_branch(1.0, 2.0, 101);
  EXPECT_EQ(thinned({.branches = {straight}}, kMetric).branches[0].points.size(), 2U);
  for (std::size_t i = 0; i < straight.points.size(); ++i) straight.points[i].stable = i < 40;
  const std::vector<ResponsePoint> kept = thinned({.branches = {straight}}, kMetric).branches[0].points;
  ASSERT_EQ(kept.size(), 4U);
  EXPECT_NEAR(kept[1].frequency, 1.39, 1e-12);
  EXPECT_NEAR(kept[2].frequency, 1.40, 1e-12);
  straight.by_arc_length = false;
  EXPECT_EQ(thinned({.branches = {straight}}, kMetric).branches[0].points.size(), 101U);
  EXPECT_TRUE(thinned({.branches = {ResponseBranch()}}, kMetric).branches[0].points.empty());
}

// Half a turn of radius 1: chords whose sagitta is 1e-3 are .09 long.
TEST(Thinned, KeepsTheLengthOfABend) {
  constexpr int kPoints = 2001;
  ResponseBranch bend;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = std::numbers::pi * i / (kPoints - 1);
    bend.points.push_back(moving(2.0 - std::cos(angle), std::numbers::sqrt2 * std::sin(angle)));
  }
  const ResponseCurve whole{.branches = {bend}}, thin = thinned(whole, kMetric);
  EXPECT_GT(thin.branches[0].points.size(), 20U);
  EXPECT_LT(thin.branches[0].points.size(), 80U);
  EXPECT_NEAR(length_of(thin), length_of(whole), 3e-3 * length_of(whole));
}

TEST(AmplitudeOf, IsHalfTheLargestPeakToPeakWhereverTheOriginIs) {
  const ResponseCurve curve{
      .branches = {{.points = {moving(1.0, 1.0, 1, 0.0, 50.0), moving(1.1, 1.5, 1, 0.0, 50.0)}}}};
  EXPECT_NEAR(amplitude_of(curve), 1.5, 1e-12);
  EXPECT_EQ(amplitude_of({}), 0.0);
}

}  // namespace
}  // namespace signorini::response_curve_test
