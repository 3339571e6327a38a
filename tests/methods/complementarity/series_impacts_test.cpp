#include "methods/complementarity/series_impacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

/// A solution of the exactly projected equations and what its episodes need.
struct SolvedOscillator {
  explicit SolvedOscillator(const test::ImpactOscillator& oscillator, int harmonics)
      : problem(test::to_problem(oscillator)),
        receptance(fourier_receptance(problem, harmonics)),
        gap(contact_gaps(problem)),
        law(lipschitz_law(problem, {}, receptance)),
        response(fourier_receptance(problem, 2 * harmonics)) {
    const Solution solution =
        test::solve<FourierLipschitz>(problem, {{.harmonics = harmonics, .compensate = false}});
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    lambda = solution.trajectory->force_coefficients();
  }

  [[nodiscard]] ContactEpisodes episodes() const {
    return contact_episodes({receptance, gap, law}, response, lambda, {}, 16 * receptance.harmonics());
  }

  Problem problem;
  ContactReceptance receptance;
  Eigen::VectorXd gap;
  ProjectedLaw law;
  PeriodicGreenFunction response;
  Eigen::MatrixXcd lambda;
};

TEST(ContactEpisodes, FindTheOneImpactAndAllOfItsForce) {
  const SolvedOscillator solved({.damping = 0.1, .frequency = 2.2, .gap = 0.2}, 20);
  const ContactEpisodes found = solved.episodes();
  ASSERT_EQ(found.impacts.size(), 1U);
  EXPECT_TRUE(found.lasting.empty());
  EXPECT_EQ(found.lasting_force.norm(), 0.0);
  const ContactEpisode& impact = found.impacts.front();
  // The episode's part is the whole force, and its mean the zeroth coefficient of the pressure.
  EXPECT_LE((impact.lambda - solved.lambda.col(0)).norm(), 1e-8 * solved.lambda.norm());
  EXPECT_NEAR(impact.force, -solved.lambda(0, 0).real(), 1e-8 * impact.force);
  EXPECT_LE(impact.width(), 2.5 / 20);
  EXPECT_GT(impact.load.value, 0.0);
  // Root mean square of x over the period, from samples.
  const Eigen::MatrixXcd x = contact_motion(solved.receptance, solved.lambda);
  const double expected = std::sqrt(std::norm(x(0, 0)) + 2.0 * x.col(0).tail(x.rows() - 1).squaredNorm());
  EXPECT_DOUBLE_EQ(found.motion, expected);
}

TEST(ContactEpisodes, CallContactThatLastsNoImpact) {
  const SolvedOscillator solved({.damping = 0.1, .frequency = 0.6, .gap = -1.5}, 20);
  const ContactEpisodes found = solved.episodes();
  EXPECT_TRUE(found.impacts.empty());
  ASSERT_EQ(found.lasting.size(), 1U);
  EXPECT_LE((found.lasting_force - solved.lambda).norm(), 1e-9 * solved.lambda.norm());
  EXPECT_FALSE(found.lasting_is_shifted);
}

TEST(AugmentedMultiplier, IsThePressureInContactAndNegativeOffIt) {
  const SolvedOscillator solved({.damping = 0.1, .frequency = 0.6, .gap = -1.5}, 20);
  const ProjectedEquations equations{solved.receptance, solved.gap, solved.law};
  const Eigen::MatrixXcd x = contact_motion(solved.receptance, solved.lambda);
  const Eigen::VectorXcd y = augmented_multiplier(equations, 0, x, solved.lambda);
  // Closed throughout: x = g and y = -lambda.
  EXPECT_LE((y + solved.lambda.col(0)).norm(), 1e-8 * solved.lambda.norm());
}

/// The equations of one oscillator with its impacts at one contact, nothing else touching.
class OscillatorImpacts {
 public:
  OscillatorImpacts(const test::ImpactOscillator& oscillator, int impacts)
      : problem_(test::to_problem(oscillator)),
        receptance_(fourier_receptance(problem_, 40)),
        response_(fourier_receptance(problem_, 400)),
        gap_(contact_gaps(problem_)),
        episodes_(static_cast<std::size_t>(impacts)) {}

  [[nodiscard]] ImpactEquations equations() const {
    return {response_, gap_, episodes_, receptance_.free_response};
  }

 private:
  Problem problem_;
  ContactReceptance receptance_;
  PeriodicGreenFunction response_;
  Eigen::VectorXd gap_;
  std::vector<ContactEpisode> episodes_;
};

Impacts some(std::initializer_list<double> time, std::initializer_list<double> force) {
  const auto count = static_cast<Eigen::Index>(time.size());
  Impacts impacts(2, count);
  impacts.row(0) = Eigen::Map<const Eigen::RowVectorXd>(time.begin(), count);
  impacts.row(1) = Eigen::Map<const Eigen::RowVectorXd>(force.begin(), count);
  return impacts;
}

// The closed form of the orbit with one impact per period knows instant and impulse.
TEST(ImpactEquations, HoldAtTheClosedFormOrbit) {
  const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2};
  const OscillatorImpacts impacts(oscillator, 1);
  const ImpactEquations equations = impacts.equations();
  const auto orbits = test::single_impact_orbits(oscillator);
  ASSERT_FALSE(orbits.empty());
  for (const auto& orbit : orbits) {
    // Newton comes back to it from a disturbed one.
    const std::optional<Impacts> found = equations.solve(
        some({orbit.impact_time / orbit.period + 1e-3}, {0.98 * orbit.impulse / orbit.period}), 1e-12, 1e-9);
    ASSERT_TRUE(found);
    EXPECT_NEAR((*found)(1, 0) * orbit.period, orbit.impulse, 1e-6 * orbit.impulse);
    EXPECT_NEAR((*found)(0, 0), orbit.impact_time / orbit.period, 1e-6);
  }
}

// The motion of the closed form reaches its own stop and passes one that stands nearer by just the
// difference.
TEST(ImpactEquations, TellHowFarTheMotionPassesTheStop) {
  test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2};
  const auto orbit = test::single_impact_orbits(oscillator).front();
  const Impacts impact = some({orbit.impact_time / orbit.period}, {orbit.impulse / orbit.period});
  const int instants = 4096;
  const double between = orbit.approach * orbit.period / instants;
  EXPECT_LE(OscillatorImpacts(oscillator, 1).equations().penetration(impact, 0, instants), 1e-6);
  oscillator.gap -= 0.05;
  EXPECT_NEAR(OscillatorImpacts(oscillator, 1).equations().penetration(impact, 0, instants), 0.05, between);
}

TEST(ImpactEquations, JacobianIsTheDifferenceQuotient) {
  const OscillatorImpacts impacts({.damping = 0.2, .frequency = 1.1, .gap = 0.2}, 2);
  const ImpactEquations equations = impacts.equations();
  const Impacts at = some({0.2, 0.7}, {0.3, 0.5});
  const Eigen::MatrixXd jacobian = equations.jacobian(at);
  constexpr double kStep = 1e-6;
  for (Eigen::Index column = 0; column < 4; ++column) {
    const auto moved = [&](double by) {
      Impacts other = at;
      other(column % 2, column / 2) += by;
      return equations.residual(other);
    };
    const Eigen::VectorXd difference = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
    EXPECT_LE((jacobian.col(column) - difference).norm(), 1e-6 * (1.0 + difference.norm())) << column;
  }
}

TEST(ImpactEquations, HaveNoSolutionThatPulls) {
  // A gap beyond the free motion: only a pull would bring the mass there.
  const OscillatorImpacts impacts({.damping = 0.3, .frequency = 2.2, .gap = 5.0}, 1);
  EXPECT_FALSE(impacts.equations().solve(some({0.1}, {0.1}), 1e-12, 1e-9));
}

TEST(ImpactEquations, AreEmptyWithoutImpacts) {
  const OscillatorImpacts impacts({.damping = 0.3, .frequency = 2.2, .gap = 5.0}, 0);
  const std::optional<Impacts> found = impacts.equations().solve({}, 1e-12, 1e-9);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->cols(), 0);
}

}  // namespace
}  // namespace signorini
