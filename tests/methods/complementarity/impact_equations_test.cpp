#include "methods/complementarity/impact_equations.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <vector>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

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
  return {Eigen::Map<const Eigen::VectorXd>(time.begin(), count),
          Eigen::Map<const Eigen::VectorXd>(force.begin(), count)};
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
    EXPECT_NEAR(found->force[0] * orbit.period, orbit.impulse, 1e-6 * orbit.impulse);
    EXPECT_NEAR(found->time[0], orbit.impact_time / orbit.period, 1e-6);
  }
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
      (column % 2 == 0 ? other.time : other.force)[column / 2] += by;
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
  EXPECT_EQ(found->time.size(), 0);
}

}  // namespace
}  // namespace signorini
