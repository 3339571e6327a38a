#include "methods/orbit/modal_green_function.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::modal_green_function_test {
namespace {

using test::cold_orbit;

TEST(ModalGreenFunction, IsTheClosedFormOfOneMass) {
  const Problem problem = test::to_problem({.damping = 0.1, .load = 0.0, .frequency = 2.2, .gap = 0.2});
  const double T = problem.period(), wd = std::sqrt(1.0 - 0.05 * 0.05);
  const ContactDynamics dynamics(problem);
  const ModalGreenFunction green(dynamics, T);
  ASSERT_TRUE(green.defined());
  const std::vector<Impulse> unit{{.contact = 0, .time = 0.0, .value = 1.0}};
  const std::complex<double> mu(-0.05, wd);
  for (const double tau : {0.0, 0.3, 1.7, 2.8}) {
    const State after = green.state(tau, unit);
    EXPECT_NEAR(after.u[0], (std::exp(mu * tau) / (1.0 - std::exp(mu * T))).imag() / wd, 1e-13);
    EXPECT_NEAR(after.v[0], (mu * std::exp(mu * tau) / (1.0 - std::exp(mu * T))).imag() / wd, 1e-13);
  }
  EXPECT_NEAR(green.state(0.0, unit).v[0] - green.state(T - 1e-9, unit).v[0], 1.0, 1e-8);  // the jump 1 / m
}

// Without contacts nothing strikes, and the motion is the response to the load.
TEST(ModalGreenFunction, WithoutContactsIsTheForcedMotion) {
  Problem problem = test::to_problem({.damping = 0.1, .load = 1.0, .frequency = 2.2, .gap = 0.2});
  problem.contacts.clear();
  problem.set_law({});
  const ContactDynamics dynamics(problem);
  const ModalGreenFunction green(dynamics, problem.period());
  ASSERT_TRUE(green.defined());
  const std::complex<double> z(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  double largest = 0.0;
  for (int i = 0; i < 2000; ++i)
    largest = std::max(largest, std::abs(green.state(problem.period() * i / 2000, {}).u[0]));
  EXPECT_NEAR(largest, 1.0 / std::abs(z), 1e-5);
}

TEST(ModalGreenFunction, SumsUpToTheExactOrbitsOfChains) {
  for (const double e : {0.4, 0.9}) {
    const Problem problem = test::stopped_chain(4, e, 2, 1.3);
    const auto found = cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    const ContactDynamics dynamics(problem);
    const ModalGreenFunction green(dynamics, problem.period());
    for (int i = 0; i < 50; ++i) {
      const double t = problem.period() * (i + 0.3) / 50;
      const State a = green.state(t, found.orbit->impulses()), b = found.orbit->at(t);
      EXPECT_LT((a.u - b.u).norm(), 1e-11 * (1.0 + b.u.norm()));
      EXPECT_LT((a.v - b.v).norm(), 1e-11 * (1.0 + b.v.norm()));
    }
  }
}

// Free vibration against an elastic stop (oracle 1b): amplitude A, frequency pi w0 / (pi - arccos(g / A)),
// speed w0 sqrt(A^2 - g^2) at the stop; with one impulse of twice the momentum per period the Green's
// function is it.
TEST(ModalGreenFunction, ContainsTheBackboneOfTheUndampedOscillator) {
  const struct {
    double ratio, frequency;  // g / A, omega / w0 as tabulated
  } rows[] = {{0.5, 1.5}, {0.0, 2.0}, {-0.5, 3.0}, {0.9, 1.16763270}, {-0.9, 6.96542328}};
  for (const auto& [ratio, frequency] : rows) {
    EXPECT_NEAR(std::numbers::pi / (std::numbers::pi - std::acos(ratio)), frequency, 1e-8);
    const double exact = std::numbers::pi / (std::numbers::pi - std::acos(ratio));
    const test::ImpactOscillator o{.damping = 0.0, .load = 0.0, .frequency = exact, .gap = ratio};
    const ContactDynamics dynamics(test::to_problem(o));
    const ModalGreenFunction green(dynamics, 2.0 * std::numbers::pi / exact);
    ASSERT_TRUE(green.defined());
    const double speed = std::sqrt(1.0 - ratio * ratio);
    const State after = green.state(0.0, {{.contact = 0, .time = 0.0, .value = -2.0 * speed}});
    EXPECT_NEAR(after.u[0], ratio, 1e-12);
    EXPECT_NEAR(after.v[0], -speed, 1e-12);
    const State far =
        green.state(std::numbers::pi / exact, {{.contact = 0, .time = 0.0, .value = -2.0 * speed}});
    EXPECT_NEAR(far.u[0], -1.0, 1e-12);
    EXPECT_NEAR(far.v[0], 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace signorini::modal_green_function_test
