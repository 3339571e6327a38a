// The return by CVODE confirms orbits and nothing else.

#include "methods/orbit/return_check.hpp"

#include <gtest/gtest.h>

#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

const auto kNever = [] { return false; };

TEST(ReturnCheck, ConfirmsExactOrbits) {
  for (const Problem& problem : {test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}),
                                 test::stopped_chain(3, 0.0, 1, 0.3), test::penalty_oscillator(1e3)}) {
    const auto found = test::cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    const ReturnCheck check = cvode_return(ContactDynamics(problem), *found.orbit, kNever);
    EXPECT_TRUE(check.returned);
    EXPECT_LE(check.distance, check.allowed);
    EXPECT_LT(check.allowed, 1e-7);
  }
}

TEST(ReturnCheck, RefusesTheOrbitOfAnotherScene) {
  // A millionth more damping moves the orbit by far more than the two integrations differ.
  const test::ImpactOscillator o{.damping = 0.1, .frequency = 2.2, .gap = 0.2};
  const auto found = test::cold_orbit(test::to_problem(o));
  ASSERT_TRUE(found.orbit);
  test::ImpactOscillator other = o;
  other.damping *= 1.0 + 1e-6;
  const ReturnCheck check = cvode_return(ContactDynamics(test::to_problem(other)), *found.orbit, kNever);
  EXPECT_FALSE(check.returned);
  EXPECT_GT(check.distance, check.allowed);
}

TEST(ReturnCheck, AllowsNoMoreThanAMillionthHoweverUncertainTheOrbit) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const auto found = test::cold_orbit(problem);
  ASSERT_TRUE(found.orbit);
  ExactTrajectory uncertain = *found.orbit;
  uncertain.set_quality({.error_bar = 0.1, .multipliers = found.orbit->quality().multipliers});
  EXPECT_EQ(cvode_return(ContactDynamics(problem), uncertain, kNever).allowed, 1e-6);
}

TEST(ReturnCheck, EndsWithTheTimeBudget) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const auto found = test::cold_orbit(problem);
  ASSERT_TRUE(found.orbit);
  EXPECT_THROW(cvode_return(ContactDynamics(problem), *found.orbit, [] { return true; }), FlowError);
}

}  // namespace
}  // namespace signorini
