// What the families of `hard` claim of their scenes, by closed forms; and scenes from elsewhere by their
// numbers.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

using test::ImpactOscillator;
using test::SingleImpactOrbit;

Problem shipped(const std::string& name) { return load_scene(find_scene(name)); }

std::vector<Problem> levels_of(const std::string& family) {
  std::vector<Problem> scenes;
  const auto file = problems_folder() / "families" / (family + ".toml");
  for (const std::string& level : load_levels(file)) scenes.push_back(load_scene({file, level}));
  return scenes;
}

// The closed form's own parameters, one impact in `order` forcing periods.
ImpactOscillator oscillator_of(const Problem& problem, int order) {
  return {.mass = problem.mass().coeff(0, 0),
          .damping = problem.damping().coeff(0, 0),
          .stiffness = problem.stiffness().coeff(0, 0),
          .load = problem.force.front().cos,
          .frequency = problem.frequency,
          .gap = problem.contacts.front().gap,
          .restitution = std::get<Restitution>(problem.law).e,
          .order = order};
}

bool any_stable(const std::vector<SingleImpactOrbit>& orbits) {
  return std::ranges::any_of(orbits, [](const SingleImpactOrbit& orbit) { return orbit.stable(); });
}

TEST(HardFamilies, PeriodDoublingIsPastTheStableMotionOfOnePeriod) {
  for (const Problem& problem : levels_of("period-doubling")) {
    SCOPED_TRACE(problem.name);
    EXPECT_EQ(problem.subharmonic, 2);
    ImpactOscillator oscillator = oscillator_of(problem, 1);
    const auto orbits = single_impact_orbits(oscillator);
    ASSERT_FALSE(orbits.empty());
    EXPECT_FALSE(any_stable(orbits));
    EXPECT_LT(orbits.front().trace, -(1.0 + orbits.front().determinant));
    oscillator.frequency = 2.6587;  // short of the doubling
    EXPECT_TRUE(any_stable(single_impact_orbits(oscillator)));
  }
}

TEST(HardFamilies, ChaosHasAnUnstableMotionOfOnePeriod) {
  for (const Problem& problem : levels_of("chaos")) {
    SCOPED_TRACE(problem.name);
    const auto orbits = single_impact_orbits(oscillator_of(problem, 1));
    ASSERT_FALSE(orbits.empty());
    EXPECT_FALSE(any_stable(orbits));
    EXPECT_FALSE(any_stable(single_impact_orbits(oscillator_of(problem, 2))));
  }
}

TEST(HardFamilies, IsolatedBranchEndsAtItsFold) {
  for (const Problem& problem : levels_of("isolated-branch")) {
    SCOPED_TRACE(problem.name);
    EXPECT_EQ(problem.subharmonic, 3);
    ImpactOscillator oscillator = oscillator_of(problem, 3);
    EXPECT_FALSE(single_impact_orbits(oscillator).empty());
    EXPECT_GT(oscillator.gap, 1.0 / (oscillator.frequency * oscillator.frequency - 1.0))
        << "the motion without contact exists too";
    oscillator.frequency = 5.2763;
    EXPECT_TRUE(single_impact_orbits(oscillator).empty()) << "beyond the fold";
  }
}

TEST(HardFamilies, InternalResonanceIsTunedToThreeTimesTheFirstMode) {
  const std::vector<double> detuning{0.1, 0.03, 0.01, 0.001, 0.0};
  const std::vector<Problem> scenes = levels_of("internal-resonance");
  ASSERT_EQ(scenes.size(), detuning.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
        Eigen::MatrixXd(scenes[i].stiffness()), Eigen::MatrixXd(scenes[i].mass()), Eigen::EigenvaluesOnly);
    EXPECT_NEAR(std::sqrt(modes.eigenvalues()[0]), 1.0, 1e-9);
    EXPECT_NEAR(std::sqrt(modes.eigenvalues()[1]), 3.0 * (1.0 + detuning[i]), 1e-9);
  }
}

TEST(PublishedScenes, CocosImpactOscillatorHasItsImpact) {
  const Solution solution = test::solve<ExactOrbitMethod>(shipped("sdof-coco-impact"), {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const std::vector<Impulse> impulses = solution.trajectory->impulses();
  ASSERT_EQ(impulses.size(), 1U);
  EXPECT_NEAR(impulses[0].time, 0.075952164938, 1e-11);
  EXPECT_NEAR(impulses[0].value, -1.8 * 1.695732937595, 1e-11);
}

// Its grazing at A = 0.1 and its fold at A = 0.0999707536.
TEST(PublishedScenes, CocosImpactOscillatorHasItsFold) {
  ImpactOscillator oscillator = oscillator_of(shipped("sdof-coco-impact"), 1);
  for (const auto& [load, count] :
       {std::pair(0.09997075, 0U), std::pair(0.09997076, 2U), std::pair(0.101, 1U)}) {
    oscillator.load = load;
    EXPECT_EQ(single_impact_orbits(oscillator).size(), count) << load;
  }
}

// The published equation, at every instant of the motion found.
TEST(PublishedScenes, PermasOneSidedSpringObeysItsEquation) {
  const Problem problem = shipped("sdof-permas-039");
  EXPECT_EQ(std::get<Penalty>(problem.law).stiffness, std::vector<double>{15.0});
  const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  // The equation of motion as published, by differences.
  constexpr int kInstants = 20000;
  const Eigen::VectorXd x = solution.trajectory->sample(kInstants).x.col(0);
  const double step = solution.trajectory->period() / kInstants;
  double worst = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const double before = x[(i + kInstants - 1) % kInstants], after = x[(i + 1) % kInstants];
    const double residual = (after - 2.0 * x[i] + before) / (step * step) +
                            0.25 * (after - before) / (2.0 * step) + x[i] + 15.0 * std::max(0.0, x[i]) -
                            std::cos(2.6 * i * step);
    worst = std::max(worst, std::abs(residual));
  }
  EXPECT_LT(worst, 1e-3) << "the force has kinks, where differences err by a slope times a step";
}

}  // namespace
}  // namespace signorini
