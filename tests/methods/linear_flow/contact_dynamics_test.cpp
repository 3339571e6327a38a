#include "methods/linear_flow/contact_dynamics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/methods/event_driven/scenes.hpp"

namespace signorini::contact_dynamics_test {
namespace {

using test::free_chain;
using test::two_masses;

State some_state(int size) {
  State state{.u = Eigen::VectorXd::LinSpaced(size, 0.3, -0.2),
              .v = Eigen::VectorXd::LinSpaced(size, -0.1, 0.5)};
  return state;
}

TEST(ContactDynamics, AccelerationSolvesTheEquationOfMotionForSmallAndLargeStructures) {
  for (const int size : {3, 40}) {  // the second takes the sparse path
    const Problem problem = free_chain(size, 1.3);
    const ContactDynamics dynamics(problem);
    const State state = some_state(size);
    Eigen::VectorXd a(size);
    dynamics.acceleration(dynamics.mode({}), 0.7, state.u, state.v, a);
    const Eigen::VectorXd balance = problem.mass() * a + problem.damping() * state.v +
                                    problem.stiffness() * state.u - load_at(problem, 0.7);
    EXPECT_LT(balance.norm(), 1e-13 * load_at(problem, 0.7).norm() + 1e-13) << size;
  }
}

// Small and large, rigid: another frequency of the load against a scene with that frequency.
TEST(ContactDynamics, MayChangeTheFrequencyOfTheLoadAlone) {
  for (const int size : {3, 40}) {
    const ContactDynamics changed(ContactDynamics(free_chain(size, 1.3)), 1.7);
    const ContactDynamics own(free_chain(size, 1.7));
    EXPECT_EQ(changed.structure().rates, own.structure().rates);
    EXPECT_EQ(changed.structure().forcing_period, own.structure().forcing_period);
    EXPECT_EQ(changed.structure().fastest_rate, own.structure().fastest_rate);
    const State state = some_state(size);
    Eigen::VectorXd a(size), b(size);
    changed.acceleration(changed.mode({}), 0.7, state.u, state.v, a);
    own.acceleration(own.mode({}), 0.7, state.u, state.v, b);
    EXPECT_LT((a - b).norm(), 1e-14 * b.norm());
  }
}

TEST(ContactDynamics, StickingMultiplierOfOneMassIsTheBalanceOfItsForces) {
  const Problem problem = to_problem(test::ImpactOscillator{.frequency = 0.9, .gap = 0.2});
  const ContactDynamics dynamics(problem);
  const State state{.u = Eigen::VectorXd::Constant(1, 0.2), .v = Eigen::VectorXd::Zero(1)};
  const MotionDerivatives motion = dynamics.derivatives(dynamics.mode({true}), 0.4, state, 4);
  EXPECT_NEAR(motion.lambda(0, 0), 0.2 - std::cos(0.36), 1e-15);  // lambda = k g - f
  EXPECT_NEAR(motion.lambda(0, 1), 0.9 * std::sin(0.36), 1e-15);
  EXPECT_NEAR(motion.lambda(0, 2), 0.81 * std::cos(0.36), 1e-15);
  EXPECT_NEAR(motion.u(0, 2), 0.0, 1e-15);
}

// In each mode the derivatives must be those of one another along the flow: compared by central differences
// of the exact Taylor shift of the state.
TEST(ContactDynamics, DerivativesAgreeWithDifferencesAlongTheMotion) {
  Problem rigid = two_masses(1.1, 0.5);
  Problem spring = rigid;
  spring.set_law(Penalty{{7.0}});
  for (const Problem& problem : {rigid, spring}) {
    const ContactDynamics dynamics(problem);
    for (const bool closed : {false, true}) {
      const ContactMode mode = dynamics.mode({closed});
      State state = some_state(2);
      if (closed) {
        state.u[1] = 0.5;
        state.v[1] = 0.0;
      }
      const MotionDerivatives here = dynamics.derivatives(mode, 0.3, state, 7);
      constexpr double kStep = 1e-3;
      constexpr double kTolerance = 10.0 * kStep * kStep;
      const auto shifted = [&](double s) {
        State moved{.u = Eigen::VectorXd::Zero(2), .v = Eigen::VectorXd::Zero(2)};
        double power = 1.0;
        for (int k = 0; k <= 6; ++k) {
          moved.u += power * here.u.col(k);
          moved.v += power * here.u.col(k + 1);
          power *= s / (k + 1);
        }
        return dynamics.derivatives(mode, 0.3 + s, moved, 7);
      };
      const MotionDerivatives ahead = shifted(kStep), behind = shifted(-kStep);
      for (int k = 2; k < 6; ++k) {
        const Eigen::VectorXd slope = (ahead.u.col(k) - behind.u.col(k)) / (2.0 * kStep);
        EXPECT_LT((slope - here.u.col(k + 1)).norm(), kTolerance * (1.0 + slope.norm()))
            << "derivative " << k << " closed " << closed;
      }
      for (int k = 0; k < 4; ++k) {
        const double slope = (ahead.lambda(0, k) - behind.lambda(0, k)) / (2.0 * kStep);
        EXPECT_NEAR(slope, here.lambda(0, k + 1), kTolerance * (1.0 + std::abs(slope)))
            << "force derivative " << k << " closed " << closed;
      }
    }
  }
}

TEST(ContactDynamics, FlowMatrixIsTheDerivativeOfTheAcceleration) {
  for (const Law& law : {Law(Restitution{0.5}), Law(Penalty{{7.0}})}) {
    Problem problem = two_masses(1.1, 0.5);
    problem.set_law(law);
    const ContactDynamics dynamics(problem);
    const ContactMode mode = dynamics.mode({true});
    const Eigen::MatrixXd B = dynamics.flow_matrix(mode);
    const State state = some_state(2);
    for (int column = 0; column < 4; ++column) {
      Eigen::VectorXd y(4), plus(2), minus(2);
      y << state.u, state.v;
      y[column] += 0.5;
      dynamics.acceleration(mode, 0.2, y.head(2), y.tail(2), plus);
      y[column] -= 1.0;
      dynamics.acceleration(mode, 0.2, y.head(2), y.tail(2), minus);
      EXPECT_LT((plus - minus - B.col(column).tail(2)).norm(), 1e-13);
    }
  }
}

TEST(ContactDynamics, ScalesAreThoseOfTheLimitedMotionNearAResonance) {
  // Lightly damped at resonance: the linear response is 300 times the stop's gap and means nothing.
  const ContactDynamics dynamics(
      to_problem(test::ImpactOscillator{.damping = 0.003, .frequency = 1.0, .gap = 0.4}));
  EXPECT_GE(dynamics.scales().displacement, 0.4);
  EXPECT_LT(dynamics.scales().displacement, 2.0);
  // Without contact it is the scale.
  Problem free = to_problem(test::ImpactOscillator{.damping = 0.01, .frequency = 1.0});
  free.contacts.clear();
  free.set_law(std::monostate{});
  EXPECT_NEAR(ContactDynamics(free).scales().displacement, 100.0, 1e-9);
}

TEST(ContactDynamics, RefusesDampingOfACoordinateWithoutMassThatIsNotThatOfItsStiffness) {
  Problem problem = two_masses(1.0, 0.5);
  problem.edit_structure([&](Structure& s) {
    s.mass = SparseMatrix(2, 2);
    s.mass.insert(0, 0) = 1.0;
    s.damping.coeffRef(1, 1) *= 2.0;
  });
  EXPECT_THROW(ContactDynamics{problem}, std::runtime_error);
}

}  // namespace
}  // namespace signorini::contact_dynamics_test
