#include "methods/structure/periodic_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::periodic_response_test {
namespace {

/// A force that is nothing but impulses.
class Impacts final : public Trajectory {
 public:
  Impacts(double period, std::vector<Impulse> impulses) : period_(period), impulses_(std::move(impulses)) {}
  [[nodiscard]] int contact_count() const override { return 1; }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override {
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, 1);
    return {zero, zero, zero};
  }
  [[nodiscard]] std::vector<Impulse> impulses() const override { return impulses_; }

 private:
  double period_;
  std::vector<Impulse> impulses_;
};

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

TEST(PeriodicResponse, WithoutContactIsTheLinearResponse) {
  const Problem problem = test::to_problem(kStop);
  const PeriodicResponse response(problem, Impacts(problem.period(), {}));
  const std::complex<double> amplitude = 1.0 / std::complex<double>(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  for (const double t : {0.0, 0.3, 2.0}) {
    const std::complex<double> u = amplitude * std::polar(1.0, 2.2 * t);
    EXPECT_NEAR(response.at(t).u[0], u.real(), 1e-14);
    EXPECT_NEAR(response.at(t).v[0], -2.2 * u.imag(), 1e-14);
  }
}

TEST(PeriodicResponse, OfAnImpulseIsTheClosedFormOrbit) {
  const Problem problem = test::to_problem(kStop);
  const auto orbit = test::single_impact_orbits(kStop).front();
  const PeriodicResponse response(problem, Impacts(orbit.period, {{0, orbit.impact_time, -orbit.impulse}}),
                                  4000);
  for (const double after : {0.2, 0.5, 0.8}) {
    const double t = std::fmod(orbit.impact_time + after * orbit.period, orbit.period);
    // The kink's series converges like 1/H^2 in u and 1/H in v away from the impact.
    EXPECT_NEAR(response.at(t).u[0], orbit.x(t), 1e-6);
    EXPECT_NEAR(response.at(t).v[0], orbit.velocity(t), 1e-3);
  }
  const Eigen::MatrixXd u = response.displacement(16);
  EXPECT_NEAR(u(5, 0), orbit.x(5 * orbit.period / 16), 1e-4);
}

TEST(PeriodicResponse, AcceptsSubharmonicsAndRefusesForeignPeriods) {
  const Problem problem = test::to_problem(kStop);
  const PeriodicResponse once(problem, Impacts(problem.period(), {}));
  const PeriodicResponse thrice(problem, Impacts(3 * problem.period(), {}));
  EXPECT_NEAR(once.at(0.4).u[0], thrice.at(0.4).u[0], 1e-14);
  EXPECT_THROW(PeriodicResponse(problem, Impacts(1.3 * problem.period(), {})), std::invalid_argument);
}

/// The contact of test::bouncing_ball struck once a period, with the mean of x.
class Bounces final : public Trajectory {
 public:
  Bounces(double instant, double mean) : instant_(instant), mean_(mean) {}
  [[nodiscard]] int contact_count() const override { return 1; }
  [[nodiscard]] double period() const override { return test::bouncing_ball().period(); }
  [[nodiscard]] Samples sample(int count) const override {
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, 1);
    return {Eigen::MatrixXd::Constant(count, 1, mean_), zero, zero};
  }
  [[nodiscard]] std::vector<Impulse> impulses() const override {
    return {{.contact = 0, .time = instant_, .value = -test::kBallImpulse}};
  }

 private:
  double instant_, mean_;
};

// u = A (cos w t - cos w t_0) + g s (s - T) / 2, s = t - t_0 the time since the impact at t_0.
TEST(PeriodicResponse, OfAFreeBodyHasTheMeanOfItsContacts) {
  constexpr double kInstant = 0.1, kGravity = 9.81, kAmplitude = 0.05;
  const Problem ball = test::bouncing_ball();
  const double w = ball.frequency, T = ball.period(), rest = kAmplitude * std::cos(w * kInstant);
  const PeriodicResponse response(ball, Bounces(kInstant, -rest - kGravity * T * T / 12.0), 4000);
  for (const double since : {0.1 * T, 0.5 * T, 0.8 * T}) {
    const double t = kInstant + since;
    const double flight = 0.5 * kGravity * since * (since - T);
    EXPECT_NEAR(response.at(t).u[0], kAmplitude * std::cos(w * t) - rest + flight, 1e-6);
    EXPECT_NEAR(response.at(t).v[0], -kAmplitude * w * std::sin(w * t) + kGravity * (since - 0.5 * T), 1e-3);
  }
}

TEST(HarmonicsOfForce, OfSeveralPeriodsOfTheLoadHoldThoseOfTheLoad) {
  const Problem problem = test::to_problem(kStop);
  const double period = 3.0 * problem.period();
  const ForceSeries series = force_series(problem, Impacts(period, {{0, 0.25 * period, -2.0}}), 2);
  EXPECT_EQ(series.order, 3);
  ASSERT_EQ(series.lambda.rows(), 1 + 3) << "the load is harmonic 3 of three of its periods";
  for (int n = 0; n <= 3; ++n) {
    const std::complex<double> exact = -2.0 / period * std::polar(1.0, -0.5 * std::numbers::pi * n);
    EXPECT_LT(std::abs(series.lambda(n, 0) - exact), 1e-14) << n;
  }
}

TEST(PressureSamples, PutsAnImpulseOnTheNearestInstant) {
  // Late in the period the nearest of eight instants is the first of the next.
  const Impacts motion(
      2.0, {{.contact = 0, .time = 0.6, .value = -3.0}, {.contact = 0, .time = 1.9, .value = -1.0}});
  const Eigen::VectorXd pressure = pressure_samples(motion, 8, Eigen::VectorXd::Constant(1, 2.0));
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(8);
  expected[2] = 3.0 / 0.25 / 2.0;
  expected[0] = 1.0 / 0.25 / 2.0;
  EXPECT_TRUE(pressure.isApprox(expected)) << pressure.transpose();
}

}  // namespace
}  // namespace signorini::periodic_response_test
