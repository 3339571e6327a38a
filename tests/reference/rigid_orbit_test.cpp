// Rigid stops with restitution against exact orbits of one impact per period.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "tests/reference/reference_data.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::rigid_orbit_test {
namespace {

using test::ReferenceMotion;
using test::SingleImpactOrbit;
using test::solve;

// The closed-form orbit that the data describe.
SingleImpactOrbit orbit_of(const ReferenceMotion& motion) {
  const auto orbits =
      test::single_impact_orbits({.frequency = motion.omega, .gap = 1.0, .restitution = motion.restitution});
  return *std::min_element(orbits.begin(), orbits.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.impulse - motion.impulse) < std::abs(b.impulse - motion.impulse);
  });
}

Problem problem_of(const ReferenceMotion& motion) {
  return test::reference_oscillator(motion.omega, Restitution{motion.restitution});
}

// The exact orbit cut off at H, with the constant the method uses by default.
std::shared_ptr<const Trajectory> truncated(const SingleImpactOrbit& orbit, const Problem& problem,
                                            int harmonics) {
  const ProjectedLaw law = lipschitz_law(problem, std::nullopt, fourier_receptance(problem, harmonics));
  FourierTrajectory::Data data;
  data.period = orbit.period;
  data.x.resize(harmonics + 1, 1);
  data.lambda.resize(harmonics + 1, 1);
  for (int n = 0; n <= harmonics; ++n) {
    data.x(n, 0) = orbit.fourier(n);
    data.lambda(n, 0) = -orbit.impulse / orbit.period *
                        std::polar(1.0, -2.0 * std::numbers::pi * n * orbit.impact_time / orbit.period);
  }
  data.gap = contact_gaps(problem);
  data.stiffness = law.constant;
  data.multiplier_weight = law.multiplier_weight;
  return std::make_shared<FourierTrajectory>(std::move(data));
}

// The exact orbit at N nodes, its impulse on the nearest one.
std::shared_ptr<const Trajectory> nodal(const SingleImpactOrbit& orbit, int samples) {
  const double step = orbit.period / samples;
  Eigen::MatrixXd x(samples, 1);
  for (int i = 0; i < samples; ++i) x(i, 0) = orbit.x(i * step);
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(samples, 1);
  force(std::lround(orbit.impact_time / step) % samples, 0) = -orbit.impulse / step;
  return std::make_shared<NodalTrajectory>(orbit.period, std::move(x), std::move(force));
}

TEST(SingleImpactOrbit, MatchesTheIndependentShooting) {
  const auto motions = test::load_oscillator_motions("exact_sdof_rigid.json");
  ASSERT_EQ(motions.size(), 9U);
  for (const ReferenceMotion& motion : motions) {
    SCOPED_TRACE(testing::Message() << "restitution " << motion.restitution << ", omega " << motion.omega);
    const SingleImpactOrbit orbit = orbit_of(motion);
    EXPECT_NEAR(orbit.impact_time, motion.close, 1e-9 * orbit.period);
    EXPECT_NEAR(orbit.impulse, motion.impulse, 1e-9 * motion.impulse);
    Eigen::MatrixXcd x(motion.harmonics() + 1, 1);
    for (int n = 0; n <= motion.harmonics(); ++n) x(n, 0) = orbit.fourier(n);
    // 11 digits; the shooting's own quadrature of the coefficients is good to 5e-9.
    EXPECT_LE(test::relative_l2(x, motion.x, motion.harmonics()), 1e-8);
  }
}

TEST(FourierLipschitz, ApproachesTheExactOrbitsOfRestitutionOneAtFirstOrder) {
  int cases = 0;
  for (const ReferenceMotion& motion : test::load_oscillator_motions("exact_sdof_rigid.json")) {
    if (motion.restitution != 1.0) continue;
    ++cases;
    SCOPED_TRACE(testing::Message() << "omega " << motion.omega);
    const SingleImpactOrbit orbit = orbit_of(motion);
    const Problem problem = problem_of(motion);
    std::vector<double> steps, errors, impulse_errors, closed_errors;
    for (const int harmonics : {10, 20, 40, 80, 160}) {
      const auto guess = truncated(orbit, problem, harmonics);
      const FourierLipschitz::Options options{{.harmonics = harmonics, .samples = 32 * harmonics}};
      const Solution closed = solve<ClosedHbm>(problem, {.harmonics = harmonics}, guess);
      ASSERT_EQ(closed.verdict, Verdict::converged) << closed.message;
      closed_errors.push_back(test::relative_error(*closed.trajectory, [&](double t) { return orbit.x(t); }));
      const Solution solution = solve<FourierLipschitz>(problem, options, guess);
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      const auto& data = dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data();
      steps.push_back(1.0 / harmonics);
      errors.push_back(test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }));
      impulse_errors.push_back(std::abs(-orbit.period * data.lambda(0, 0).real() / orbit.impulse - 1.0));
    }
    EXPECT_GE(test::observed_order(steps, errors), 0.9);
    EXPECT_LE(test::observed_order(steps, errors), 1.1);
    EXPECT_GE(test::observed_order(steps, impulse_errors), 0.8);
    // Measured: 1.4e-3, 1.2e-2, 7.2e-3 and 1.8e-3, 2.5e-3, 4.2e-3.
    EXPECT_LE(errors.back(), 1.4e-2);
    EXPECT_LE(impulse_errors.back(), 5e-3);
    // With impacts closed: of the order of what the series cuts off.
    EXPECT_GE(test::observed_order(steps, closed_errors), 1.4);
    // Measured: 3.3e-4 at omega 0.9, 1.8e-4 at 1.3.
    EXPECT_LE(closed_errors.back(), 4e-4);
  }
  EXPECT_EQ(cases, 3);
}

TEST(HatLcp, ApproachesTheExactOrbitsOfAnyRestitutionAtFirstOrder) {
  for (const ReferenceMotion& motion : test::load_oscillator_motions("exact_sdof_rigid.json")) {
    SCOPED_TRACE(testing::Message() << "restitution " << motion.restitution << ", omega " << motion.omega);
    const SingleImpactOrbit orbit = orbit_of(motion);
    std::vector<double> steps, errors;
    for (const int samples : {64, 128, 256, 512, 1024}) {
      const Solution solution =
          solve<HatLcp>(problem_of(motion), {.samples = samples}, nodal(orbit, samples));
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      steps.push_back(orbit.period / samples);
      errors.push_back(test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }));
    }
    // The impact is rounded to a node: single levels scatter about first order.
    EXPECT_GE(test::observed_order(steps, errors), 0.85);
    EXPECT_LE(test::observed_order(steps, errors), 1.15);
    // Measured: at most 1.2e-2 (restitution 1, omega 0.9).
    EXPECT_LE(errors.back(), 1.3e-2);
  }
}

TEST(HatLcp, AColdStartFindsTheExactOrbitToo) {
  for (const ReferenceMotion& motion : test::load_oscillator_motions("exact_sdof_rigid.json")) {
    const SingleImpactOrbit orbit = orbit_of(motion);
    const Solution solution = solve<HatLcp>(problem_of(motion), {.samples = 512});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    // Measured: at most 2.4e-2.
    EXPECT_LE(test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }), 2.6e-2)
        << "restitution " << motion.restitution << ", omega " << motion.omega;
  }
}

}  // namespace
}  // namespace signorini::rigid_orbit_test
