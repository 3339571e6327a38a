#include "methods/linear_flow/mode_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>

#include "tests/support/exact_scenes.hpp"

namespace signorini::mode_equations_test {
namespace {

Problem chain(const Law& law) {
  Problem problem = test::stopped_chain(4, 0.5, 2);
  problem.set_law(law);
  return problem;
}

const Law kRigid = Restitution{0.5};
const Law kSprings = Penalty{{7.0, 30.0}};

State some_state(int n) {
  return {.u = Eigen::VectorXd::LinSpaced(n, 0.4, -0.3), .v = Eigen::VectorXd::LinSpaced(n, -0.2, 0.6)};
}

TEST(ModeEquations, OutputsAreDisplacementsAndTheForcesOfClosedContacts) {
  for (const Law& law : {kRigid, kSprings}) {
    const ContactDynamics dynamics(chain(law));
    const ModeEquations equations(dynamics, dynamics.mode({false, true}));
    EXPECT_EQ(equations.force_row(0), -1);
    ASSERT_EQ(equations.force_row(1), 2);
    const State state = some_state(4);
    const double time = 0.3;
    Eigen::VectorXd y(8);
    y << state.u, state.v;
    Eigen::VectorXd output = equations.output_of_state * y;
    for (Eigen::Index h = 0; h < equations.harmonics(); ++h) {
      const auto wave = std::polar(1.0, equations.rates()[static_cast<std::size_t>(h)] * time);
      output += (equations.output_of_load.col(h) * wave).real();
    }
    const MotionDerivatives motion = dynamics.derivatives(equations.mode, time, state, 2);
    EXPECT_NEAR(output[0], motion.x(0, 0), 1e-14);
    EXPECT_NEAR(output[1], motion.x(1, 0), 1e-14);
    EXPECT_NEAR(output[2], motion.lambda(1, 0), 1e-13);
  }
}

TEST(ModeEquations, ReducedLoadBalancesAStructureAtRestOnItsStops) {
  // With q = 0 what is left of the load is f_0 - K u_g in the free directions.
  const ContactDynamics dynamics(chain(kRigid));
  const ModeEquations equations(dynamics, dynamics.mode({true, true}));
  const Eigen::VectorXd expected =
      equations.form.basis.transpose() *
      (equations.form.load.col(0).real() - dynamics.structure().stiffness * equations.form.offset);
  EXPECT_LT((equations.reduced_load(0).real() - expected).norm(), 1e-14);
  EXPECT_LT(
      (equations.reduced_load(1) - equations.form.basis.transpose() * equations.form.load.col(1)).norm(),
      1e-14);
}

}  // namespace
}  // namespace signorini::mode_equations_test
