// Returning states against their closed form, and where there is none of its own.

#include "methods/orbit/periodic_closure.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "methods/orbit/orbit_equations.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::periodic_closure_test {
namespace {

PeriodicClosure closure_of(OrbitModel& model) {
  return {model.flows.of({false}), model.dynamics.scales(), model.dynamics.structure().forcing_period};
}

// A unit impulse once in a period T: of an undamped oscillator x = cos(w T / 2 - w t) / (2 m w sin(w T / 2)).
TEST(PeriodicClosure, AnswersPeriodicImpulsesInClosedForm) {
  OrbitModel model(test::to_problem({.mass = 2.0, .damping = 0.0, .stiffness = 5.0, .frequency = 2.2}));
  const PeriodicClosure closure = closure_of(model);
  ASSERT_TRUE(closure.unique());
  const double w = std::sqrt(2.5), T = 2.0 * std::numbers::pi / 2.2;
  const Eigen::VectorXd y = closure.solve(Eigen::Vector2d(0.0, 0.5));
  EXPECT_NEAR(y[0], 1.0 / (4.0 * w * std::tan(0.5 * w * T)), 1e-13);
  EXPECT_NEAR(y[1], 0.25, 1e-13);
}

TEST(PeriodicClosure, TellsWhereMotionsReturnByThemselves) {
  const auto unique = [](double damping, double frequency) {
    OrbitModel model(
        test::to_problem({.damping = damping, .stiffness = 4.0, .frequency = frequency, .gap = 1e-6}));
    return closure_of(model).unique();
  };
  EXPECT_FALSE(unique(0.0, 2.0));
  EXPECT_FALSE(unique(0.0, 1.0));  // in two of its own periods
  EXPECT_TRUE(unique(0.0, 4.0));   // in two periods of the load
  EXPECT_TRUE(unique(0.0, 2.0 * (1.0 + 1e-8)));
  EXPECT_TRUE(unique(1e-6, 2.0));
}

// One mode of several: the others do not hide it.
TEST(PeriodicClosure, TellsAResonanceOfOneModeOfMany) {
  Problem chain = test::stopped_chain(3, 1.0, 1);
  chain.edit_structure([](Structure& structure) { structure.damping = SparseMatrix(3, 3); });
  const Eigen::MatrixXd M(chain.mass()), K(chain.stiffness());
  const Eigen::VectorXd squares = generalised_eigen(K, M).values;
  for (int mode = 0; mode < 3; ++mode) {
    chain.frequency = std::sqrt(squares[mode]);
    OrbitModel resonant(chain);
    EXPECT_FALSE(closure_of(resonant).unique()) << mode;
    chain.frequency *= 1.001;
    OrbitModel beside(chain);
    EXPECT_TRUE(closure_of(beside).unique()) << mode;
  }
}

}  // namespace
}  // namespace signorini::periodic_closure_test
