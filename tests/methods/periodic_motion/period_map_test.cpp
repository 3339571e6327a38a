// Fixed points of the stroboscopic map against closed forms.

#include "methods/periodic_motion/period_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::period_map_test {
namespace {

using test::ImpactOscillator;

const auto kNever = [] { return false; };

State state_of(double u, double v) {
  return {.u = Eigen::VectorXd::Constant(1, u), .v = Eigen::VectorXd::Constant(1, v)};
}

struct Map {
  explicit Map(const Problem& problem)
      : dynamics(problem), flow(dynamics, 1e-12, kNever, Integrator::modal), map(flow) {}
  ContactDynamics dynamics;
  EventFlow flow;
  PeriodMap map;
};

TEST(PeriodMap, ScalesAndUnscalesStates) {
  const Map one(test::to_problem({.frequency = 2.2, .gap = 0.2}));
  const State state = state_of(0.3, -1.7);
  const Eigen::VectorXd scaled = one.map.scaled(state);
  EXPECT_NEAR(scaled[0], 0.3 / one.dynamics.scales().displacement, 1e-15);
  EXPECT_NEAR(one.map.unscaled(scaled).v[0], -1.7, 1e-15);
  EXPECT_NEAR(one.dynamics.scales().distance(state, state_of(0.3, -1.5)),
              0.2 / one.dynamics.scales().velocity, 1e-14);
}

TEST(PeriodMap, CountsPeriodsAndKeepsThePhase) {
  Map one(test::to_problem({.frequency = 2.2, .gap = 5.0}));
  FlowState state = one.flow.place(0.4, state_of(0.1, 0.0));
  FlowRecord record;
  one.map.apply(state, 3, record);
  EXPECT_EQ(state.time, 0.4);
  EXPECT_EQ(one.map.periods(), 3);
}

// A linear map: one Newton step from anywhere, the multipliers are e^{mu T}.
TEST(FixedPoint, OfTheMotionWithoutContactIsTheLinearResponse) {
  const double d = 0.1, w = 2.2;
  Map one(test::to_problem({.damping = d, .frequency = w, .gap = 50.0}));
  const FixedPoint point =
      find_fixed_point(one.map, one.flow.place(0.0, state_of(1.0, -1.0)), 1, {.accepted = 1e-10}, kNever);
  ASSERT_TRUE(point.converged) << point.message;
  EXPECT_LE(point.iterations, 2);
  const std::complex<double> response = 1.0 / std::complex<double>(1.0 - w * w, d * w);
  EXPECT_NEAR(point.start.state.u[0], response.real(), 1e-12);
  EXPECT_NEAR(point.start.state.v[0], -w * response.imag(), 1e-12);
  EXPECT_NEAR(largest_magnitude(point.multipliers), std::exp(-0.5 * d * 2.0 * 3.14159265358979 / w), 1e-12);
}

TEST(FixedPoint, OfAnImpactOscillatorIsItsClosedFormOrbit) {
  const ImpactOscillator o{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};
  const auto orbit = test::single_impact_orbits(o).at(0);
  Map one(test::to_problem(o));
  const double section = orbit.impact_time + 0.4 * orbit.period;
  const FlowState guess =
      one.flow.place(section, state_of(orbit.x(section) + 0.01, orbit.velocity(section) - 0.01));
  const FixedPoint point =
      find_fixed_point(one.map, guess, 1, {.accepted = 1e-10, .max_halvings = 8}, kNever);
  ASSERT_TRUE(point.converged) << point.message;
  EXPECT_NEAR(point.start.state.u[0], orbit.x(section), 1e-11);
  EXPECT_NEAR(point.start.state.v[0], orbit.velocity(section), 1e-11);
  EXPECT_NEAR(point.monodromy.trace(), orbit.trace, 1e-9);
  EXPECT_NEAR(determinant(point.monodromy), orbit.determinant, 1e-9);
  EXPECT_GE(point.condition.value_or(0.0), 1.0);
}

TEST(FixedPoint, IsRefusedWithAReason) {
  // A free mass under a load with a mean drifts: P is a shear with the double multiplier 1, and moves all
  // states.
  Map free_mass(test::to_problem(
      {.damping = 0.0, .stiffness = 0.0, .frequency = 1.0, .gap = 500.0, .static_load = 1.0}));
  const FixedPoint singular =
      find_fixed_point(free_mass.map, free_mass.flow.place(0.0, state_of(0.0, 1.0)), 1, {}, kNever);
  EXPECT_FALSE(singular.converged);
  EXPECT_NE(singular.message.find("multiplier is 1"), std::string::npos) << singular.message;

  Map far(test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 5e3}));
  const FixedPoint refused =
      find_fixed_point(far.map, far.flow.place(0.0, state_of(100.0, 0.0)), 1, {.largest_step = 1e-3}, kNever);
  EXPECT_FALSE(refused.converged);
  EXPECT_NE(refused.message.find("neighbourhood"), std::string::npos) << refused.message;
}

}  // namespace
}  // namespace signorini::period_map_test
