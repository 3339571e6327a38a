// Series behind impacts of any restitution, judged by closed-form orbits.

#include "methods/complementarity/impact_closure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "methods/discretisation/trajectories.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/structure/receptance.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::impact_closure_test {
namespace {

using test::ImpactOscillator;
using test::SingleImpactOrbit;

/// A one-impact scene with the series of H harmonics behind its orbit.
struct ClosedScene {
  ClosedScene(const ImpactOscillator& oscillator, int harmonics, double stiffness)
      : orbit(test::single_impact_orbits(oscillator).front()),
        problem(test::to_problem(oscillator)),
        receptance(fourier_receptance(problem, harmonics)),
        gap(contact_gaps(problem)),
        law(with_stiffness(stiffness)),
        impacts{{0}, Eigen::Matrix2Xd(2, 1)} {
    const ContactReceptance response = fourier_receptance(problem, std::max(2 * harmonics, 256));
    const ImpactMotion motion(response, receptance.free_response, gap, oscillator.restitution);
    impacts.moments << orbit.impact_time / orbit.period, orbit.impulse / orbit.period;
    impacts = motion.settle(impacts, 1e-13).value().impacts;
    closure = close_impacts({receptance, gap, law}, impacts, {.samples = 16 * harmonics});
  }

  [[nodiscard]] ProjectedLaw with_stiffness(double stiffness) const {
    const ProjectedLaw lipschitz = lipschitz_law(problem, {}, receptance);
    return {stiffness * lipschitz.constant, lipschitz.multiplier_weight};
  }

  /// Error of x over what H harmonics cut off of the orbit, both in the mean square.
  [[nodiscard]] double error_over_cut() const {
    double beyond = 0.0;
    for (int n = receptance.harmonics() + 1; n <= 40000; ++n) beyond += 2.0 * std::norm(orbit.fourier(n));
    return std::sqrt(1.0 + within() / beyond);
  }
  /// Relative error of x in the mean square.
  [[nodiscard]] double error() const {
    double beyond = 0.0;
    double all = 0.0;
    for (int n = -40000; n <= 40000; ++n) {
      const double square = std::norm(orbit.fourier(n));
      all += square;
      if (std::abs(n) > receptance.harmonics()) beyond += square;
    }
    return std::sqrt((beyond + within()) / all);
  }
  /// Work of the contact force on the series over a period [J].
  [[nodiscard]] double work() const {
    const Eigen::MatrixXcd x = contact_motion(receptance, closure.lambda);
    double sum = 0.0;
    for (int n = 1; n < x.rows(); ++n)
      sum += 2.0 * (std::conj(closure.lambda(n, 0)) * std::complex<double>(0.0, n) * x(n, 0)).real();
    return 2.0 * M_PI * sum;
  }

  SingleImpactOrbit orbit;
  Problem problem;
  ContactReceptance receptance;
  Eigen::VectorXd gap;
  ProjectedLaw law;
  PeriodicImpacts impacts;
  ImpactClosure closure;

 private:
  [[nodiscard]] double within() const {
    const Eigen::MatrixXcd x = contact_motion(receptance, closure.lambda);
    double sum = 0.0;
    for (int n = 0; n < x.rows(); ++n) sum += (n == 0 ? 1.0 : 2.0) * std::norm(x(n, 0) - orbit.fourier(n));
    return sum;
  }
};

ImpactOscillator oscillator(double restitution) {
  return {.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = restitution};
}

class ImpactClosureAt : public testing::TestWithParam<double> {};

TEST_P(ImpactClosureAt, LeavesWhatTheSeriesCutsOff) {
  for (const int harmonics : {10, 40}) {
    SCOPED_TRACE(testing::Message() << "H = " << harmonics);
    const ClosedScene soft(oscillator(GetParam()), harmonics, 1.0);
    ASSERT_TRUE(soft.closure.converged) << soft.closure.failure;
    EXPECT_LE(soft.error_over_cut(), 1.06);
    const ClosedScene hard(oscillator(GetParam()), harmonics, 8.0);
    ASSERT_TRUE(hard.closure.converged) << hard.closure.failure;
    EXPECT_LE(hard.error_over_cut(), 1.01);
  }
}

TEST_P(ImpactClosureAt, FallsAsTheBestSeriesDoes) {
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int harmonics : {10, 20, 40, 80}) {
    const ClosedScene scene(oscillator(GetParam()), harmonics, 8.0);
    ASSERT_TRUE(scene.closure.converged) << scene.closure.failure;
    steps.push_back(1.0 / harmonics);
    errors.push_back(scene.error());
  }
  EXPECT_NEAR(test::observed_order(steps, errors), 1.5, 0.1);
}

TEST_P(ImpactClosureAt, TakesAsManyStepsWhateverTheHarmonics) {
  for (const int harmonics : {20, 80, 320, 1280}) {
    SCOPED_TRACE(testing::Message() << "H = " << harmonics);
    for (const double stiffness : {1.0, 8.0}) {
      const ClosedScene scene(oscillator(GetParam()), harmonics, stiffness);
      EXPECT_TRUE(scene.closure.converged) << scene.closure.failure << ' ' << scene.closure.residual;
      EXPECT_LE(scene.closure.steps, 8);
    }
  }
}

TEST_P(ImpactClosureAt, DoesTheWorkOfTheMovedStopsThatTendsToTheLaws) {
  // Exactly b J, whatever H; and -kappa J^2 = -(1 - e) J^2 / (2 (1 + e) m) in the limit.
  const double restitution = GetParam();
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int harmonics : {40, 80, 160, 320}) {
    const ClosedScene scene(oscillator(restitution), harmonics, 1.0);
    ASSERT_TRUE(scene.closure.converged) << scene.closure.failure;
    const double force = scene.impacts.moments(1, 0);
    const double impulse = force * scene.orbit.period;
    EXPECT_NEAR(scene.work(), scene.closure.shifts[0][0].speed * force, 1e-9);
    const double law = -(1.0 - restitution) / (2.0 * (1.0 + restitution)) * impulse * impulse;
    steps.push_back(1.0 / harmonics);
    errors.push_back(std::abs(scene.work() - law));
  }
  const double order = test::observed_order(steps, errors);
  EXPECT_GE(order, 0.85);
  EXPECT_LE(order, 1.15);
}

TEST_P(ImpactClosureAt, HasTheImpulseAndTheCentreOfTheImpact) {
  const ClosedScene scene(oscillator(GetParam()), 20, 1.0);
  ASSERT_TRUE(scene.closure.converged) << scene.closure.failure;
  EXPECT_NEAR(-scene.closure.lambda(0, 0).real(), scene.impacts.moments(1, 0), 1e-11);
  // The phase of the first harmonic is that of the centre, but for the skew of the contact.
  const std::complex<double> first =
      -scene.closure.lambda(1, 0) * std::polar(1.0, 2.0 * M_PI * scene.impacts.moments(0, 0));
  EXPECT_NEAR(std::arg(first), 0.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(OneMass, ImpactClosureAt, testing::Values(1.0, 0.9, 0.8, 0.5, 0.2, 0.0));

// One step of the shift iteration that this replaced lost the impact here.
TEST(ImpactClosure, IsLocalAndKnowsNoResonance) {
  for (const ImpactOscillator& scene :
       {ImpactOscillator{.damping = 0.012, .frequency = 1.98, .gap = 0.13, .restitution = 0.9},
        ImpactOscillator{.damping = 0.05, .frequency = 0.78, .gap = 0.5, .restitution = 0.34}}) {
    if (test::single_impact_orbits(scene).empty()) continue;
    const ClosedScene closed(scene, 20, 8.0);
    EXPECT_TRUE(closed.closure.converged) << closed.closure.failure;
    EXPECT_LE(closed.closure.steps, 8);
  }
}

TEST(ImpactClosure, RefusesTwoImpactsThatTheSeriesCannotTellApart) {
  const ClosedScene scene(oscillator(0.5), 20, 1.0);
  PeriodicImpacts twice{{0, 0}, Eigen::Matrix2Xd(2, 2)};
  twice.moments << scene.impacts.moments(0, 0), scene.impacts.moments(0, 0) + 0.2 / 20,
      scene.impacts.moments(1, 0), scene.impacts.moments(1, 0);
  const ImpactClosure closure =
      close_impacts({scene.receptance, scene.gap, scene.law}, twice, {.samples = 320});
  EXPECT_FALSE(closure.converged);
  EXPECT_FALSE(closure.failure.empty());
}

}  // namespace
}  // namespace signorini::impact_closure_test
