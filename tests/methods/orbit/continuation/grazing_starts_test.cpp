// Branches of stops with a damper: what begins at their grazings, and where it goes.

#include "methods/orbit/continuation/grazing_starts.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"

namespace signorini::grazing_starts_test {
namespace {

using test::branch_of;
using test::diagram_of;
using test::kLocated;
using test::nearest;
using test::polished;

constexpr double kGrazing = 2.448265181813;  // where the contact-free motion reaches 0.2 [rad/s]

/// m = k = F = 1, damping 0.1, before a stop at 0.2 of the spring 100 N/m and the damper c.
Problem before_damped_stop(double c) {
  return parse_scene(
      "schema = 1\nname = \"s\"\n[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.1\nstiffness = "
      "1.0\n[forcing]\nfrequency = 2.0\n[[forcing.term]]\ndof = 0\ncos = 1.0\n[[contact]]\ndof = "
      "0\ngap = 0.2\npenalty = 100.0\ndamping = " +
          std::to_string(c) + "\n",
      "s.toml");
}

/// The flow of (u, xi, v) over one period of the load without contact.
Eigen::Matrix3d open_flow(double c, double frequency) {
  const double T = kTwoPi / frequency, a = 0.05, w = std::sqrt(1.0 - a * a);
  Eigen::Matrix3d flow = Eigen::Matrix3d::Zero();
  const double e = std::exp(-a * T), cosine = std::cos(w * T), sine = std::sin(w * T) / w;
  flow(0, 0) = e * (cosine + a * sine);
  flow(0, 2) = e * sine;
  flow(2, 0) = -e * sine;
  flow(2, 2) = e * (cosine - a * sine);
  flow(1, 1) = std::exp(-100.0 / c * T);
  return flow;
}

std::vector<double> sorted_magnitudes(const Eigen::VectorXcd& values) {
  std::vector<double> magnitudes;
  for (const std::complex<double>& mu : values) magnitudes.push_back(std::abs(mu));
  std::ranges::sort(magnitudes, std::greater<>());
  return magnitudes;
}

// The contact that begins takes a projection into the monodromy matrix, x' to 0 along what its force moves,
// however slow it is: (u, xi, v) -> (u, -u, v - c (u + xi) / m).
TEST(GrazingStarts, OfDampedStopsHaveMultipliersThatJump) {
  for (const double c : {0.2, 4.0}) {
    const OrbitDiagram diagram = diagram_of(before_damped_stop(c), 2.0, 2.6, {.max_order = 1});
    const OrbitBranch* pressed = branch_of(diagram, 1, 1);
    ASSERT_TRUE(pressed && pressed->points.size() > 2) << c;
    EXPECT_NEAR(pressed->points[0].parameter, kGrazing, kLocated);
    EXPECT_EQ(pressed->points[0].stability, OrbitStability::undefined);
    Eigen::Matrix3d projection = Eigen::Matrix3d::Identity();
    projection.row(1) << -1.0, 0.0, 0.0;
    projection.row(2) << -c, -c, 1.0;
    const std::vector<double> limit =
        sorted_magnitudes(general_eigenvalues(open_flow(c, kGrazing) * projection));
    const auto length = [&](std::size_t i) {
      return pressed->points[i].frequency *
             (pressed->orbits[i].events[1].time - pressed->orbits[i].events[0].time);
    };
    const std::vector<double> first = sorted_magnitudes(pressed->points[1].multipliers),
                              second = sorted_magnitudes(pressed->points[2].multipliers);
    for (std::size_t k = 0; k < limit.size(); ++k) {
      const double slope = (second[k] - first[k]) / (length(2) - length(1));
      EXPECT_NEAR(first[k] - slope * length(1), limit[k], 0.01 * std::max(1.0, limit[k]))
          << c << ": " << first[k];
    }
  }
}

struct DampedTruth {
  double c = 0.0, doubling = 0.0, doubling_of_two = 0.0, fold_of_two = 0.0;
};

// Located points by a march in closed form that shares no code with ours: there a multiplier of its
// differences is -1 or 1 to 1e-8.
TEST(GrazingStarts, LeadToTheDoublingsAndFoldsOfAnIndependentMarch) {
  for (const DampedTruth& truth : {DampedTruth{0.2, 2.206541578145, 2.783111077881, 3.497517925577},
                                   DampedTruth{4.0, 2.210293842030, 2.700299997069, 3.245076842734}}) {
    const ParametrisedScene scene = over_frequency(before_damped_stop(truth.c), 1.9, 3.6);
    const OrbitDiagram diagram = diagram_of(scene.at(2.0), 1.9, 3.6);
    const OrbitBranch *one = branch_of(diagram, 1, 1), *two = branch_of(diagram, 2, 1);
    ASSERT_TRUE(one && two) << truth.c;
    EXPECT_NEAR(nearest(*one, SpecialKind::period_doubling, truth.doubling), truth.doubling, kLocated);
    EXPECT_NEAR(nearest(*two, SpecialKind::period_doubling, truth.doubling_of_two), truth.doubling_of_two,
                kLocated);
    EXPECT_NEAR(nearest(*two, SpecialKind::fold, truth.fold_of_two), truth.fold_of_two, kLocated);
    for (const OrbitBranch& branch : diagram.branches) {
      EXPECT_GT(branch.points.size(), 2U) << branch.began;
      EXPECT_EQ(branch.ended.find("fails"), std::string::npos) << branch.ended;
    }
    for (std::size_t i = 1; i + 1 < two->points.size(); i += 4) {
      const ExactOrbit orbit = polished(scene, *two, i);
      if (orbit.outcome != OrbitOutcome::converged) continue;
      EXPECT_NEAR(largest_magnitude(orbit.multipliers.values), largest_magnitude(two->points[i].multipliers),
                  1e-6 * largest_magnitude(orbit.multipliers.values));
    }
  }
}

// The damper of the stop goes, and its curve to that of the spring, located by another program.
TEST(GrazingStarts, OfAStopWithoutADamperAreThoseOfItsSpring) {
  constexpr double kDoubling = 2.2062846538, kFold = 3.5167116923;
  double before = 1e300;
  for (const double c : {0.1, 0.01, 0.001}) {
    const OrbitDiagram diagram = diagram_of(before_damped_stop(c), 1.9, 4.0);
    const OrbitBranch *one = branch_of(diagram, 1, 1), *two = branch_of(diagram, 2, 1);
    ASSERT_TRUE(one && two) << c;
    const double apart = std::abs(nearest(*one, SpecialKind::period_doubling, kDoubling) - kDoubling) +
                         std::abs(nearest(*two, SpecialKind::fold, kFold) - kFold);
    EXPECT_LT(apart, 0.15 * before) << c;
    before = apart;
  }
  EXPECT_LT(before, 2e-4);
}

}  // namespace
}  // namespace signorini::grazing_starts_test
