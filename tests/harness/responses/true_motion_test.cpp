// Which motions on no exact branch the judge takes for true ones.

#include "harness/responses/true_motion.hpp"

#include <gtest/gtest.h>

#include "harness/motion/long_motion.hpp"
#include "harness/orbits/orbit_candidate.hpp"
#include "harness/responses/response_curve.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::true_motion_test {
namespace {

constexpr double kOmega = 3.8;  // rad/s: most starts reach a motion of three periods

/// What time marching settles to from rest or from a random state, of this order.
ResponsePoint settled(const Problem& problem, int order) {
  const ContactDynamics dynamics(problem);
  const EventFlow placing = placing_flow(dynamics);
  for (int number = 0; number < 20; ++number) {
    const LongMotion motion =
        follow_long_motion(dynamics, random_state(placing, 1U, number), {}, Deadline::after(60.0));
    if (motion.verdict != LongRun::periodic || motion.order != order) continue;
    return {.frequency = problem.frequency,
            .order = order,
            .motion = motion.trajectory->sample(order * kComparedPhases).x};
  }
  return {};
}

TEST(TrueMotions, ContainWhatTimeMarchingFindsAndNoLies) {
  Problem problem = read_scene(find_scene("sdof-stop-e0")).problem;
  problem.frequency = kOmega;
  const ResponsePoint point = settled(problem, 3);
  ASSERT_EQ(point.motion.rows(), 3 * kComparedPhases);
  const double amplitude = half_range(point.motion);
  EXPECT_NEAR(amplitude, 0.258738, 1e-4);  // by a march of its own
  const ResponseMetric metric(2.5, amplitude);
  TrueMotions judge(over_frequency(problem, 1.5, 4.0), metric, 0.05, Deadline::after(60.0));
  EXPECT_TRUE(judge.contain(point));
  ResponsePoint coarse = point;  // as a method errs
  coarse.motion *= 1.02;
  EXPECT_TRUE(judge.contain(coarse));
  ResponsePoint larger = point;
  larger.motion *= 1.2;
  EXPECT_FALSE(judge.contain(larger));
  ResponsePoint still = point;
  still.motion.setZero();
  EXPECT_FALSE(judge.contain(still));
  ResponsePoint backwards = point;
  backwards.motion = point.motion.colwise().reverse().eval();
  EXPECT_FALSE(judge.contain(backwards));
}

TEST(TrueMotions, ContainNothingWhenTheTimeIsUp) {
  const Problem problem = read_scene(find_scene("sdof-stop")).problem;
  const ResponseMetric metric(1.0, 1.0);
  TrueMotions judge(over_frequency(problem, 2.0, 3.0), metric, 0.05, Deadline::after(0.0));
  EXPECT_FALSE(judge.contain({.frequency = 2.2, .motion = Eigen::MatrixXd::Zero(kComparedPhases, 1)}));
}

}  // namespace
}  // namespace signorini::true_motion_test
