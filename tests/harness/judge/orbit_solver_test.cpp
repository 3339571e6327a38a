#include "harness/judge/orbit_solver.hpp"

#include <gtest/gtest.h>

#include "harness/judge/measures/motion.hpp"
#include "tests/harness/judge/fake_orbits.hpp"

namespace signorini::orbit_solver_test {
namespace {

TEST(FindOrbit, TakesTheDifferenceOfTwoTolerancesAsErrorBar) {
  const CertifiedOrbit orbit =
      find_orbit(test::one_mass(), test::finds(1.0, 1.0 + 1e-10), shooting_options(), {}, 1e-9);
  ASSERT_NE(orbit.motion, nullptr);
  EXPECT_NEAR(orbit.error_bar, 1e-10, 1e-13);
}

TEST(FindOrbit, RefusesAnOrbitThatTwoTolerancesSeeDifferently) {
  const CertifiedOrbit orbit =
      find_orbit(test::one_mass(), test::finds(1.0, 1.001), shooting_options(), {}, 1e-9);
  EXPECT_EQ(orbit.motion, nullptr);
  EXPECT_NE(orbit.reason.find("two tolerances"), std::string::npos);
}

TEST(FindOrbit, MarchesAgainWhereShootingFailsAtTheTighterTolerance) {
  int marched = 0;
  const OrbitSolver solver = [&](const Problem& problem, const PeriodicMotionOptions& options,
                                 const Start& start) {
    if (options.shooting) return Solution{.message = "no"};
    ++marched;
    return test::free_orbits()(problem, options, start);
  };
  EXPECT_NE(find_orbit(test::one_mass(), solver, marching_options(), {}, 1e-9).motion, nullptr);
  EXPECT_EQ(marched, 2);
  EXPECT_EQ(find_orbit(test::one_mass(), solver, shooting_options(), {}, 1e-9).motion, nullptr);
}

TEST(FlowOrbits, AreTheContactFreeMotionAtBothTolerances) {
  // The stop is 10 m away: the orbit is the linear response, known in closed form.
  const Problem problem = test::one_mass();
  const CertifiedOrbit orbit = find_orbit(problem, flow_orbits(), marching_options(), {}, 1e-9);
  ASSERT_NE(orbit.motion, nullptr) << orbit.reason;
  EXPECT_LE(orbit.error_bar, 1e-9);
  const Motion found = sample_motion(problem, *orbit.motion);
  EXPECT_LT(distance(found, sample_motion(problem, *test::free_motion(problem))).x_l2.value(), 1e-9);
}

TEST(FlowOrbits, SayWhyAStructureCannotBeFollowed) {
  Problem problem = test::one_mass();
  problem.edit_structure([](Structure& s) { s.mass.coeffRef(0, 0) = 0.0; });  // damped, without mass
  problem.set_law(Penalty{{10.0}});
  const Solution solution = flow_orbits()(problem, marching_options(), {});
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solution.trajectory, nullptr);
  EXPECT_FALSE(solution.message.empty());
}

}  // namespace
}  // namespace signorini::orbit_solver_test
