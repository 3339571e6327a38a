#include "harness/run/start_point.hpp"

#include <gtest/gtest.h>

#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

Case case_starting(const Scene& scene, const std::string& start) {
  return make_case(scene, 0, {&test::fake_catalogue().front(), {{"start", start}}});
}

Reference reference_of(const Problem& problem) {
  return {.orbit = std::make_shared<SampledTrajectory>(*test::free_motion(problem), 64)};
}

TEST(StartPoint, IsColdUnlessTheCaseAsksForOne) {
  const Scene scene = test::one_mass_scene();
  const StartPoint start =
      start_point(test::fake_case(scene, "good"), scene.problem, reference_of(scene.problem));
  EXPECT_EQ(start.motion, nullptr);
  EXPECT_EQ(start.obstacle, "");
}

TEST(StartPoint, IsTheReferenceLateByAShareOfItsPeriod) {
  const Scene scene = test::one_mass_scene();
  const StartPoint start =
      start_point(case_starting(scene, "0.25"), scene.problem, reference_of(scene.problem));
  ASSERT_NE(start.motion, nullptr) << start.obstacle;
  const Eigen::VectorXd x = test::free_motion(scene.problem)->sample(8).x.col(0);
  const Eigen::VectorXd late = start.motion->sample(8).x.col(0);
  for (Eigen::Index i = 0; i < 8; ++i) EXPECT_NEAR(late[i], x[(i + 6) % 8], 1e-12) << i;
}

TEST(StartPoint, RepeatsTheReferenceToThePeriodOfTheProblem) {
  const Scene scene = test::one_mass_scene();
  Problem longer = scene.problem;
  longer.subharmonic = 3;
  const StartPoint start = start_point(case_starting(scene, "0"), longer, reference_of(scene.problem));
  ASSERT_NE(start.motion, nullptr) << start.obstacle;
  EXPECT_DOUBLE_EQ(start.motion->period(), longer.period());
}

TEST(StartPoint, NamesTheObstacle) {
  const Scene scene = test::one_mass_scene();
  const Reference none{.reason = "chaos"};
  EXPECT_EQ(start_point(case_starting(scene, "0"), scene.problem, none).obstacle,
            "no orbit to start from: chaos");
  Problem slower = scene.problem;
  slower.frequency *= 0.6;
  const StartPoint start = start_point(case_starting(scene, "0"), slower, reference_of(scene.problem));
  EXPECT_EQ(start.motion, nullptr);
  EXPECT_NE(start.obstacle.find("has a period of"), std::string::npos) << start.obstacle;
}

}  // namespace
}  // namespace signorini
