// Residual, Jacobian and monodromy of the orbit equations, and Newton's method on them.

#include "methods/orbit/orbit_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <memory>

#include "problems/linear_algebra/lu.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/methods/orbit/closed_form_guess.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::orbit_equations_test {
namespace {

const test::ImpactOscillator kOscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

TEST(OrbitEquations, HoldAtTheClosedFormOrbit) {
  const auto orbit = test::single_impact_orbits(kOscillator).at(0);
  OrbitModel model(test::to_problem(kOscillator));
  OrbitEquations equations(model, test::closed_form_guess(orbit, 0.5));
  ASSERT_TRUE(equations.evaluate(equations.guess()));
  EXPECT_LT(equations.residual().lpNorm<Eigen::Infinity>(), 1e-13);
  const OrbitEquations::EventCrossing& crossing = equations.crossings().at(0);
  EXPECT_NEAR(crossing.approach, orbit.approach, 1e-12);
  EXPECT_NEAR(crossing.impulses[0], -orbit.impulse, 1e-12);
  const Eigen::MatrixXd monodromy = equations.monodromy();
  EXPECT_NEAR(monodromy.trace(), orbit.trace, 1e-11);
  EXPECT_NEAR(determinant(monodromy), orbit.determinant, 1e-11);
}

// Impacts, sticking with release, and springs: the Jacobian against central differences of the residual.
TEST(OrbitEquations, JacobianIsTheDerivativeOfTheResidual) {
  for (const Problem& problem : {test::stopped_chain(3, 0.6, 1, 0.7), test::stopped_chain(2, 0.0, 1, 0.35),
                                 test::penalty_oscillator(1e3)}) {
    const auto found = test::cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    OrbitModel model(problem);
    OrbitEquations equations(model, found.orbit->orbit());
    ASSERT_GT(equations.events(), 0) << problem.name << " " << found.solution.message;
    Eigen::VectorXd at = equations.guess();
    at.head(at.size() - equations.events()).array() += 1e-3;  // away from the solution
    ASSERT_TRUE(equations.evaluate(at));
    const Eigen::MatrixXd jacobian = equations.jacobian();
    for (Eigen::Index column = 0; column < at.size(); ++column) {
      constexpr double kStep = 1e-5;
      const Eigen::VectorXd h = kStep * Eigen::VectorXd::Unit(at.size(), column);
      ASSERT_TRUE(equations.evaluate(at + h));
      const Eigen::VectorXd ahead = equations.residual();
      ASSERT_TRUE(equations.evaluate(at - h));
      const Eigen::VectorXd difference = (ahead - equations.residual()) / (2.0 * kStep);
      EXPECT_LT((difference - jacobian.col(column)).norm(), 1e-6 * (1.0 + difference.norm())) << column;
    }
  }
}

// A beam on massless contacts, most of whose modes fade between two events, and a chain none of whose do.
TEST(OrbitEquations, CarryTheModesAliveOrAllToTheSameDerivatives) {
  for (const Problem& problem :
       {load_scene(find_scene("beam10-tip-stop")), test::stopped_chain(3, 0.6, 1, 0.7)}) {
    const auto found = test::cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    OrbitModel model(problem);
    OrbitEquations all(model, found.orbit->orbit());
    OrbitEquations alive(model, found.orbit->orbit(), {}, OrbitEquations::Columns::alive);
    ASSERT_GT(all.events(), 0);
    Eigen::VectorXd at = all.guess();
    at.array() += 1e-4;
    ASSERT_TRUE(all.evaluate(at) && alive.evaluate(at));
    const Eigen::VectorXd rows = all.jacobian().rowwise().norm();
    EXPECT_LT((rows.cwiseInverse().asDiagonal() * (all.jacobian() - alive.jacobian())).norm(), 1e-11);
    EXPECT_EQ(all.residual(), alive.residual());
    ASSERT_TRUE(alive.evaluate_residual(at));
    EXPECT_EQ(all.residual(), alive.residual());
  }
}

TEST(OrbitNewton, ConvergesQuadraticallyFromNearby) {
  const auto orbit = test::single_impact_orbits(kOscillator).at(0);
  OrbitModel model(test::to_problem(kOscillator));
  OrbitGuess guess = test::closed_form_guess(orbit, 0.5);
  guess.start.state.u[0] += 0.02;
  guess.events[0].time += 0.05;
  OrbitEquations equations(model, guess);
  const OrbitNewtonResult result = solve(equations, 1e-12, 40);
  ASSERT_TRUE(result.solved) << result.reason;
  EXPECT_LE(result.iterations, 7);
  EXPECT_LE(result.residual, 1e-12);
  EXPECT_NEAR(equations.orbit(result.unknowns).events[0].time, orbit.impact_time, 1e-12);
}

// Wherever it ends, after steps that were halved too.
TEST(OrbitNewton, LeavesTheEquationsAtTheLastIterate) {
  const auto orbit = test::single_impact_orbits(kOscillator).at(0);
  int solved = 0;
  for (int shift = -10; shift <= 10; ++shift) {
    for (const int steps : {1, 2, 3, 40}) {
      OrbitModel model(test::to_problem(kOscillator));
      OrbitGuess guess = test::closed_form_guess(orbit, 0.5);
      guess.start.state.u[0] += 0.1 * shift;
      guess.events[0].time *= 1.0 + 0.08 * shift;
      OrbitEquations equations(model, guess), fresh(model, guess);
      const OrbitNewtonResult result = solve(equations, 1e-12, steps);
      solved += result.solved ? 1 : 0;
      ASSERT_TRUE(fresh.evaluate(result.unknowns));
      EXPECT_EQ(equations.residual(), fresh.residual()) << shift << ", " << steps;
      EXPECT_EQ(equations.jacobian(), fresh.jacobian()) << shift << ", " << steps;
      EXPECT_EQ(result.residual, fresh.residual().lpNorm<Eigen::Infinity>()) << shift << ", " << steps;
    }
  }
  EXPECT_GT(solved, 10);
}

TEST(OrbitNewton, SaysWhyItFails) {
  // The stop of the guess, moved to where no motion with one impact per period reaches it.
  const auto orbit = test::single_impact_orbits(kOscillator).at(0);
  test::ImpactOscillator out_of_reach = kOscillator;
  out_of_reach.gap = 40.0;
  OrbitModel open(test::to_problem(out_of_reach));
  OrbitEquations unsolvable(open, test::closed_form_guess(orbit, 0.5));
  const OrbitNewtonResult result = solve(unsolvable, 1e-12, 40);
  EXPECT_FALSE(result.solved);
  EXPECT_FALSE(result.reason.empty());

  OrbitGuess guess = test::closed_form_guess(orbit, 0.5);
  guess.events[0].time += 0.3;  // the equations are linear in the state, not in the instant
  OrbitModel model(test::to_problem(kOscillator));
  OrbitEquations far(model, guess);
  const OrbitNewtonResult stopped = solve(far, 1e-12, 1);
  EXPECT_FALSE(stopped.solved);
  EXPECT_NE(stopped.reason.find("1 Newton steps"), std::string::npos) << stopped.reason;
}

}  // namespace
}  // namespace signorini::orbit_equations_test
