#include "methods/penalty_hbm/penalty_hbm.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "methods/discretisation/trajectories.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::penalty_hbm_test {
namespace {

using test::solve;

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

TEST(PenaltyHbm, ItsForceIsTheSpringsOwn) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{80.0}});
  const Solution solution = solve<PenaltyHbm>(problem, {{.harmonics = 12}});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Samples samples = solution.trajectory->sample(100);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(samples.force(i, 0), -80.0 * std::max(0.0, samples.x(i, 0) - 0.2), 1e-10);
  }
}

// The tube of code_aster V5.02.301 between eight springs: what the series has is near an exact orbit.
TEST(PenaltyHbm, FindsAMotionOfATubeAmongItsStops) {
  const Problem problem = load_scene(find_scene("sdnl301"));
  const Solution series = solve<PenaltyHbm>(problem, {});
  ASSERT_EQ(series.verdict, Verdict::converged) << series.message;
  const Solution orbit = solve<ExactOrbitMethod>(problem, {}, series.trajectory);
  ASSERT_EQ(orbit.verdict, Verdict::converged) << orbit.message;
  EXPECT_NE(orbit.message.find("from the guess"), std::string::npos) << orbit.message;
  EXPECT_LT(test::relative_distance(*series.trajectory, *orbit.trajectory), 0.02);
}

TEST(PenaltyHbm, IsExactWithOneHarmonicWhereNothingTouches) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 3.0});
  const std::complex<double> amplitude = 1.0 / std::complex<double>(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  const Solution solution = solve<PenaltyHbm>(problem, {{.harmonics = 1}});
  EXPECT_LE(test::relative_error(*solution.trajectory,
                                 [&](double t) { return (amplitude * std::polar(1.0, 2.2 * t)).real(); }),
            1e-14);
}

TEST(PenaltyHbm, OnARigidStopApproachesTheRestitutionOneOrbit) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  std::vector<double> errors;
  for (const int harmonics : {10, 40, 160}) {
    const Solution solution = solve<PenaltyHbm>(test::to_problem(kStop), {{.harmonics = harmonics}});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    errors.push_back(test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }));
  }
  EXPECT_LT(errors[1], 0.5 * errors[0]);
  EXPECT_LT(errors[2], 0.5 * errors[1]);
  EXPECT_LT(errors[2], 3e-2);
}

TEST(PenaltyHbm, TakesThePenaltyAbsoluteOrRelative) {
  const Problem problem =
      test::to_problem({.damping = 0.1, .stiffness = 2.0, .frequency = 2.2, .gap = 0.2, .restitution = 1.0});
  const Solution absolute =
      solve<PenaltyHbm>(problem, {.common = {.harmonics = 10}, .penalty = Scaled{200.0, false}});
  const Solution relative =
      solve<PenaltyHbm>(problem, {.common = {.harmonics = 10}, .penalty = Scaled{100.0, true}});
  EXPECT_EQ(test::relative_distance(*absolute.trajectory, *relative.trajectory), 0.0);
}

TEST(PenaltyHbm, AnotherPenaltyThanTheScenesIsAMismatchItDeclares) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{80.0}});
  EXPECT_TRUE(law_matches(PenaltyHbm({}).law(problem), problem.law()));
  EXPECT_FALSE(law_matches(PenaltyHbm({.penalty = Scaled{100.0, false}}).law(problem), problem.law()));
}

TEST(PenaltyHbm, ContactDoesNoNetWork) {
  Problem problem = test::to_problem(kStop);
  for (const double stiffness : {10.0, 100.0, 1000.0}) {
    problem.set_law(Penalty{{stiffness}});
    for (const int harmonics : {10, 20}) {
      const Solution solution =
          solve<PenaltyHbm>(problem, {{.harmonics = harmonics, .samples = 64 * harmonics}});
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      const auto& data = dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data();
      double contact = 0.0;
      for (int n = 1; n <= harmonics; ++n) {
        contact -= 4.0 * std::numbers::pi * n * (std::conj(data.lambda(n, 0)) * data.x(n, 0)).imag();
      }
      const double load = -4.0 * std::numbers::pi * (0.5 * data.x(1, 0)).imag();
      EXPECT_LE(std::abs(contact), 1e-7 * std::abs(load)) << "H = " << harmonics << ", eps = " << stiffness;
    }
  }
}

// The dynamic stiffness of a massless contact does not grow with H; a stop as many times stiffer would leave
// an error that more harmonics cannot mend.
TEST(PenaltyHbm, OnAMasslessContactGainsFromMoreHarmonics) {
  const Problem problem = load_scene(find_scene("bar20-massless"));
  const Solution exact = test::solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
  const auto error = [&](int harmonics) {
    const Solution solution = test::solve<PenaltyHbm>(problem, {{.harmonics = harmonics}});
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    return test::relative_distance(*solution.trajectory, *exact.trajectory);
  };
  const double at_40 = error(40);
  EXPECT_LE(at_40, 2e-3);
  EXPECT_LE(error(160), at_40 / 4.0);
}

TEST(PenaltyHbm, ClaimsNothingWhereRoundingExceedsTheForce) {
  for (const double penalty : {1e10, 1e16, 1e308}) {
    const Solution solution = solve<PenaltyHbm>(
        test::to_problem(kStop), {.common = {.harmonics = 10}, .penalty = Scaled{penalty, true}});
    EXPECT_NE(solution.verdict, Verdict::converged) << penalty;
  }
}

TEST(PenaltyHbm, RefusesOptionsOutOfRange) {
  EXPECT_THROW(PenaltyHbm({.penalty = Scaled{0.0, false}}), InvalidOption);
  EXPECT_THROW(PenaltyHbm({.penalty = Scaled{-3.0, true}}), InvalidOption);
  EXPECT_THROW(PenaltyHbm({{.harmonics = -1}}), InvalidOption);
}

}  // namespace
}  // namespace signorini::penalty_hbm_test
