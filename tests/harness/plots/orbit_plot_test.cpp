#include "harness/plots/orbit_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/failure.hpp"
#include "harness/records/sampled_trajectory.hpp"

namespace signorini {
namespace {

Problem one_stop() {
  Problem problem;
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.75}};
  return problem;
}

FoundOrbit orbit(const std::string& name) {
  SampledTrajectory::Data data{.period = 1.0};
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
  EXPECT_NE(many.script.find("data index 11"), std::string::npos);
  EXPECT_EQ(many.script.find("data index 12"), std::string::npos);
}

TEST(OrbitPlot, RefusesToDrawNothing) { EXPECT_THROW(orbit_plot(one_stop(), {}), UsageError); }

}  // namespace
}  // namespace signorini
