// Penalty harmonic balance against exact orbits of the oscillator with a spring stop.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/reference/bilinear_orbit.hpp"
#include "tests/reference/reference_data.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::penalty_orbit_test {
namespace {

using test::BilinearOrbit;
using test::ReferenceMotion;
using test::solve;

// Harmonics beyond this one carry less than 1e-9 of the softest orbit and 1e-6 of the stiffest.
constexpr int kTail = 2000;

Eigen::MatrixXcd spectrum_of(const BilinearOrbit& orbit, int harmonics) {
  Eigen::MatrixXcd x(harmonics + 1, 1);
  for (int n = 0; n <= harmonics; ++n) x(n, 0) = orbit.fourier(n);
  return x;
}

// The closed form, started at the switching times found in the data.
BilinearOrbit orbit_of(const ReferenceMotion& motion) {
  const double period = 2.0 * std::numbers::pi / motion.omega;
  const double open = motion.open > motion.close ? motion.open : motion.open + period;
  std::complex<double> velocity = 0.0;
  for (int n = 1; n <= motion.harmonics(); ++n) {
    velocity += 2.0 * std::complex<double>(0.0, n * motion.omega) * motion.x(n, 0) *
                std::polar(1.0, n * motion.omega * motion.close);
  }
  return test::bilinear_orbit({.frequency = motion.omega, .gap = 1.0}, motion.stiffness, motion.close, open,
                              velocity.real());
}

// Relative L2 errors of the whole motion at each H, on the branch of the exact orbit.
std::vector<double> errors_of(const ReferenceMotion& motion, const std::vector<int>& levels) {
  const Problem problem = test::reference_oscillator(motion.omega, Penalty{{motion.stiffness}});
  const Eigen::MatrixXcd exact = spectrum_of(orbit_of(motion), kTail);
  std::vector<double> errors;
  for (const int harmonics : levels) {
    const Solution solution =
        solve<PenaltyHbm>(problem, {{.harmonics = harmonics}}, test::start_from(motion, problem));
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    errors.push_back(test::relative_l2(test::coefficients_of(solution), exact, kTail));
  }
  return errors;
}

std::vector<double> steps_of(const std::vector<int>& levels) {
  std::vector<double> steps;
  for (const int harmonics : levels) steps.push_back(1.0 / harmonics);
  return steps;
}

TEST(BilinearOrbit, MatchesTheIndependentShooting) {
  for (const ReferenceMotion& motion : test::load_oscillator_motions("exact_sdof_penalty.json")) {
    SCOPED_TRACE(testing::Message() << "stiffness " << motion.stiffness << ", omega " << motion.omega);
    const BilinearOrbit orbit = orbit_of(motion);
    const double period = orbit.period();
    EXPECT_LE(std::abs(std::remainder(orbit.close - motion.close, period)), 1e-9 * period);
    EXPECT_LE(std::abs(std::remainder(orbit.open - motion.open, period)), 1e-9 * period);
    // The data carry 11 digits.
    EXPECT_LE(test::relative_l2(spectrum_of(orbit, 60), motion.x, 60), 1e-9);
  }
}

TEST(PenaltyHbm, ErrorAtFortyHarmonicsIsWhatTheStiffnessAllows) {
  const struct {
    double stiffness;
    double bound;  // relative L2, a tenth above the worst of the three frequencies measured
  } levels[] = {{1e2, 1.1e-4}, {1e3, 4.2e-3}, {1e4, 1.8e-2}, {1e5, 2.7e-2}, {1e6, 3.2e-2}};
  int cases = 0;
  for (const ReferenceMotion& motion : test::load_oscillator_motions("exact_sdof_penalty.json")) {
    for (const auto& [stiffness, bound] : levels) {
      if (stiffness != motion.stiffness) continue;
      ++cases;
      EXPECT_LE(errors_of(motion, {40}).front(), bound)
          << "stiffness " << motion.stiffness << ", omega " << motion.omega;
    }
  }
  EXPECT_EQ(cases, 15);
}

// Below the frequency w2 of the mass on the stop, the stop is as good as rigid: error ~ 1 / H.
TEST(PenaltyHbm, ConvergesAtFirstOrderBelowTheFrequencyOfContact) {
  const std::vector<int> levels{5, 10, 20, 40};
  int cases = 0;
  for (const ReferenceMotion& motion : test::load_oscillator_motions("exact_sdof_penalty.json")) {
    if (std::sqrt(motion.stiffness) / motion.omega < 5.0 * levels.back()) continue;
    ++cases;
    const double order = test::observed_order(steps_of(levels), errors_of(motion, levels));
    EXPECT_GE(order, 0.9) << "stiffness " << motion.stiffness << ", omega " << motion.omega;
    EXPECT_LE(order, 1.25) << "stiffness " << motion.stiffness << ", omega " << motion.omega;
  }
  EXPECT_GE(cases, 5);
}

// Above it the solution is C^2 with a jump in x''': coefficients ~ n^-4, error ~ H^-7/2.
TEST(PenaltyHbm, ConvergesAtOrderThreeAndAHalfAboveTheFrequencyOfContact) {
  const std::vector<int> levels{30, 45, 60, 90, 120};
  int cases = 0;
  for (const ReferenceMotion& motion : test::load_oscillator_motions("exact_sdof_penalty.json")) {
    if (std::sqrt(motion.stiffness) / motion.omega > 0.5 * levels.front()) continue;
    ++cases;
    const double order = test::observed_order(steps_of(levels), errors_of(motion, levels));
    RecordProperty("order_" + std::to_string(cases), std::to_string(order));
    EXPECT_GE(order, 3.2) << "omega " << motion.omega;
    EXPECT_LE(order, 4.3) << "omega " << motion.omega;
  }
  EXPECT_EQ(cases, 2);
}

// The oscillator of tests/support at w = 2.2, g = 0.2, on a stop a hundred times its stiffness.
class SoftStop : public testing::Test {
 protected:
  const test::SingleImpactOrbit rigid_ =
      test::single_impact_orbits({.damping = 0.1, .frequency = 2.2, .gap = 0.2}).front();
  const BilinearOrbit orbit_ = test::bilinear_orbit_of(rigid_, 100.0);
  const Eigen::MatrixXcd exact_ = spectrum_of(orbit_, kTail);
  const double rms_ = test::relative_l2(Eigen::MatrixXcd::Zero(1, 1), exact_, kTail) *
                      std::sqrt(exact_.row(0).squaredNorm() + 2.0 * exact_.bottomRows(kTail).squaredNorm());
  Problem problem_ = [] {
    Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
    problem.set_law(Penalty{{100.0}});
    return problem;
  }();
};

TEST_F(SoftStop, RootMeanSquareErrorIsTheKnownOne) {
  const struct {
    int harmonics;
    double error;  // rms of x - exact [m]; sampled at N = 1024 the first was known as 1.31e-5 before
  } levels[] = {{20, 1.340e-5}, {40, 8.75e-7}, {80, 8.55e-8}};
  for (const auto& [harmonics, error] : levels) {
    const Solution solution = solve<PenaltyHbm>(problem_, {{.harmonics = harmonics}});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_NEAR(test::relative_l2(test::coefficients_of(solution), exact_, kTail) * rms_, error,
                5e-3 * error);
  }
  const Solution sampled =
      solve<PenaltyHbm>(problem_, {{.harmonics = 20, .samples = 1024, .quadrature = Quadrature::sampled}});
  EXPECT_NEAR(test::relative_l2(test::coefficients_of(sampled), exact_, kTail) * rms_, 1.31e-5, 1e-7);
}

TEST_F(SoftStop, SamplingTheContactLeavesAFloorThatExactQuadratureDoesNot) {
  const auto error = [&](const PenaltyHbm::Options& options) {
    const Solution solution = solve<PenaltyHbm>(problem_, options);
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    return test::relative_l2(test::coefficients_of(solution), exact_, kTail);
  };
  const double exact = error({{.harmonics = 80}});
  const double coarse = error({{.harmonics = 80, .samples = 1024, .quadrature = Quadrature::sampled}});
  const double fine = error({{.harmonics = 80, .samples = 4096, .quadrature = Quadrature::sampled}});
  EXPECT_GE(coarse, 5.0 * fine);
  EXPECT_GE(fine, 1.2 * exact);
}

TEST_F(SoftStop, AftHbmHasTheSameErrorAsPenaltyHbm) {
  const Solution penalty = solve<PenaltyHbm>(problem_, {{.harmonics = 20}});
  const Solution aft =
      solve<AftHbm>(problem_, {.common = {.harmonics = 20}, .law = AftHbm::ContactLaw::penalty});
  ASSERT_EQ(penalty.verdict, Verdict::converged) << penalty.message;
  ASSERT_EQ(aft.verdict, Verdict::converged) << aft.message;
  // Two Newton iterations stopped at 1e-10 of the contact force.
  EXPECT_LE(test::relative_l2(test::coefficients_of(aft), test::coefficients_of(penalty), 20), 1e-8);
}

// The bilinear orbit tends to the rigid one of restitution 1 like stiffness^-1/2, in everything.
TEST_F(SoftStop, TendsToTheRigidOrbitLikeTheInverseRootOfTheStiffness) {
  const struct {
    double stiffness, error, contact, trace;  // rms of x - rigid [m], [s], [-]
  } known[] = {{1e2, 1.6616e-1, 0.245530, -1.634806}, {1e3, 7.9171e-2, 0.092719, -0.541600},
               {1e4, 2.9978e-2, 0.030802, -0.028449}, {1e5, 1.0118e-2, 0.009875, 0.144483},
               {1e6, 3.2696e-3, 0.003136, 0.199723},  {1e7, 1.0411e-3, 0.000993, 0.217226},
               {1e8, 3.2997e-4, 0.000314, 0.222764}};
  std::vector<double> stiffnesses, errors, contacts, penetrations;
  for (const auto& [stiffness, error, contact, trace] : known) {
    const BilinearOrbit orbit = test::bilinear_orbit_of(rigid_, stiffness);
    constexpr int kHarmonics = 20000;  // the difference has a kink a contact long: resolved to 1e8
    double sum = std::norm(orbit.fourier(0) - rigid_.fourier(0));
    for (int n = 1; n <= kHarmonics; ++n) sum += 2.0 * std::norm(orbit.fourier(n) - rigid_.fourier(n));
    EXPECT_NEAR(std::sqrt(sum), error, 1e-4 * error) << "stiffness " << stiffness;
    EXPECT_NEAR(orbit.open - orbit.close, contact, 1e-6);
    EXPECT_NEAR(orbit.trace(), trace, 1e-6);
    if (stiffness < 1e5) continue;
    stiffnesses.push_back(1.0 / stiffness);
    errors.push_back(std::sqrt(sum));
    contacts.push_back(orbit.open - orbit.close);
    penetrations.push_back(orbit.penetration());
  }
  for (const auto& quantity : {errors, contacts, penetrations}) {
    const double order = test::observed_order(stiffnesses, quantity);
    EXPECT_GE(order, 0.49);
    EXPECT_LE(order, 0.51);
  }
}

}  // namespace
}  // namespace signorini::penalty_orbit_test
