#include "harness/plots/section_plot.hpp"

#include <gtest/gtest.h>

#include "harness/failure.hpp"
#include "harness/records/sampled_trajectory.hpp"

namespace signorini::section_plot_test {
namespace {

TEST(SectionPlot, ShowsTheLiveliestContactWithItsStop) {
  Problem problem;
  problem.name = "two";
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 9.0}, {.normal = {{1, 1.0}}, .gap = 0.75}};
  SampledTrajectory::Data data;
  data.samples.x = Eigen::MatrixXd::Zero(4, 2);
  data.samples.x.col(1) << 0.0, 0.5, 0.75, 0.25;
  data.samples.velocity = data.samples.force = Eigen::MatrixXd::Zero(4, 2);
  const SampledTrajectory waveform(std::move(data));
  const LongMotion motion{.verdict = LongRun::irregular,
                          .section = {{0.0, 0.0, 0.125, -3.0}, {0.0, 0.0, 0.625, 2.0}}};
  const Figure figure = section_plot(problem, motion, waveform);
  EXPECT_NE(figure.script.find("two, contact 1: irregular"), std::string::npos) << figure.script;
  EXPECT_NE(figure.script.find("0.75 with lines"), std::string::npos) << figure.script;
  EXPECT_NE(figure.data.find("0.125 -3\n0.625 2\n"), std::string::npos) << figure.data;
  EXPECT_THROW((void)section_plot(problem, LongMotion(), waveform), UsageError);
}

}  // namespace
}  // namespace signorini::section_plot_test
