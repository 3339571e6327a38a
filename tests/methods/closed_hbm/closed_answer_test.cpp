// Harmonic balance under the scene's own restitution, judged by closed-form and exact orbits.

#include "methods/closed_hbm/closed_answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/population.hpp"

namespace signorini::closed_answer_test {
namespace {

using test::ImpactOscillator;
using test::relative_distance;
using test::solve;

ImpactOscillator oscillator(double restitution) {
  return {.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = restitution};
}

/// Error of x over what H harmonics cut off of the nearest closed-form orbit.
double error_over_cut(const ImpactOscillator& scene, const Solution& solution, int harmonics) {
  double best = HUGE_VAL;
  for (const auto& orbit : test::single_impact_orbits(scene)) {
    double beyond = 0.0;
    double all = std::norm(orbit.fourier(0));
    for (int n = 1; n <= 4000; ++n) {
      all += 2.0 * std::norm(orbit.fourier(n));
      if (n > harmonics) beyond += 2.0 * std::norm(orbit.fourier(n));
    }
    const double error = test::relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); });
    best = std::min(best, error / std::sqrt(beyond / all));
  }
  return best;
}

class ClosedAnswerAt : public testing::TestWithParam<double> {};

TEST_P(ClosedAnswerAt, IsTheOrbitOfTheScenesRestitution) {
  const ImpactOscillator scene = oscillator(GetParam());
  const Problem problem = test::to_problem(scene);
  for (const int harmonics : {10, 40, 160}) {
    const Solution found = solve<ClosedHbm>(problem, {.harmonics = harmonics});
    ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
    EXPECT_NE(found.message.find("1 impact closed at restitution"), std::string::npos) << found.message;
    EXPECT_LE(error_over_cut(scene, found, harmonics), 1.02);
    EXPECT_LE(found.work.iterations.value(), 16) << "Newton steps, those that settle the impacts included";
  }
}

INSTANTIATE_TEST_SUITE_P(OneMass, ClosedAnswerAt, testing::Values(1.0, 0.8, 0.5, 0.2, 0.0));

// The load is at the resonance: what the width takes off the force's first harmonic is multiplied by a
// thousand.
TEST(ClosedAnswer, SaysHowFarAResonanceMovesIt) {
  const ImpactOscillator scene{.damping = 1e-3, .frequency = 1.0, .gap = 0.5, .restitution = 0.9};
  const Solution found = solve<ClosedHbm>(test::to_problem(scene), {.harmonics = 20});
  ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
  const std::string words = "the width of its forces moves it by ";
  const std::size_t place = found.message.find(words);
  ASSERT_NE(place, std::string::npos) << found.message;
  double error = 1.0;
  for (const test::SingleImpactOrbit& orbit : test::single_impact_orbits(scene)) {
    double moving = 0.0;
    for (int n = 1; n <= 4000; ++n) moving += 2.0 * std::norm(orbit.fourier(n));
    const double about_mean = std::sqrt(1.0 + std::norm(orbit.fourier(0)) / moving);
    error = std::min(
        error, about_mean * test::relative_error(*found.trajectory, [&](double t) { return orbit.x(t); }));
  }
  EXPECT_NEAR(std::stod(found.message.substr(place + words.size())), error, 0.1 * error);
  EXPECT_NEAR(error, 0.25, 0.05);
}

TEST(ClosedAnswer, IsOfRestitutionOneWhereNoneIsAskedFor) {
  const Problem problem = test::to_problem(oscillator(0.5));
  const ClosedHbm::Options none{.harmonics = 40, .restitution = ClosedHbm::ImpactLaw::none};
  EXPECT_FALSE(law_matches(ClosedHbm(none).law(problem), problem.law()));
  const Solution found = solve<ClosedHbm>(problem, none);
  ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
  EXPECT_LE(error_over_cut(oscillator(1.0), found, 40), 1.02);
}

// The contact-free motion passes the stop by 1e-7 of its amplitude, between any two of 1024 instants.
TEST(ClosedAnswer, IsNotTheContactFreeMotionWhereThatTouchesForAnInstant) {
  ImpactOscillator scene = oscillator(0.8);
  const double amplitude = 1.0 / std::hypot(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  scene.gap = amplitude * (1.0 - 1e-7);
  const Solution touching = solve<ClosedHbm>(test::to_problem(scene), {.harmonics = 20});
  EXPECT_EQ(touching.message.find("nothing touches"), std::string::npos) << touching.message;
  scene.gap = amplitude * (1.0 + 1e-9);
  const Solution beside = solve<ClosedHbm>(test::to_problem(scene), {.harmonics = 20});
  EXPECT_NE(beside.message.find("nothing touches"), std::string::npos) << beside.message;
}

TEST(ClosedAnswer, KeepsWithinALimitOnSteps) {
  const Problem problem = test::to_problem(oscillator(0.5));
  const Solution short_of = solve<ClosedHbm>(problem, {.max_iterations = 4});
  EXPECT_EQ(short_of.verdict, Verdict::not_converged);
  const Solution found = solve<ClosedHbm>(problem, {.max_iterations = 100});
  EXPECT_EQ(found.verdict, Verdict::converged) << found.message;
  EXPECT_LE(found.work.iterations.value() + found.work.pivots.value_or(0), 100);
}

/// The answer's distance from the exact orbit that it leads to, under the scene's own law.
double distance_from_orbit(const Problem& problem, const Solution& found) {
  const Solution orbit = solve<ExactOrbitMethod>(problem, {}, found.trajectory);
  EXPECT_EQ(orbit.verdict, Verdict::converged) << orbit.message;
  return orbit.verdict == Verdict::converged ? relative_distance(*orbit.trajectory, *found.trajectory)
                                             : HUGE_VAL;
}

/// The force of an impact is an impulse, whose series errs in x like H^-3/2.
void expect_order_of_the_best_series(const Problem& problem) {
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int harmonics : {20, 40, 80, 160}) {
    const Solution found = solve<ClosedHbm>(problem, {.harmonics = harmonics});
    ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
    steps.push_back(1.0 / harmonics);
    errors.push_back(distance_from_orbit(problem, found));
  }
  EXPECT_NEAR(test::observed_order(steps, errors), 1.5, 0.15);
}

TEST(ClosedAnswer, ConvergesOnChainsWithTwoStopsAsTheBestSeriesDoes) {
  const Problem problem = test::stopped_chain(3, 0.5, 2);
  expect_order_of_the_best_series(problem);
}

TEST(ClosedAnswer, ConvergesBetweenTwoStopsAsTheBestSeriesDoes) {
  ImpactOscillator one{.damping = 0.1, .frequency = 0.8, .gap = 0.5, .restitution = 0.8};
  Problem problem = test::to_problem(one);
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.5, .law = problem.contacts.front().law});
  expect_order_of_the_best_series(problem);
}

TEST(ClosedAnswer, IsContinuousInTheRestitution) {
  const auto of = [](double restitution) {
    return solve<ClosedHbm>(test::to_problem(oscillator(restitution)), {.harmonics = 20});
  };
  EXPECT_LE(relative_distance(*of(1.0).trajectory, *of(1.0 - 1e-6).trajectory), 1e-5);
}

/// A scene set up with H harmonics, its series and what closes it at restitution 1.
struct OwnSeries {
  OwnSeries(const Problem& problem, int harmonics)
      : setup(harmonic_setup(
            problem, harmonics, {.harmonics = harmonics},
            {.law_at =
                 [&problem](const ContactReceptance& level) { return lipschitz_law(problem, {}, level); },
             .grid_solver = lcp_grid_solver({})})),
        closure(closure_setup(setup, {.restitution = 1.0})),
        series(solve_series(setup, {}, work)) {}
  OwnSeries(const OwnSeries&) = delete;
  OwnSeries& operator=(const OwnSeries&) = delete;

  [[nodiscard]] ClosedAnswer closed() { return close_series(setup, closure.value(), series, {}, work); }

  HarmonicSetup setup;
  std::optional<ClosureSetup> closure;
  Work work = {};
  Solution series;
};

TEST(ClosedAnswer, IsTheSameFromTheImpactsOfASeriesAtRestitutionOne) {
  const Problem problem = test::to_problem(oscillator(1.0));
  const Solution of_hats = solve<ClosedHbm>(problem, {.harmonics = 20});
  EXPECT_NE(of_hats.message.find("hat functions first"), std::string::npos) << of_hats.message;
  OwnSeries own(problem, 20);
  ASSERT_EQ(own.series.verdict, Verdict::converged) << own.series.message;
  const ClosedAnswer of_series = own.closed();
  ASSERT_TRUE(of_series.answer) << of_series.reason;
  EXPECT_LE(relative_distance(*of_hats.trajectory, *of_series.answer->trajectory), 1e-9);
}

// With 20 harmonics the series of this scene rattles and is near no orbit.
TEST(ClosedAnswer, IsNoneOfASeriesWhoseImpactsCannotBeClosed) {
  const Problem problem = test::to_problem(test::hard_population(140).back());
  OwnSeries own(problem, 20);
  ASSERT_EQ(own.series.verdict, Verdict::converged) << own.series.message;
  const ClosedAnswer closed = own.closed();
  EXPECT_FALSE(closed.answer);
  EXPECT_FALSE(closed.reason.empty());
}

// Where a contact presses throughout there is nothing to close: the series is the answer as it stands.
TEST(ClosedAnswer, OfASeriesThatNothingStrikesIsTheSeries) {
  const Problem pressed =
      test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = -2.0, .restitution = 1.0});
  OwnSeries own(pressed, 10);
  ASSERT_EQ(own.series.verdict, Verdict::converged) << own.series.message;
  const ClosedAnswer closed = own.closed();
  ASSERT_TRUE(closed.answer) << closed.reason;
  EXPECT_EQ(closed.answer->trajectory, own.series.trajectory);
}

// Motions near which series of twenty harmonics rattle.
TEST(ClosedAnswer, IsFoundWhereFewHarmonicsRattle) {
  const Problem problem = test::to_problem(test::hard_population(140).back());
  const Solution found = solve<ClosedHbm>(problem, {.harmonics = 20});
  ASSERT_EQ(found.verdict, Verdict::converged) << found.message;
  EXPECT_LE(distance_from_orbit(problem, found), 0.02);
}

TEST(ClosedAnswer, RefusesContactThatSticksOrChatters) {
  for (const ImpactOscillator& scene :
       {ImpactOscillator{.damping = 0.1, .frequency = 0.4, .gap = -0.3, .restitution = 0.0},
        ImpactOscillator{.damping = 0.1, .frequency = 0.4, .gap = 0.0, .restitution = 0.3}}) {
    const Solution found = solve<ClosedHbm>(test::to_problem(scene), {});
    EXPECT_EQ(found.verdict, Verdict::not_converged) << found.message;
    EXPECT_FALSE(found.message.empty());
  }
}

TEST(ClosedAnswer, IsTheContactFreeMotionOrTheHeldOneWhereNoImpactIs) {
  const Problem free = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 2.0, .restitution = 0.3});
  const Solution open = solve<ClosedHbm>(free, {});
  ASSERT_EQ(open.verdict, Verdict::converged) << open.message;
  EXPECT_EQ(open.trajectory->force_coefficients().norm(), 0.0);
  const Problem pressed =
      test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = -2.0, .restitution = 0.3});
  const Solution held = solve<ClosedHbm>(pressed, {});
  ASSERT_EQ(held.verdict, Verdict::converged) << held.message;
  EXPECT_NEAR(held.trajectory->sample(64).x.minCoeff(), -2.0, 1e-9);
}

TEST(ClosedAnswer, FollowsAGuess) {
  const Problem problem = test::to_problem(oscillator(0.5));
  ImpactOscillator moved = oscillator(0.5);
  moved.frequency = 2.21;
  const Solution first = solve<ClosedHbm>(problem, {.harmonics = 40});
  const Solution next = solve<ClosedHbm>(test::to_problem(moved), {.harmonics = 40}, first.trajectory);
  ASSERT_EQ(next.verdict, Verdict::converged) << next.message;
  EXPECT_EQ(next.message.find("impacts of the guess"), 0U) << next.message;
  EXPECT_FALSE(next.work.pivots) << "no hat functions";
  EXPECT_LE(error_over_cut(moved, next, 40), 1.02);
}

// Whatever is claimed under e < 1 leads to an orbit of that restitution near by.
TEST(ClosedAnswer, ClaimsOnlyOrbitsOfTheScenesOwnRestitution) {
  int claimed = 0;
  for (const Problem& problem : test::restitution_population(40)) {
    if (std::get<Restitution>(problem.law()).e == 1.0) continue;
    const Solution found = solve<ClosedHbm>(problem, {.harmonics = 20});
    if (found.verdict != Verdict::converged) continue;
    ++claimed;
    if (found.message.find("closed") == std::string::npos) continue;
    EXPECT_LE(distance_from_orbit(problem, found), 0.1);
  }
  EXPECT_GE(claimed, 16);
}

TEST(ImpactSeeds, AreReadOffAGridOfNodes) {
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(100, 1);
  force(20, 0) = -3.0;
  force(21, 0) = -1.0;
  force(99, 0) = -2.0;
  force(0, 0) = -2.0;
  const NodalTrajectory motion(2.0, Eigen::MatrixXd::Zero(100, 1), force);
  const ImpactSeeds seeds = impact_seeds(motion);
  EXPECT_FALSE(seeds.lasting);
  ASSERT_EQ(seeds.impacts.count(), 2);
  EXPECT_NEAR(seeds.impacts.moments(0, 0), 0.2025, 1e-12);
  EXPECT_NEAR(seeds.impacts.moments(1, 0), 0.04, 1e-12);
  EXPECT_NEAR(seeds.impacts.moments(0, 1), 0.995, 1e-12);
}

TEST(ImpactSeeds, SayWhereAContactLasts) {
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(100, 1);
  force.col(0).segment(20, 30).setConstant(-1.0);
  EXPECT_TRUE(impact_seeds(NodalTrajectory(2.0, Eigen::MatrixXd::Zero(100, 1), force)).lasting);
}

}  // namespace
}  // namespace signorini::closed_answer_test
