// What is left of a scene where rigid motions that no contact feels are left out, and what that is called.

#include "harness/motion/followed_scene.hpp"

#include <gtest/gtest.h>

#include <string>

#include "harness/orbits/orbit_candidate.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::followed_scene_test {
namespace {

Problem pressed_pair(const std::string& load) {
  return parse_scene(
      "schema = 1\nname = \"pair\"\nsystem = { kind = \"chain\", masses = [1.0, 1.0], dampers = [0.0, 0.0], "
      "springs = [0.0, 0.0] }\nforcing = { frequency = 2.2, term = [{ dof = 0, harmonic = 0, cos = 0.55 }, "
      "{ dof = 1, harmonic = 0, cos = -0.55 }" +
          load + "] }\ncontact = [{ between = [0, 1], gap = 0.0, restitution = 0.5 }]\n",
      "pair");
}

LongRun verdict_on(const Problem& problem) {
  const FollowedScene followed(problem);
  EXPECT_EQ(followed.problem().size(), 1);
  const FlowState rest = placing_flow(followed.dynamics()).place(0.0, followed.dynamics().at_rest());
  return followed.follow(rest, {}, Deadline()).verdict;
}

TEST(FollowedScene, IsAtRestWhereTheWholeSceneIs) {
  EXPECT_EQ(verdict_on(pressed_pair("")), LongRun::at_rest);
  EXPECT_EQ(verdict_on(pressed_pair(", { dof = 0, cos = 0.3 }")), LongRun::periodic) << "they swing as one";
}

TEST(FollowedScene, TakesStatesOfTheWhole) {
  const Problem problem = pressed_pair("");
  const FollowedScene followed(problem);
  EXPECT_NEAR(followed.coordinates(Eigen::Vector2d(1.0, 1.0)).norm(), 0.0, 1e-15);
  EXPECT_GT(followed.coordinates(Eigen::Vector2d(1.0, 0.0)).norm(), 0.1);
}

}  // namespace
}  // namespace signorini::followed_scene_test
