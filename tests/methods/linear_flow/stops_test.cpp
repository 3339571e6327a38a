// Rigid and compliant stops against the equations that define their forces.

#include "methods/linear_flow/stops.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "methods/linear_flow/contact_dynamics.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::stops_test {
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

TEST(Stops, RigidOnesHoldTheirContactsAndLeaveTheOthers) {
  const ContactDynamics dynamics(chain(kRigid));
  const FlowStructure& structure = dynamics.structure();
  const State state = some_state(4);
  for (const std::vector<bool>& closed : {std::vector{true, false}, std::vector{true, true}}) {
    Eigen::VectorXd a(4), free(4);
    dynamics.acceleration(dynamics.mode(closed), 0.3, state.u, state.v, a);
    dynamics.acceleration(dynamics.mode({false, false}), 0.3, state.u, state.v, free);
    const Eigen::VectorXd at_contacts = structure.directions.transpose() * a;
    EXPECT_NEAR(at_contacts[0], 0.0, 1e-14);
    // M (a - free) is a combination of the directions of closed contacts.
    const MotionDerivatives motion = dynamics.derivatives(dynamics.mode(closed), 0.3, state, 2);
    EXPECT_LT((structure.mass * (a - free) - structure.directions * motion.lambda.col(0)).norm(), 1e-13);
    if (!closed[1]) {
      EXPECT_EQ(motion.lambda(1, 0), 0.0);
    }
  }
}

TEST(Stops, CompliantOnesPushWithTheirSprings) {
  const Problem problem = chain(kSprings);
  const ContactDynamics dynamics(problem);
  const State state = some_state(4);
  const MotionDerivatives motion = dynamics.derivatives(dynamics.mode({true, true}), 0.3, state, 3);
  const Eigen::VectorXd depth =
      dynamics.structure().directions.transpose() * state.u - dynamics.structure().gaps;
  const Eigen::VectorXd speed = dynamics.structure().directions.transpose() * state.v;
  const Eigen::Vector2d k(7.0, 30.0);
  for (int j = 0; j < 2; ++j) {
    EXPECT_NEAR(motion.lambda(j, 0), -k[j] * depth[j], 1e-13 * (1.0 + k[j]));
    EXPECT_NEAR(motion.lambda(j, 1), -k[j] * speed[j], 1e-13 * (1.0 + k[j]));
  }
}

TEST(Stops, ForcesAreTheFirstTwoDerivativesOfLambda) {
  for (const Law& law : {kRigid, kSprings}) {
    const ContactDynamics dynamics(chain(law));
    const State state = some_state(4);
    const ContactMode mode = dynamics.mode({false, true});
    const MotionDerivatives motion = dynamics.derivatives(mode, 0.3, state, 3);
    Eigen::VectorXd x = dynamics.structure().unloaded(0.3, state.u, 0);
    Eigen::VectorXd v = dynamics.structure().unloaded(0.3, state.v, 1), force, rate;
    dynamics.stops().forces(mode, 0.3, state, x, v, force, rate);
    EXPECT_LT((force - motion.lambda.col(0)).norm(), 1e-14);
    EXPECT_LT((rate - motion.lambda.col(1)).norm(), 1e-14);
    EXPECT_LT((x - motion.x.col(0)).norm() + (v - motion.x.col(1)).norm(), 1e-14);
  }
}

TEST(Stops, FreeFormsMeetTheConstraintWithEveryCoordinate) {
  const ContactDynamics rigid(chain(kRigid));
  const ContactMode mode = rigid.mode({true, true});
  const FreeForm form = rigid.stops().free_form(mode);
  const Eigen::MatrixXd& W = rigid.structure().directions;
  ASSERT_EQ(form.basis.cols(), 2);
  EXPECT_LT((form.basis.transpose() * form.basis - Eigen::Matrix2d::Identity()).norm(), 1e-15);
  EXPECT_LT((W.transpose() * form.basis).norm(), 1e-15);
  EXPECT_LT((W.transpose() * form.offset - rigid.structure().gaps).norm(), 1e-15);
  EXPECT_EQ(rigid.stops().stiffness(mode), Eigen::MatrixXd(rigid.structure().stiffness));

  const ContactDynamics springs(chain(kSprings));
  const ContactMode pressed = springs.mode({true, true});
  const FreeForm sprung = springs.stops().free_form(pressed);
  EXPECT_EQ(sprung.basis.cols(), 4);
  const Eigen::MatrixXd added =
      springs.stops().stiffness(pressed) - Eigen::MatrixXd(springs.structure().stiffness);
  const Eigen::Vector2d k(7.0, 30.0);
  EXPECT_LT((added - W * k.asDiagonal() * W.transpose()).norm(), 1e-13);
  EXPECT_LT(
      ((sprung.load - springs.structure().load).col(0).real() - W * k.cwiseProduct(rigid.structure().gaps))
          .norm(),
      1e-13);
}

TEST(Stops, ACloserSpringMakesTheMotionFaster) {
  const double k = 900.0, m = 2.0;
  Problem problem = test::to_problem({.mass = m, .frequency = 1.5, .gap = 0.1});
  problem.set_law(Penalty{{k}});
  const ContactDynamics dynamics(problem);
  EXPECT_NEAR(dynamics.stops().fastest_rate(dynamics.mode({true}), 3.0), std::hypot(3.0, std::sqrt(k / m)),
              1e-12);
  EXPECT_EQ(dynamics.stops().fastest_rate(dynamics.mode({false}), 3.0), 3.0);
}

}  // namespace
}  // namespace signorini::stops_test
