#include "methods/complementarity/exact_projection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "methods/complementarity/exact_quadrature.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::exact_projection_test {
namespace {

using Complex = std::complex<double>;

/// A mass pressed against a spring stop by a steady load and shaken so that it leaves it once per period.
struct ShakenMass {
  ShakenMass(int harmonics, double stop)
      : problem(test::to_problem({.damping = 0.4, .frequency = 0.7, .gap = 0.0})),
        receptance(fourier_receptance(problem, harmonics)),
        gap(contact_gaps(problem)),
        law{Eigen::VectorXd::Constant(1, stop), Eigen::VectorXd::Zero(1)} {}

  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
  [[nodiscard]] ExactProjectionSettings settings() const {
    return {.samples = 16 * receptance.harmonics(), .tolerance = 1e-11};
  }

  Problem problem;
  ContactReceptance receptance;
  Eigen::VectorXd gap;
  ProjectedLaw law;
};

double value(const Eigen::VectorXcd& y, double t) {
  double sum = y[0].real();
  for (int n = 1; n < y.size(); ++n)
    sum += 2.0 * (y[n] * std::polar(1.0, 2.0 * std::numbers::pi * n * t)).real();
  return sum;
}

TEST(ProjectExactly, SolvesTheProjectedEquationsAsAFineSumSeesThem) {
  const ShakenMass mass(6, 3.0);
  const ExactProjection solved =
      project_exactly(mass.equations(), Eigen::MatrixXcd::Zero(7, 1), mass.settings());
  ASSERT_TRUE(solved.converged) << solved.residual;
  EXPECT_LE(solved.iterations, 8);
  EXPECT_GE(solved.condition.value(), 1.0);
  Eigen::VectorXcd y = 3.0 * contact_motion(mass.receptance, solved.lambda).col(0);
  constexpr int kSamples = 100000;
  for (int n = 0; n <= 6; ++n) {
    Complex pressed = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      pressed += std::max(0.0, value(y, t)) * std::polar(1.0 / kSamples, -2.0 * std::numbers::pi * n * t);
    }
    EXPECT_LE(std::abs(solved.lambda(n, 0) + pressed), 1e-7) << n;
  }
}

TEST(ProjectExactly, DoesNoNetWork) {
  const ShakenMass mass(12, 3.0);
  const ExactProjection solved =
      project_exactly(mass.equations(), Eigen::MatrixXcd::Zero(13, 1), mass.settings());
  ASSERT_TRUE(solved.converged);
  const Eigen::MatrixXcd x = contact_motion(mass.receptance, solved.lambda);
  double net = 0.0;
  double size = 0.0;
  for (int n = 1; n <= 12; ++n) {
    net += n * (std::conj(x(n, 0)) * solved.lambda(n, 0)).imag();
    size += n * std::abs(x(n, 0) * solved.lambda(n, 0));
  }
  EXPECT_LE(std::abs(net), 1e-10 * size);
}

TEST(ProjectExactly, TakesNoStepFromItsOwnSolution) {
  const ShakenMass mass(12, 3.0);
  const ExactProjection solved =
      project_exactly(mass.equations(), Eigen::MatrixXcd::Zero(13, 1), mass.settings());
  const ExactProjection again = project_exactly(mass.equations(), solved.lambda, mass.settings());
  EXPECT_TRUE(again.converged);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_FALSE(again.condition);
}

TEST(ProjectExactly, AgreesWhetherItFactorisesOrIterates) {
  // 2 H + 1 unknowns: 49 are factorised, 161 solved by GMRES; the latter's first harmonics are those of the
  // former up to truncation.
  const ShakenMass few(24, 3.0);
  const ShakenMass many(80, 3.0);
  const ExactProjection coarse =
      project_exactly(few.equations(), Eigen::MatrixXcd::Zero(25, 1), few.settings());
  const ExactProjection fine =
      project_exactly(many.equations(), Eigen::MatrixXcd::Zero(81, 1), many.settings());
  ASSERT_TRUE(coarse.converged && fine.converged);
  EXPECT_LE((coarse.lambda.topRows(6) - fine.lambda.topRows(6)).norm(), 1e-4 * fine.lambda.norm());
}

TEST(ProjectExactly, MovesTheSpringWithItsStop) {
  // A stop that stands nearer by d is a gap that is smaller by d.
  const ShakenMass mass(6, 3.0);
  ShakenMass nearer = mass;
  nearer.gap[0] -= 0.05;
  const StopShifts shifts{{{.time = 0.0, .width = 0.5, .distance = 0.05, .speed = 0.0}}};
  const Eigen::MatrixXcd cold = Eigen::MatrixXcd::Zero(7, 1);
  const ExactProjection shifted = project_exactly(mass.equations(), cold, mass.settings(), shifts);
  const ExactProjection moved = project_exactly(nearer.equations(), cold, nearer.settings());
  ASSERT_TRUE(shifted.converged && moved.converged);
  EXPECT_LE((shifted.lambda - moved.lambda).norm(), 1e-9 * moved.lambda.norm());
}

TEST(ProjectExactly, EndsWithItsTimeBudget) {
  const ShakenMass mass(6, 3.0);
  ExactProjectionSettings late = mass.settings();
  late.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  const ExactProjection solved = project_exactly(mass.equations(), Eigen::MatrixXcd::Zero(7, 1), late);
  EXPECT_FALSE(solved.converged);
  EXPECT_EQ(solved.iterations, 0);
}

// A mass pressed against its stop harder than the load can pull.
const test::ImpactOscillator kPressed{.damping = 0.1, .frequency = 0.6, .gap = -1.5, .restitution = 0.0};

ProjectedLaw rigid(double constant) {
  return {Eigen::VectorXd::Constant(1, constant), Eigen::VectorXd::Ones(1)};
}

ExactProjection solve_with_gap(double gap, const ProjectedLaw& law) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kPressed), 3);
  const Eigen::VectorXd gaps = Eigen::VectorXd::Constant(1, gap);
  return solve_permanent_contact({receptance, gaps, law}, 1e-10);
}

TEST(PermanentContact, TakesTheStaticForceAndTheLoadWhateverTheConstant) {
  for (const double constant : {0.1, 1.0, 1e4}) {
    const ExactProjection closed = solve_with_gap(kPressed.gap, rigid(constant));
    ASSERT_TRUE(closed.converged);
    EXPECT_EQ(closed.iterations, 0);
    // lambda = k g - cos(omega t).
    EXPECT_NEAR(std::abs(closed.lambda(0, 0) + 1.5), 0.0, 1e-13);
    EXPECT_NEAR(std::abs(closed.lambda(1, 0) + 0.5), 0.0, 1e-13);
    EXPECT_LE(closed.lambda.bottomRows(2).norm(), 1e-12);
  }
}

TEST(PermanentContact, OfASpringStopIsTheMassOnTwoSprings) {
  // -lambda = k_p (x - g), (k + k_p) x_0 = k_p g, and in harmonic 1 x_1 = f_1 / (k + k_p - w^2 + i d w).
  constexpr double kStop = 300.0;
  const ProjectedLaw spring{Eigen::VectorXd::Constant(1, kStop), Eigen::VectorXd::Zero(1)};
  const ExactProjection closed = solve_with_gap(kPressed.gap, spring);
  ASSERT_TRUE(closed.converged);
  const double mean = kStop * kPressed.gap / (1.0 + kStop);
  EXPECT_NEAR(closed.lambda(0, 0).real(), -kStop * (mean - kPressed.gap), 1e-11);
  const ContactReceptance receptance = fourier_receptance(test::to_problem(kPressed), 3);
  const std::complex<double> stiffness = 1.0 / receptance.receptance[1](0, 0);
  const std::complex<double> x = receptance.free_response(1, 0) * stiffness / (stiffness + kStop);
  EXPECT_LE(std::abs(closed.lambda(1, 0) + kStop * x), 1e-11);
}

TEST(PermanentContact, IsRefusedWhereTheLoadPullsTheMassAway) {
  EXPECT_FALSE(solve_with_gap(-0.9, rigid(1.0)).converged);
  EXPECT_FALSE(solve_with_gap(0.5, rigid(1.0)).converged);
}

}  // namespace
}  // namespace signorini::exact_projection_test
