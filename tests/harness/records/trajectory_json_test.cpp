#include "harness/records/trajectory_json.hpp"

#include <gtest/gtest.h>

#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

TEST(TrajectoryJson, ComesBackAsItWent) {
  const auto source = test::free_motion(test::one_mass());
  const SampledTrajectory sampled(*source, 32);
  const auto back = trajectory_of(source->period(), samples_of(sampled, 32));
  EXPECT_EQ(back->sample(32).x, sampled.sample(32).x);
  EXPECT_EQ(back->bandwidth(), source->bandwidth());
  TrajectorySamples uneven = samples_of(sampled, 32);
  uneven.force[0].pop_back();
  EXPECT_THROW(trajectory_of(1.0, uneven), BadRecord);
}

}  // namespace
}  // namespace signorini
