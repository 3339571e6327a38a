#include "harness/plots/orbit_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/failure.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini::orbit_plot_test {
namespace {

Problem one_stop() {
  Problem problem;
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.75}};
  return problem;
}

FoundOrbit orbit(const std::string& name) {
  SampledTrajectory::Data data;
  data.samples.x = Eigen::MatrixXd::Constant(4, 1, 0.25);
  data.samples.x(1, 0) = 0.75;
  data.samples.velocity = Eigen::MatrixXd::Zero(4, 1);
  data.samples.force = Eigen::MatrixXd::Zero(4, 1);
  FoundOrbit found{.fingerprint = name, .order = 1};
  found.certified.motion = std::make_shared<SampledTrajectory>(std::move(data));
  found.certified.stable = true;
  return found;
}

TEST(OrbitPlot, HasAPortraitWithTheStopForEachOrbitUpToTwelve) {
  const Figure two = orbit_plot(one_stop(), {orbit("first"), orbit("second")});
  EXPECT_NE(two.script.find("first: order 1, stable"), std::string::npos);
  EXPECT_NE(two.script.find("from 0.75, graph 0"), std::string::npos);
  EXPECT_NE(two.script.find("data index 1"), std::string::npos);
  const Figure many = orbit_plot(one_stop(), std::vector<FoundOrbit>(20, orbit("again")));
  std::size_t portraits = 0;
  for (std::size_t at = many.data.find("velocity"); at != std::string::npos;
       at = many.data.find("velocity", at + 1))
    ++portraits;
  EXPECT_EQ(portraits, 12U);
}

TEST(OrbitPlot, ShowsMultipliersOfAllAndTheShareOfStartsOfEach) {
  std::vector<FoundOrbit> orbits{orbit("first"), orbit("second")};
  orbits[0].certified.floquet = FloquetMultipliers{{0.5, 0.25}, {0.5, -0.25}};
  orbits[0].starts = 3;
  orbits[1].certified.floquet = FloquetMultipliers{{-2.5, 0.0}};
  orbits[1].certified.stable = false;
  orbits[1].starts = 1;
  const Figure figure = orbit_plot(one_stop(), orbits);
  EXPECT_NE(figure.data.find("0.5 0.25\n0.5 -0.25\n"), std::string::npos) << figure.data;
  EXPECT_NE(figure.script.find("set xrange [-2.75:2.75]"), std::string::npos) << figure.script;  // holds all
  EXPECT_NE(figure.data.find("# first\n0 75\n"), std::string::npos) << figure.data;
  EXPECT_NE(figure.data.find("# second\n1 25\n"), std::string::npos) << figure.data;
  EXPECT_NO_THROW((void)drawn(figure, "svg"));
}

TEST(OrbitPlot, StacksItsPortraitsInASingleColumn) {
  const Figure figure = orbit_plot(one_stop(), {orbit("first"), orbit("second")}, Column::single);
  EXPECT_EQ(figure.width, kSingleColumn);
  EXPECT_NE(figure.script.find("layout 4,1"), std::string::npos);  // with multipliers and starts
}

TEST(OrbitPlot, RefusesToDrawNothing) { EXPECT_THROW(orbit_plot(one_stop(), {}), UsageError); }

}  // namespace
}  // namespace signorini::orbit_plot_test
