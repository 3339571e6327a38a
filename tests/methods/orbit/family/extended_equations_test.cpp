// The Jacobian with the parameter's column against differences of the residual, and the corrector on it.

#include "methods/orbit/family/extended_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/family/survey.hpp"
#include "problems/linear_algebra/singular_values.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::extended_equations_test {
namespace {

SequencedOrbit cold(OrbitFamily& family, double parameter) {
  const Problem problem = family.scene().at(parameter);
  const auto found = test::cold_orbit(problem);
  EXPECT_TRUE(found.orbit) << found.solution.message;
  return sequenced(family, found.orbit->orbit(), problem.period(), problem.frequency, parameter);
}

void expect_derivative(OrbitFamily& family, const SequencedOrbit& orbit) {
  ExtendedEquations equations(family, orbit), beside(family, orbit);
  Eigen::VectorXd at = orbit.x;
  at.head(orbit.states()).array() += 1e-3;  // away from the solution
  ASSERT_TRUE(equations.evaluate(at));
  constexpr double kStep = 1e-5;
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const Eigen::VectorXd unit = kStep * Eigen::VectorXd::Unit(at.size(), k);
    ASSERT_TRUE(beside.evaluate(at + unit));
    const Eigen::VectorXd ahead = beside.residual();
    ASSERT_TRUE(beside.evaluate(at - unit));
    const Eigen::VectorXd difference = (ahead - beside.residual()) / (2.0 * kStep);
    const double scale = std::max(1.0, difference.lpNorm<Eigen::Infinity>());
    EXPECT_LT((equations.jacobian().col(k) - difference).lpNorm<Eigen::Infinity>(), 1e-5 * scale) << k;
  }
}

TEST(ExtendedEquations, HaveTheirDerivativeInEveryParameter) {
  const Problem chain = test::stopped_chain(2, 0.6);
  OrbitFamily frequency(over_frequency(chain, 0.5, 0.9));
  expect_derivative(frequency, cold(frequency, 0.7));
  OrbitFamily restitution({.parameter = "law.restitution", .from = 0.4, .to = 0.8, .at = [chain](double e) {
                             Problem changed = chain;
                             changed.set_law(Restitution{e});
                             return changed;
                           }});
  const SequencedOrbit struck = cold(restitution, 0.6);
  expect_derivative(restitution, struck);
  ExtendedEquations equations(restitution, struck);
  ASSERT_TRUE(equations.evaluate(struck.x));
  EXPECT_GT(equations.jacobian().col(equations.size()).norm(), 1e-3);  // the law of its impacts follows
  OrbitFamily gap({.parameter = "contact[0].gap", .from = 0.1, .to = 0.3, .at = [](double g) {
                     return test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = g});
                   }});
  expect_derivative(gap, cold(gap, 0.2));
}

// The rows of phases of contact, divided by their length: of the length that an orbit has, and next to none.
TEST(ExtendedEquations, HaveTheirDerivativeAtPhasesOfContact) {
  OrbitFamily family(over_frequency(test::penalty_oscillator(100.0, 2.2), 2.0, 2.6));
  const SequencedOrbit orbit = cold(family, 2.2);
  ASSERT_EQ(orbit.count(), 2);
  expect_derivative(family, orbit);
  SequencedOrbit lasting = with_contact_phase(contact_free_orbit(family, 2.3).value(), 0, 3.0);
  lasting.x[lasting.states() + 1] += 2e-3;
  expect_derivative(family, lasting);
}

// At a phase of contact of length 0 the undivided equations are one equation twice.
TEST(ExtendedEquations, AreRegularWhereAPhaseOfContactBegins) {
  constexpr double kBirth = 2.4482651818133;
  OrbitFamily family(over_frequency(test::penalty_oscillator(100.0, 2.2), 2.0, 2.6));
  const SequencedOrbit free = contact_free_orbit(family, kBirth).value();
  ExtendedEquations touching(family, free);
  ASSERT_TRUE(touching.evaluate(free.x));
  const double phase = survey(touching).find(GuardKind::clearance, 0)->phase;
  const SequencedOrbit begun = with_contact_phase(free, 0, phase);
  ExtendedEquations equations(family, begun);
  ASSERT_TRUE(equations.evaluate(begun.x));
  EXPECT_LT(equations.residual().lpNorm<Eigen::Infinity>(), 1e-11);
  EXPECT_GT(least_singular_value(equations.jacobian()), 1e-3);
  const Eigen::VectorXd tangent = first_tangent(equations);  // the phase grows both ways, nothing else moves
  EXPECT_NEAR(std::abs(tangent[2] - tangent[3]), std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(tangent[4], 0.0, 1e-3);
}

// The state at phase 0 of the contact-free motion is Re of the receptance: zero at the eigenfrequency.
TEST(Locate, FindsAZeroOnACurve) {
  OrbitFamily family(over_frequency(test::to_problem({.damping = 0.1, .gap = 20.0}), 0.5, 2.0));
  const SequencedOrbit start = contact_free_orbit(family, 0.9).value();
  ExtendedEquations equations(family, start);
  ASSERT_TRUE(equations.evaluate(start.x));
  const Eigen::VectorXd along = Eigen::VectorXd::Unit(start.x.size(), start.x.size() - 1);
  const auto u = [](ExtendedEquations& at) { return std::optional(at.orbit().x[0]); };
  const double length = 0.3 / family.units().parameter;
  ASSERT_TRUE(correct_at_parameter(equations, start.x + length * along));
  const double last = *u(equations);
  const CurveStep step{.x = start.x, .tangent = along, .length = length};
  const auto found = locate(equations, step, u, start.x[0], last);
  ASSERT_TRUE(found);
  EXPECT_NEAR(equations.parameter(), 1.0, 1e-13);
  EXPECT_FALSE(locate(equations, step, u, last, last));  // no change of sign
}

TEST(TangentOf, IsTheDirectionOfTheCurve) {
  OrbitFamily family(over_frequency(test::to_problem({.damping = 0.1, .gap = 20.0}), 0.5, 2.0));
  const SequencedOrbit start = contact_free_orbit(family, 0.9).value();
  ExtendedEquations equations(family, start);
  ASSERT_TRUE(equations.evaluate(start.x));
  const Eigen::VectorXd first = first_tangent(equations);
  const auto second = tangent_of(equations, first);
  ASSERT_TRUE(second);
  EXPECT_LT((*second - first).norm(), 1e-12);
  EXPECT_LT((equations.jacobian() * first).norm(), 1e-12);
  const Eigen::VectorXd a = contact_free_orbit(family, 0.9 + 1e-6)->x,
                        b = contact_free_orbit(family, 0.9 - 1e-6)->x;
  EXPECT_NEAR(std::abs((a - b).normalized().dot(first)), 1.0, 1e-9);
}

// After motions beside an orbit, with other arcs, the orbit is there again as it was.
TEST(ExtendedEquations, GoBackToWhereTheyWereEvaluated) {
  OrbitFamily family(over_frequency(test::penalty_oscillator(100.0, 2.2), 2.0, 2.6));
  const SequencedOrbit orbit = cold(family, 2.2);
  ExtendedEquations equations(family, orbit), once(family, orbit);
  ASSERT_TRUE(equations.evaluate(orbit.x));
  ASSERT_TRUE(once.evaluate(orbit.x));
  const Eigen::MatrixXd J = equations.jacobian();
  Eigen::VectorXd beside = orbit.x;
  beside.array() += 1e-3;
  ASSERT_TRUE(equations.evaluate_motion(beside));
  EXPECT_NE(equations.residual(), once.residual());
  ASSERT_TRUE(equations.evaluate(orbit.x));
  EXPECT_EQ(equations.residual(), once.residual());
  EXPECT_EQ(equations.jacobian(), J);
  EXPECT_EQ(equations.monodromy(), once.monodromy());
  EXPECT_EQ(equations.state_at(1.0), once.state_at(1.0));
  EXPECT_EQ(equations.frequency(), once.frequency());
  ASSERT_TRUE(equations.evaluate(beside));
  EXPECT_NE(equations.residual(), once.residual()) << "elsewhere they are evaluated anew";
}

}  // namespace
}  // namespace signorini::extended_equations_test
