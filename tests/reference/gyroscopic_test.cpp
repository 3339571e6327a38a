// A disc whose gyroscopic moment couples the two planes of its shaft, against a flow in all coordinates.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/curve.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
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

/// The shaft of the catalogue with this spin and frequency.
Problem shaft_with(const std::string& spin, double frequency) {
  std::ifstream file(find_scene("shaft-gyroscopic").file);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto put = [&text](const std::string& old, const std::string& other) {
    text.replace(text.find(old), old.size(), other);
  };
  put("spin = 4.0", "spin = " + spin);
  put("frequency = 4.0", "frequency = " + std::to_string(frequency));
  return parse_scene(text, "shaft-gyroscopic.toml");
}

double amplitude_of(const Trajectory& motion) {
  const Eigen::VectorXd x = motion.sample(1 << 14).x.col(0);
  return 0.5 * (x.maxCoeff() - x.minCoeff());
}

TEST(SynchronousShaft, HasAtEachFrequencyTheMatricesOfThatSpin) {
  const Problem synchronous = shaft_with("\"synchronous\"", 4.0);
  for (const double frequency : {4.0, 2.5, 6.25}) {
    const Problem expected = shaft_with(std::to_string(frequency), frequency);
    const Problem found = at_frequency(synchronous, frequency);
    const Eigen::MatrixXd D = expected.damping();
    EXPECT_LT((Eigen::MatrixXd(found.damping()) - D).norm(), 1e-15 * D.norm());
    EXPECT_EQ((Eigen::MatrixXd(found.stiffness()) - Eigen::MatrixXd(expected.stiffness())).norm(), 0.0);
  }
}

// A point of the unbalance response is the solve of the shaft with the spin of that frequency.
TEST(SynchronousShaft, IsFollowedAsItIsSolvedAtEachFrequency) {
  constexpr double kAt = 4.0;
  const ParametrisedScene scene = over_frequency(shaft_with("\"synchronous\"", 3.8), 3.8, 4.2);
  const Problem solved = shaft_with("4.0", kAt);
  const auto expect_point = [&](const Method& method, double tolerance) {
    const Solution solution = method.prepare(solved)->solve({});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const BranchDiagram diagram = method.curve()->follow(scene, {.max_order = 1, .at = {kAt}});
    double nearest = std::numeric_limits<double>::infinity();
    for (const Branch& branch : diagram.branches)
      for (const SolutionPoint& point : branch.points)
        if (std::abs(point.parameter - kAt) < 1e-9)
          nearest = std::min(nearest, std::abs(point.amplitude.front() - amplitude_of(*solution.trajectory)));
    EXPECT_LT(nearest, tolerance) << diagram.unfinished;
  };
  expect_point(ExactOrbitMethod({}), 1e-7);
  expect_point(HatLcp({.samples = 64}), 1e-4);
  expect_point(FourierLipschitz({.harmonics = 10}), 1e-4);
}

}  // namespace
}  // namespace signorini::gyroscopic_test
