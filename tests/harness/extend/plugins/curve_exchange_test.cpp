#include "harness/extend/plugins/curve_exchange.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "harness/records/json_fields.hpp"
#include "harness/text/json.hpp"

namespace signorini::curve_exchange_test {
namespace {

ParametrisedScene interval(double from, double to) {
  return {
      .parameter = std::string(kFrequency), .from = from, .to = to, .at = [](double) { return Problem{}; }};
}

/// a + b cos(h w t / k), one contact.
ExchangedPoint wave(double omega, double mean, double amplitude, int order = 1) {
  return {.omega = omega, .order = order, .coefficients = {{mean, amplitude, 0.0}}};
}

BranchDiagram diagram(std::vector<ExchangedPoint> points, const CurveLimits& limits = {}, double from = 1.0,
                      double to = 2.0) {
  ExchangedCurve curve;
  curve.branches.push_back(
      {.sequence = "waves", .began = "there", .ended = "here", .points = std::move(points)});
  return diagram_of(curve, interval(from, to), 1, limits);
}

TEST(ExchangedCurves, HaveTheExtremesOfTheirSeries) {
  const BranchDiagram found = diagram({wave(1.0, 0.5, 2.0), wave(1.5, 0.5, -3.0)});
  ASSERT_EQ(found.branches.size(), 1U);
  const Branch& branch = found.branches.front();
  EXPECT_EQ(branch.sequence, "waves");
  EXPECT_EQ(branch.began, "there");
  EXPECT_EQ(branch.ended, "here");
  EXPECT_NEAR(branch.points[0].amplitude[0], 2.0, 1e-12);
  EXPECT_NEAR(branch.points[0].x_max[0], 2.5, 1e-12);
  EXPECT_NEAR(branch.points[1].x_max[0], 3.5, 1e-12);
  EXPECT_EQ(branch.points[1].stability, OrbitStability::unknown);
}

TEST(ExchangedCurves, AreFiniteOrRefused) {
  constexpr double kLargest = 1.5e308;
  const ExchangedPoint wide{.omega = 1.0, .x = {{kLargest, -kLargest}}},
      next{.omega = 1.5, .x = {{0.0, 1.0}}};
  EXPECT_EQ(diagram({wide, next}).branches.front().points[0].amplitude[0], kLargest);
  EXPECT_THROW(static_cast<void>(diagram({wave(1.0, kLargest, kLargest), next})), BadRecord);
}

TEST(ExchangedCurves, KeepTheOrderOfTheSceneAndSayWhereLongerPeriodsAreCutOff) {
  ExchangedCurve curve;
  curve.branches.push_back({.began = "there",
                            .ended = "here",
                            .points = {wave(1.1, 0.0, 1.0, 3), wave(1.2, 0.0, 1.0, 3), wave(1.3, 0.0, 1.0, 6),
                                       wave(1.4, 0.0, 1.0, 3), wave(1.5, 0.0, 1.0, 3)}});
  ParametrisedScene scene = interval(1.0, 2.0);
  scene.at = [](double) {
    Problem problem;
    problem.subharmonic = 3;
    return problem;
  };
  const CurveLimits limits{.max_order = 2};  // the scene's own is larger
  EXPECT_EQ(follow_request(scene, limits).at("max_order"), 3);
  const std::vector<Branch> parts = diagram_of(curve, scene, 1, limits).branches;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].ended, "a period of 6 forcing periods, of 3 at most");
  EXPECT_EQ(parts[1].began, parts[0].ended);
  EXPECT_EQ(parts[1].ended, "here");
}

TEST(ExchangedCurves, GiveTheSameMotionAsSeriesAndAsSamples) {
  constexpr int kPhases = 16, kOrder = 2;
  const auto wave_at = [](double angle) {
    return 0.5 + 2.0 * std::cos(angle) - 0.75 * std::sin(angle) + 0.3 * std::sin(2.0 * angle);
  };
  ExchangedPoint samples{.omega = 1.25, .order = kOrder, .x = {{}}};
  for (int i = 0; i < 4 * kPhases * kOrder; ++i)
    samples.x[0].push_back(wave_at(2.0 * std::numbers::pi * i / (4 * kPhases * kOrder)));
  const ExchangedPoint series{.omega = 1.25, .order = kOrder, .coefficients = {{0.5, 2.0, -0.75, 0.0, 0.3}}};
  const BranchDiagram found = diagram({samples, series}, {.max_order = kOrder, .phases = kPhases});
  ASSERT_EQ(found.branches.size(), 1U);
  const std::vector<SolutionPoint>& points = found.branches.front().points;
  ASSERT_EQ(points[0].motion.rows(), kPhases * kOrder);
  EXPECT_LT((points[0].motion - points[1].motion).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ExchangedCurves, AreCutAtTheEndsOfTheInterval) {
  const BranchDiagram found =
      diagram({wave(0.5, 0.0, 1.0), wave(1.1, 0.0, 1.0), wave(1.2, 0.0, 1.0), wave(2.5, 0.0, 1.0),
               wave(1.9, 0.0, 1.0), wave(2.6, 0.0, 1.0), wave(1.5, 0.0, 1.0), wave(1.4, 0.0, 1.0)});
  ASSERT_EQ(found.branches.size(), 2U);
  EXPECT_EQ(found.branches[0].points.size(), 2U);
  EXPECT_EQ(found.branches[0].began, "end of the interval");
  EXPECT_EQ(found.branches[0].ended, "end of the interval");
  EXPECT_EQ(found.branches[1].ended, "here");
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_EQ(found.notes[0], "a point alone at 1.9 rad/s");
}

TEST(ExchangedCurves, SayWhereThereIsNone) {
  EXPECT_EQ(diagram({}).unfinished, "no branch of two points or more from 1 to 2 rad/s");
  EXPECT_EQ(diagram({wave(3.0, 0.0, 1.0), wave(3.1, 0.0, 1.0)}).unfinished,
            "no branch of two points or more from 1 to 2 rad/s");
}

TEST(ExchangedCurves, KeepTheLimits) {
  const std::vector<ExchangedPoint> three{wave(1.1, 0.0, 1.0), wave(1.2, 0.0, 1.0), wave(1.3, 0.0, 1.0)};
  const BranchDiagram short_one = diagram(three, {.max_points = 2});
  ASSERT_EQ(short_one.branches.size(), 1U);
  EXPECT_EQ(short_one.branches[0].points.size(), 2U);
  EXPECT_EQ(short_one.branches[0].ended, "limit of points");
  const BranchDiagram none = diagram(three, {.max_branches = 0});
  EXPECT_TRUE(none.branches.empty());
  EXPECT_EQ(none.unfinished, "more than 0 branches");
}

TEST(ExchangedCurves, PutSpecialPointsWhereTheyBelong) {
  ExchangedCurve curve;
  curve.branches.push_back(
      {.points = {wave(1.1, 0.0, 1.0), wave(1.2, 0.0, 1.0)},
       .special = {{.kind = SpecialKind::fold, .point = wave(1.21, 0.0, 1.0), .after = 1}}});
  const BranchDiagram found = diagram_of(curve, interval(1.0, 2.0), 1, {});
  ASSERT_EQ(found.branches.at(0).special.size(), 1U);
  EXPECT_EQ(found.branches[0].special[0].after, 1U);
  EXPECT_EQ(found.branches[0].special[0].point.frequency, 1.21);
}

TEST(ExchangedCurves, AreRefusedWhereTheyAreNoMotions) {
  const auto complaint = [](const ExchangedPoint& point) {
    try {
      static_cast<void>(diagram({point, point}));
    } catch (const BadRecord& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(complaint({.omega = 1.5}), "point at 1.5 rad/s (must have either x or coefficients)");
  EXPECT_EQ(complaint({.omega = 1.5, .x = {{1.0, 2.0}}, .coefficients = {{1.0}}}),
            "point at 1.5 rad/s (must have either x or coefficients)");
  EXPECT_EQ(complaint({.omega = -1.5, .x = {{1.0, 2.0}}}), "omega = -1.5 (must be a positive number)");
  EXPECT_EQ(complaint({.omega = 1.5, .order = 0, .x = {{1.0, 2.0}}}), "order = 0 (must be in 1..1000)");
  EXPECT_EQ(complaint({.omega = 1.5, .x = {{1.0, 2.0}, {1.0, 2.0}}}),
            "x = 2 lists (must be one for each of 1 contacts)");
  EXPECT_EQ(complaint({.omega = 1.5, .coefficients = {{1.0, 2.0}}}),
            "coefficients = 2 numbers (must be a_0 and pairs a_h, b_h)");
  EXPECT_EQ(complaint({.omega = 1.5, .x = {{1.0, std::nan("")}}}), "x (must be finite numbers)");
}

TEST(ExchangedCurves, AreReadFromJson) {
  const ExchangedCurve curve = curve_from_json(parse_json(
      R"({"branches": [{"points": [{"omega": 1.5, "x": [[0.0, 1.0]], "stable": false, "impacts": 2}], "by_steps": true}],
          "unfinished": "time is up", "seconds": 0.25})"));
  ASSERT_EQ(curve.branches.size(), 1U);
  EXPECT_TRUE(curve.branches[0].by_steps);
  EXPECT_EQ(curve.branches[0].points.at(0).impacts, 2);
  EXPECT_EQ(curve.branches[0].points[0].stable, false);
  EXPECT_EQ(curve.unfinished, "time is up");
  EXPECT_EQ(curve.seconds, 0.25);
  EXPECT_THROW(curve_from_json(parse_json(R"({"branches": [], "seconds": -1})")), BadRecord);
  EXPECT_THROW(curve_from_json(parse_json(R"({"branches": [], "surprise": 1})")), BadRecord);
  EXPECT_THROW(curve_from_json(parse_json(R"({"branches": [{"points": [{"omega": 1.0, "y": [[0.0]]}]}]})")),
               BadRecord);
  EXPECT_THROW(curve_from_json(parse_json("{}")), std::exception);
}

}  // namespace
}  // namespace signorini::curve_exchange_test
