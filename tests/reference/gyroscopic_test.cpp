// A disc whose gyroscopic moment couples the two planes of its shaft, against a flow in all coordinates.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "methods/closed_hbm/closed_hbm.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/orbit_check.hpp"

namespace signorini::gyroscopic_test {
namespace {

Problem gyroscopic_shaft() { return load_scene(find_scene("shaft-gyroscopic")); }

TEST(GyroscopicShaft, ItsOrbitIsOneOfTheFlowInAllCoordinates) {
  const Problem problem = gyroscopic_shaft();
  const Eigen::MatrixXd D = problem.damping();
  ASSERT_GT((D - D.transpose()).norm(), 0.1 * D.norm()) << "the planes are coupled by a skew matrix";
  const auto cold = test::cold_orbit(problem);
  ASSERT_TRUE(cold.orbit) << cold.solution.message;
  ASSERT_FALSE(cold.orbit->impulses().empty());
  const test::OrbitCheck check = test::check_orbit(problem, *cold.orbit, 1e-8);
  EXPECT_TRUE(check.ok) << check.reason;
}

TEST(GyroscopicShaft, SeriesApproachTheOrbit) {
  const Problem problem = gyroscopic_shaft();
  const auto cold = test::cold_orbit(problem);
  ASSERT_TRUE(cold.orbit) << cold.solution.message;
  std::vector<double> errors;
  for (const int harmonics : {20, 80}) {
    const Solution series = test::solve<ClosedHbm>(problem, {.harmonics = harmonics});
    ASSERT_EQ(series.verdict, Verdict::converged) << series.message;
    errors.push_back(test::relative_distance(*cold.orbit, *series.trajectory));
  }
  EXPECT_LT(errors[0], 0.05);
  EXPECT_LT(errors[1], 0.5 * errors[0]) << "harmonics up to 320 rad/s, beyond all modes of the shaft";
}

}  // namespace
}  // namespace signorini::gyroscopic_test
