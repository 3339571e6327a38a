// Where an exact orbit comes from and how a search that fails says so.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "methods/event_driven/event_driven.hpp"
#include "methods/flow/event_trajectory.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/moreau_stepping.hpp"
#include "tests/support/orbit_check.hpp"
#include "tests/support/population.hpp"

namespace signorini::orbit_search_test {
namespace {

using test::cold_orbit;

// The scenes of the populations whose stable orbit has so many impacts (and no lasting contact).
std::vector<Problem> stable_scenes_with(std::size_t impacts, std::size_t count) {
  std::vector<Problem> scenes;
  for (const auto& population : {test::restitution_population(220), test::chain_population(60)}) {
    std::size_t taken = 0;
    for (const Problem& problem : population) {
      const auto found = cold_orbit(problem);
      if (!found.orbit || taken >= count) continue;
      const auto& events = found.orbit->orbit().events;
      const bool impulsive = found.orbit->impulses().size() == events.size();
      if (!impulsive || events.size() != impacts ||
          found.orbit->quality().multipliers.cwiseAbs().maxCoeff() > 0.9)
        continue;
      scenes.push_back(problem);
      ++taken;
    }
  }
  return scenes;
}

// CVODE from the exact orbit's own neighbourhood: shooting at two tolerances, errors following them.
void expect_cvode_agrees(const Problem& problem) {
  const auto found = cold_orbit(problem);
  ASSERT_TRUE(found.orbit) << found.solution.message;
  for (const double tolerance : {1e-8, 1e-11}) {
    EventDriven::Options options{.tolerance = tolerance, .steady = EventDriven::Steady::shooting};
    const Solution cvode = test::solve<EventDriven>(problem, options, found.orbit);
    ASSERT_EQ(cvode.verdict, Verdict::converged) << cvode.message;
    EXPECT_LT(test::relative_distance(*cvode.trajectory, *found.orbit), 100.0 * tolerance);
    const auto theirs = cvode.trajectory->impulses(), ours = found.orbit->impulses();
    ASSERT_EQ(theirs.size(), ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      EXPECT_NEAR(std::remainder(theirs[i].time - ours[i].time, problem.period()), 0.0, 1e3 * tolerance);
      EXPECT_NEAR(theirs[i].value, ours[i].value, 1e3 * tolerance * (1.0 + std::abs(ours[i].value)));
    }
  }
}

TEST(ExactOrbitSearch, OrbitsOfTwoImpactsAgreeWithCvodeAtTwoTolerances) {
  auto scenes = stable_scenes_with(2, 2);
  scenes.push_back(
      test::to_problem({.damping = 0.05, .frequency = 2.7, .gap = 0.0, .restitution = 0.7, .order = 2}));
  ASSERT_GE(scenes.size(), 3U);
  for (const Problem& problem : scenes) expect_cvode_agrees(problem);
}

TEST(ExactOrbitSearch, OrbitsOfThreeImpactsAgreeWithCvodeAtTwoTolerances) {
  const auto scenes = stable_scenes_with(3, 2);
  ASSERT_GE(scenes.size(), 3U);
  for (const Problem& problem : scenes) expect_cvode_agrees(problem);
}

TEST(ExactOrbitSearch, NonProportionalDampingAgreesWithCvode) {
  for (const double e : {0.8, 0.3}) {
    for (const double w : {0.9, 1.1, 1.6}) expect_cvode_agrees(test::skew_damped_pair(e, w));
  }
}

// Sticking: Moreau's scheme without events converges to the exact orbit at first order.
TEST(ExactOrbitSearch, StickingAgreesWithMoreausScheme) {
  Problem one = test::to_problem({.damping = 0.1, .frequency = 0.4, .gap = 0.0, .restitution = 0.0});
  for (const Problem& problem :
       {one, test::stopped_chain(2, 0.0, 1, 0.35), test::stopped_chain(3, 0.0, 2, 0.3)}) {
    SCOPED_TRACE(problem.size());
    const auto found = cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    bool sticks = false;
    for (const SequenceEvent& event : found.orbit->orbit().events)
      sticks |= event.kind == ContactEvent::Kind::close;
    EXPECT_TRUE(sticks);
    std::vector<double> errors;
    for (const int steps : {4000, 16000}) {
      const Eigen::MatrixXd x = test::moreau_steady_state(problem, steps, 40);
      const Eigen::MatrixXd exact = found.orbit->sample(steps).x;
      errors.push_back((x - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff());
    }
    EXPECT_LT(errors[1], 3e-3);
    EXPECT_LT(errors[1], 0.5 * errors[0]);
  }
}

TEST(ExactOrbitSearch, EveryMethodsAnswerLeadsToTheSameOrbit) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const auto exact = test::single_impact_orbits({.damping = 0.1, .frequency = 2.2, .gap = 0.2}).front();
  std::vector<Solution> coarse{test::solve<HatLcp>(problem, {.samples = 48}),
                               test::solve<FourierLipschitz>(problem, {{.harmonics = 12}}),
                               test::solve<EventDriven>(problem, {.tolerance = 1e-6})};
  for (const Solution& solution : coarse) {
    ASSERT_EQ(solution.verdict, Verdict::converged);
    const OrbitSearch found = OrbitFinder(problem).find(*solution.trajectory);
    ASSERT_EQ(found.orbit.outcome, OrbitOutcome::converged) << found.orbit.reason;
    EXPECT_LT(test::relative_error(*found.orbit.trajectory, [&](double t) { return exact.x(t); }), 1e-11);
    EXPECT_LE(found.orbit.residual, 1e-12);
  }
  // An exact orbit is its own guess.
  const OrbitSearch first = OrbitFinder(problem).find(*coarse[0].trajectory);
  const OrbitSearch again = OrbitFinder(problem).find(*first.orbit.trajectory);
  EXPECT_EQ(again.attempts, 1);
  EXPECT_LE(again.iterations, 2);
}

TEST(ExactOrbitSearch, MarchingMeetsAStableOrbitFromRest) {
  const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.7};
  const auto exact = test::single_impact_orbits(oscillator).front();
  for (const bool at_last : {false, true}) {
    OrbitFinder finder(test::to_problem(oscillator));
    const OrbitGuess rest{
        .start = {.time = 0.0, .state = finder.model()->dynamics.at_rest(), .closed = {false}},
        .events = {},
        .origin = "rest"};
    SearchOptions options{.rounds = 0, .shootings = 0};
    EXPECT_FALSE(finder.find(rest, options).orbit.certified());
    (at_last ? options.marched : options.followed) = 32;
    const OrbitSearch found = finder.find(rest, options);
    ASSERT_EQ(found.orbit.outcome, OrbitOutcome::converged) << found.orbit.reason;
    EXPECT_LT(test::relative_error(*found.orbit.trajectory, [&](double t) { return exact.x(t); }), 1e-11);
  }
}

TEST(ExactOrbitSearch, MasslessContactsAreTheSpringStopsTheyCondenseTo) {
  // A massless node on a spring k_e before the stop: bilinear with penalty k_e.
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const double spring = 50.0;
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::Vector2d(1.0, 0.0).asDiagonal()).sparseView();
    s.damping = Eigen::MatrixXd(Eigen::Vector2d(0.1, 0.0).asDiagonal()).sparseView();
    s.stiffness = Eigen::MatrixXd((Eigen::Matrix2d() << 1.0 + spring, -spring, -spring, spring).finished())
                      .sparseView();
  });
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = 0.2}};
  problem.set_law(Massless{});
  const auto massless = cold_orbit(problem);
  ASSERT_TRUE(massless.orbit) << massless.solution.message;
  const auto bilinear = cold_orbit(test::penalty_oscillator(spring));
  ASSERT_TRUE(bilinear.orbit) << bilinear.solution.message;
  const Samples a = massless.solution.trajectory->sample(500), b = bilinear.orbit->sample(500);
  EXPECT_LT((a.force - b.force).cwiseAbs().maxCoeff(), 1e-11 * b.force.cwiseAbs().maxCoeff());
  EXPECT_LT((a.x - b.x.cwiseMin(0.2)).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace signorini::orbit_search_test
