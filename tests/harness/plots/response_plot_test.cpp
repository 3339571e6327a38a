#include "harness/plots/response_plot.hpp"

#include <gtest/gtest.h>

#include "harness/plots/plot_file.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::response_plot_test {
namespace {

SolutionPoint point(double frequency, double amplitude, OrbitStability stability) {
  return {.parameter = frequency, .amplitude = {0.5 * amplitude, amplitude}, .stability = stability};
}

MethodResponse two_parts() {
  Branch branch{.points = {point(1.0, 0.1, OrbitStability::stable), point(1.1, 0.2, OrbitStability::stable),
                           point(1.2, 0.3, OrbitStability::unstable),
                           point(1.3, 0.4, OrbitStability::unstable)}};
  branch.special.push_back(
      {.kind = SpecialKind::fold, .point = point(1.15, 0.25, OrbitStability::undefined), .after = 2});
  return {.method = "it's'; system('x')", .diagram = {.branches = {branch}}};
}

TEST(ResponsePlot, DrawsStableAndUnstablePartsThatMeet) {
  const Figure figure = response_plot("scene", {two_parts()});
  EXPECT_EQ(figure.data,
            "1 0.1\n1.1 0.2\n1.15 0.25\n\n\n\n"  // stable up to the fold
            "1.15 0.25\n1.2 0.3\n1.3 0.4\n\n\n\n"
            "1.15 0.25\n\n\n");
  EXPECT_NE(figure.script.find("title 'it''s''; system(''x'')'"), std::string::npos) << figure.script;
  EXPECT_NE(figure.script.find("title 'fold'"), std::string::npos);
  EXPECT_EQ(figure.script.find("grazing"), std::string::npos);
}

TEST(ResponsePlot, IsAsWideAsAColumn) {
  const Figure figure = response_plot("scene", {two_parts()}, ResponseOrdinate::amplitude, Column::single);
  EXPECT_EQ(figure.width, kSingleColumn);
  EXPECT_LT(figure.height, response_plot("scene", {two_parts()}).height);
  EXPECT_NE(figure.script.find("maxcols 1 "), std::string::npos);
}

TEST(ResponsePlot, OfABifurcationHasACurveForEachForcingPeriod) {
  Branch branch;
  for (const double p : {1.0, 1.1}) {
    branch.points.push_back(point(p, 0.3, OrbitStability::stable));
    branch.points.back().order = 2;
    branch.points.back().motion =
        Eigen::MatrixXd{{0.0, p}, {0.0, -p}};  // of two contacts, the second moves most
  }
  const MethodResponse response{.method = "m", .diagram = {.branches = {branch}}};
  const Figure figure = response_plot("scene", {response}, ResponseOrdinate::once_a_period);
  EXPECT_EQ(figure.data, "1 1\n1.1 1.1\n\n1 -1\n1.1 -1.1\n\n\n\n");
  EXPECT_NE(figure.script.find("x at t = 0"), std::string::npos);
  branch.points[1].motion.resize(0, 0);  // not kept
  EXPECT_EQ(response_plot("scene", {{.method = "m", .diagram = {.branches = {branch}}}},
                          ResponseOrdinate::once_a_period)
                .data,
            "");
}

TEST(ResponsePlot, DrawsStepsAsPointsWithoutThoseThatFailed) {
  const MethodResponse steps{.method = "m",
                             .steps = {{.frequency = 1.0, .status = Status::converged, .amplitude = {0.5}},
                                       {.frequency = 1.1, .status = Status::timeout, .amplitude = {9.0}}}};
  EXPECT_EQ(response_plot("scene", {steps}).data, "1 0.5\n\n\n");
}

TEST(ResponsePlot, CanBeDrawnWhateverItHolds) {
  const test::TemporaryFolder folder;
  for (const std::vector<MethodResponse>& responses :
       {std::vector<MethodResponse>{}, {two_parts()}, {{.method = "nothing"}}})
    EXPECT_NO_THROW(write_plot(folder.path() / "a.svg", response_plot("scene", responses)));
}

}  // namespace
}  // namespace signorini::response_plot_test
