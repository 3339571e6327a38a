// What becomes of a sequence: an orbit with its error bar, or the reason why there is none.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "methods/orbit/exact_orbit.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::polish_test {
namespace {

using test::cold_orbit;

TEST(PolishOutcome, PenetrationIsNotAdmissible) {
  // Without events the answer is the linear response, which reaches beyond the stop.
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  OrbitGuess guess{.start = {.time = 0.0,
                             .state = {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)},
                             .closed = {false}},
                   .events = {},
                   .origin = "the test"};
  const ExactOrbit orbit = polish_sequence(std::make_shared<OrbitModel>(problem), guess);
  EXPECT_EQ(orbit.outcome, OrbitOutcome::not_admissible);
  EXPECT_NE(orbit.reason.find("penetrates"), std::string::npos) << orbit.reason;
  EXPECT_FALSE(orbit.certified());
}

TEST(PolishOutcome, AnImpactThatIsNotThereMergesOrFails) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const auto found = cold_orbit(problem);
  ASSERT_TRUE(found.orbit);
  OrbitGuess guess = found.orbit->orbit();
  guess.events.push_back(guess.events.back());
  guess.events.back().time += 1e-3;
  const ExactOrbit orbit = polish_sequence(std::make_shared<OrbitModel>(problem), guess);
  EXPECT_FALSE(orbit.certified());
  EXPECT_FALSE(orbit.reason.empty());
}

TEST(PolishOutcome, GrazingIsRecognised) {
  // Just below the grazing amplitude an orbit of vanishing approach speed coexists with the free motion.
  constexpr double kGrazing = 0.1;
  const test::ImpactOscillator o{
      .damping = 0.1, .load = kGrazing * (1.0 - 1e-9), .frequency = 1.0, .gap = 1.0, .restitution = 0.8};
  const auto orbits = test::single_impact_orbits(o);
  ASSERT_EQ(orbits.size(), 2U);
  ASSERT_LT(orbits[1].approach, 1e-4);
  const Problem problem = test::to_problem(o);
  const auto& slow = orbits[1];
  const double section = slow.impact_time + 0.5 * slow.period;
  OrbitGuess guess{.start = {.time = section,
                             .state = {.u = Eigen::VectorXd::Constant(1, slow.x(section)),
                                       .v = Eigen::VectorXd::Constant(1, slow.velocity(section))},
                             .closed = {false}},
                   .events = {{.kind = ContactEvent::Kind::impact,
                               .contact = 0,
                               .time = slow.impact_time + slow.period,
                               .pushed = {0},
                               .restitution = {0.8},
                               .closed = {false}}},
                   .origin = "the closed form"};
  PolishOptions options;
  options.grazing = 1e-3;
  const ExactOrbit orbit = polish_sequence(std::make_shared<OrbitModel>(problem), guess, options);
  EXPECT_EQ(orbit.outcome, OrbitOutcome::grazing) << orbit.reason;
  EXPECT_EQ(orbit.multipliers.values.size(), 0);
}

TEST(PolishOutcome, UndampedResonanceHasNoOrbit) {
  const Problem problem = test::to_problem({.damping = 0.0, .frequency = 1.0, .gap = 50.0});
  OrbitGuess guess{.start = {.time = 0.0,
                             .state = {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)},
                             .closed = {false}},
                   .events = {},
                   .origin = "the test"};
  const ExactOrbit orbit = polish_sequence(std::make_shared<OrbitModel>(problem), guess);
  EXPECT_FALSE(orbit.certified());
  EXPECT_FALSE(orbit.reason.empty());
}

TEST(PolishErrorBar, CoversTheSecondEvaluation) {
  for (const Problem& problem :
       {test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2}), test::stopped_chain(4, 0.5, 2, 1.3),
        test::penalty_oscillator(1e4),
        test::to_problem({.damping = 0.1, .frequency = 0.4, .gap = 0.0, .restitution = 0.0})}) {
    const auto found = cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    PolishOptions options;
    options.second_evaluation = true;
    const ExactOrbit twice =
        polish_sequence(std::make_shared<OrbitModel>(problem), found.orbit->orbit(), options);
    ASSERT_TRUE(twice.certified());
    // It may only widen the bar; a polish from the solution itself leaves the same noise but for a few
    // digits.
    EXPECT_GE(twice.error_bar, twice.attainable);
    EXPECT_LT(twice.error_bar, 1e-10);
    EXPECT_LT(test::relative_distance(*twice.trajectory, *found.orbit),
              10.0 * (twice.error_bar + found.orbit->quality().error_bar));
  }
}

}  // namespace
}  // namespace signorini::polish_test
