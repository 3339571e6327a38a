// The return by CVODE confirms orbits and nothing else.

#include "methods/orbit/return_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "methods/flow/flow.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::return_check_test {
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

// Decay of 1e7 / s: Adams' method would take tens of millions of steps over the period.
TEST(ReturnCheck, FollowsStiffStructuresByBackwardDifferentiation) {
  Problem problem = test::stopped_chain(3, 0.0, 1, 0.3);
  problem.edit_structure([](Structure& s) {
    s.stiffness.coeffRef(0, 0) += 1e9;
    s.damping.coeffRef(0, 0) += 1e7;
  });
  const auto found = test::cold_orbit(problem);
  ASSERT_TRUE(found.orbit) << found.solution.message;
  const ContactDynamics dynamics(problem);
  ASSERT_TRUE(dynamics.structure().stiff);
  const ReturnCheck check = cvode_return(dynamics, *found.orbit, kNever);
  EXPECT_TRUE(check.returned);
  EXPECT_LT(check.allowed, 1e-6);
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

/// Where one period of the flow brings the start of an orbit.
State followed(const ContactDynamics& dynamics, const ExactTrajectory& orbit, Integrator integrator,
               double tolerance) {
  EventFlow flow(dynamics, tolerance, kNever, integrator);
  FlowState state = orbit.orbit().start;
  FlowRecord record;
  flow.advance(state, orbit.period(), record);
  return state.state;
}

/// How far from its start an orbit is missed, in the scales of the motion.
double missed(const ContactDynamics& dynamics, const ExactTrajectory& orbit, Integrator integrator) {
  return dynamics.scales().distance(followed(dynamics, orbit, integrator, 1e-13), orbit.orbit().start.state);
}

TEST(ReturnCheck, IsTheSameByAdamsAndByBackwardDifferentiation) {
  for (const Problem& problem : {test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}),
                                 test::stopped_chain(3, 0.0, 1, 0.3), test::penalty_oscillator(1e3)}) {
    const auto found = test::cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    const ContactDynamics dynamics(problem);
    const State adams = followed(dynamics, *found.orbit, Integrator::adams, 1e-13);
    const State bdf = followed(dynamics, *found.orbit, Integrator::bdf, 1e-13);
    EXPECT_LT(dynamics.scales().distance(adams, bdf), 1e-8);
    EXPECT_GT(dynamics.scales().distance(adams, bdf), 0.0) << "two integrators, not one";
  }
}

/// The exact orbit of an oscillator, to be checked on one with this much more damping.
struct Detuned {
  explicit Detuned(double share) : oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2} {
    orbit = test::cold_orbit(test::to_problem(oscillator)).orbit;
    oscillator.damping *= 1.0 + share;
    dynamics.emplace(test::to_problem(oscillator));
  }

  test::ImpactOscillator oscillator;
  std::shared_ptr<const ExactTrajectory> orbit;
  std::optional<ContactDynamics> dynamics;
};

TEST(ReturnCheck, IsThatOfTheIntegratorThatComesNearer) {
  const Detuned far(1e-6);
  ASSERT_TRUE(far.orbit);
  const double adams = missed(*far.dynamics, *far.orbit, Integrator::adams);
  const double bdf = missed(*far.dynamics, *far.orbit, Integrator::bdf);
  ASSERT_NE(adams, bdf);
  EXPECT_EQ(cvode_return(*far.dynamics, *far.orbit, kNever).distance, std::min(adams, bdf));
}

// Missed by more than CVODE's usual error, by less than a millionth: the error is measured, as four times
// what ten times the tolerance changes, and both integrators are asked.
TEST(ReturnCheck, MeasuresTheErrorAtATenfoldToleranceWhereTheOrbitIsMissed) {
  const Detuned near(1e-8);
  ASSERT_TRUE(near.orbit);
  const ReturnCheck exact = cvode_return(*Detuned(0.0).dynamics, *near.orbit, kNever);
  ASSERT_TRUE(exact.returned);  // at the first attempt: allowed is the usual error
  const ReturnCheck check = cvode_return(*near.dynamics, *near.orbit, kNever);
  ASSERT_GT(check.distance, exact.allowed);
  ASSERT_LT(check.distance, 1e-6);
  double allowed = 0.0;
  for (const Integrator integrator : {Integrator::adams, Integrator::bdf}) {
    if (missed(*near.dynamics, *near.orbit, integrator) != check.distance) continue;
    const State fine = followed(*near.dynamics, *near.orbit, integrator, 1e-13);
    const State coarse = followed(*near.dynamics, *near.orbit, integrator, 1e-10);
    allowed = 4.0 * near.dynamics->scales().distance(coarse, fine);
  }
  EXPECT_GT(allowed, 0.0);
  EXPECT_NEAR(check.allowed, std::max(allowed, exact.allowed), 1e-6 * check.allowed);
  EXPECT_EQ(check.returned, check.distance <= check.allowed);
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
}  // namespace signorini::return_check_test
