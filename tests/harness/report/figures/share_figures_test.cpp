#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::share_figures_test {
namespace {

TEST(ProfileFigure, EndsEveryCurveAtTheShareSolved) {
  std::vector<Record> records = test::records_of_two_methods();
  records[0].status = records[1].status = Status::timeout;  // a on s1
  const Evaluation evaluation(records);
  const std::string data = profile_figure(evaluation, 0).data;
  EXPECT_NE(data.find("# a, error 1e-02\n1 0.500000\n"), std::string::npos) << data;
  EXPECT_NE(data.find("# b, error 1e-06\n1 0.000000\n"), std::string::npos) << data;
}

TEST(ProfileFigure, StacksItsPanelsInASingleColumn) {
  const Evaluation evaluation(test::records_of_two_methods());
  const Figure usual = profile_figure(evaluation, 0), narrow = profile_figure(evaluation, 0, Column::single);
  EXPECT_NE(usual.script.find("layout 1,3"), std::string::npos);
  EXPECT_NE(narrow.script.find("layout 3,1"), std::string::npos);
  EXPECT_EQ(narrow.width, kSingleColumn);
  EXPECT_GT(narrow.height, 2.0 * usual.height);
  EXPECT_EQ(narrow.script.find("set format y ''"), std::string::npos);  // every panel has its numbers
  EXPECT_NO_THROW((void)drawn(narrow, "svg"));
}

// Two methods at five errors on two scenes: ten targets each, of which a failure takes five away.
TEST(DistributionFigure, StepsToTheShareOfTargetsReached) {
  std::vector<Record> records = test::records_of_two_methods();
  records[0].status = records[1].status = Status::timeout;  // a on s1
  const Evaluation evaluation(records);
  const Costs times = costs_to_targets(evaluation.groups()[0], time_axis());
  const auto reached = std::ranges::count_if(times[0], [](double time) { return std::isfinite(time); });
  ASSERT_EQ(times[0].size(), 10U);
  EXPECT_GT(reached, 0);
  EXPECT_LE(reached, 5);
  const Figure figure = distribution_figure(evaluation, 0);
  const std::string data = figure.data.substr(0, figure.data.find("\n\n"));
  EXPECT_TRUE(data.starts_with("# a, all targets\n")) << data;
  EXPECT_TRUE(data.ends_with(fmt::format(" {:.6f}", static_cast<double>(reached) / 10.0))) << data;
  EXPECT_NO_THROW((void)drawn(figure, "svg"));
}

}  // namespace
}  // namespace signorini::share_figures_test
