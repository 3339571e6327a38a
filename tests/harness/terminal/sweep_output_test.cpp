// What `sweep` prints of branches made by hand.

#include "harness/terminal/sweep_output.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace signorini::sweep_output_test {
namespace {

SolutionPoint point(double omega, double amplitude, OrbitStability stability, int order = 1) {
  return {.parameter = omega,
          .frequency = omega,
          .order = order,
          .x_max = {0.2, amplitude},
          .amplitude = {0.1, amplitude},
          .stability = stability};
}

MethodResponse response_with_a_fold() {
  MethodResponse response{.method = "exact-orbit"};
  Branch first{.began = "start at 4", .ended = "grazing"};
  first.points = {point(4.0, 1.0, OrbitStability::stable), point(3.0, 0.2, OrbitStability::stable)};
  first.special = {
      {.kind = SpecialKind::grazing, .point = first.points.back(), .text = "grazing", .after = 1}};
  Branch second{.began = "a doubling", .ended = "end of the interval"};
  second.points = {point(3.0, 0.2, OrbitStability::stable, 2), point(3.5, 1.0, OrbitStability::unstable, 2),
                   point(3.25, 2.0, OrbitStability::unstable, 2)};
  second.special = {{.kind = SpecialKind::fold, .point = point(3.75, 0.5, OrbitStability::unstable, 2)}};
  response.diagram.branches = {first, second};
  return response;
}

TEST(SweepText, ShowsWhereBranchesBeginChangeAndEnd) {
  EXPECT_EQ(sweep_text({response_with_a_fold()}),
            "exact-orbit: 2 branches\n"
            " omega [rad/s]  amplitude [m]\n"
            "branch 0: 2 points, all stable\n"
            "             4              1   begins: start at 4\n"
            "             3            0.2   ends: grazing\n"
            "branch 1, motions of 2 periods of the load: 3 points, 1 stable, 2 unstable\n"
            "             3            0.2   begins: a doubling\n"
            "          3.75            0.5   fold\n"
            "          3.25              2   ends: end of the interval\n");
}

TEST(SweepText, CountsEveryPointOnce) {
  MethodResponse response = response_with_a_fold();
  std::vector<SolutionPoint>& points = response.diagram.branches[1].points;
  points.push_back(point(3.2, 2.0, OrbitStability::undefined, 2));
  points.push_back(point(3.1, 2.0, OrbitStability::undefined, 2));
  points.back().undefined = "it depends on the order";
  const std::string text = sweep_text({response});
  EXPECT_NE(
      text.find(
          "5 points, 1 stable, 2 unstable, 1 undefined by the order of simultaneous impacts, 1 undefined "
          "where an impact grazes\n"),
      std::string::npos)
      << text;
}

TEST(SweepText, BreaksLongReasons) {
  MethodResponse response = response_with_a_fold();
  response.diagram.branches[0].ended = std::string(30, 'a') + " " + std::string(30, 'b');
  std::istringstream lines(sweep_text({response}));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(SweepText, HasStepsAndPointsAtValuesAsRows) {
  MethodResponse steps{.method = "hat-lcp"};
  steps.steps = {{.frequency = 2.0, .status = Status::timeout}};
  EXPECT_NE(sweep_text({steps}).find("timeout\n"), std::string::npos) << sweep_text({steps});
  MethodResponse at = response_with_a_fold();
  at.at_values = true;
  const std::string text = sweep_text({at});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6) << text;
}

TEST(Shortcomings, TellEachReasonOnce) {
  MethodResponse steps{.method = "closed-hbm"};
  for (int i = 0; i < 5; ++i)
    steps.steps.push_back({.frequency = 2.0, .status = Status::not_applicable, .message = "two laws"});
  steps.steps.push_back({.frequency = 2.0, .status = Status::timeout});
  steps.steps.push_back({.frequency = 2.0, .status = Status::converged, .message = "found"});
  EXPECT_EQ(shortcomings(steps, {}),
            (std::vector<std::string>{"closed-hbm: 5 of 7 points not-applicable: two laws",
                                      "closed-hbm: 1 of 7 points timeout"}));
  for (int i = 0; i < 9; ++i)
    steps.steps.push_back({.status = Status::not_converged, .message = std::to_string(i)});
  EXPECT_EQ(shortcomings(steps, {}).size(), 7U);
  EXPECT_EQ(shortcomings(steps, {}).back(), "closed-hbm: 5 reasons more (--format json has them all)");
}

TEST(Shortcomings, NameValuesThatNoBranchHas) {
  MethodResponse at = response_with_a_fold();
  at.at_values = true;
  EXPECT_EQ(shortcomings(at, {3.0, 3.25}), std::vector<std::string>{});
  EXPECT_EQ(
      shortcomings(at, {2.5, 3.0, 3.7}),
      std::vector<std::string>{"exact-orbit: no motion at 2.5, 3.7: no branch that was found goes there"});
  at.diagram = {.unfinished = "no orbit was found"};
  EXPECT_EQ(shortcomings(at, {3.0}),
            std::vector<std::string>{"exact-orbit: no motion at 3: no orbit was found"});
  EXPECT_EQ(shortcomings(at, {}), std::vector<std::string>{"no orbit was found"});
}

}  // namespace
}  // namespace signorini::sweep_output_test
