// Stops and bases that move, against orbits of one mass told in coordinates at rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/moving_frame.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::moving_stop_test {
namespace {

using test::solve;
using Complex = std::complex<double>;

constexpr double kDamping = 0.1, kFrequency = 2.2, kGap = 0.2;
constexpr double kPeriod = 2.0 * std::numbers::pi / kFrequency;

// gamma(t) and its derivative: two harmonics.
const std::vector<StopTerm> kMotion{{.cos = 0.04, .sin = -0.06}, {.harmonic = 2, .cos = 0.015}};

double stop_at(double time, int derivative = 0) {
  Complex sum = 0.0;
  for (const StopTerm& term : kMotion) {
    const double w = term.harmonic * kFrequency;
    sum += std::pow(Complex(0.0, w), derivative) * Complex(term.cos, -term.sin) * std::polar(1.0, w * time);
  }
  return sum.real();
}

Problem scene(double restitution) {
  Problem problem = test::to_problem(
      {.damping = kDamping, .frequency = kFrequency, .gap = kGap, .restitution = restitution});
  move_stops(problem, kMotion);
  return problem;
}

// One impact per period: x(t) = x_lin(t) - J G(t - t0), G the periodic response of the mass to a unit impulse
// in closed form, in coordinates at rest. Newton's law of the velocities relative to the stop closes it.
class OrbitAtRest {
 public:
  OrbitAtRest(double restitution, double impact) : e_(restitution), impact_(impact) {
    impulse_ = (linear(impact) - kGap - stop_at(impact)) / green(0.0);
  }
  [[nodiscard]] double residual() const {
    const double before = velocity_before() - stop_at(impact_, 1),
                 after = velocity_after() - stop_at(impact_, 1);
    return after + e_ * before;
  }
  [[nodiscard]] bool admissible() const {
    if (!(impulse_ > 0.0) || !(velocity_before() > stop_at(impact_, 1))) return false;
    constexpr int kInstants = 2000;
    for (int i = 1; i < kInstants; ++i) {
      const double t = impact_ + i * kPeriod / kInstants;
      if (x(t) > kGap + stop_at(t)) return false;
    }
    return true;
  }
  [[nodiscard]] double x(double time) const { return linear(time) - impulse_ * green(time - impact_); }
  [[nodiscard]] double impulse() const { return impulse_; }

 private:
  static double linear(double time, int derivative = 0) {
    const Complex i_w(0.0, kFrequency);
    const Complex amplitude = 1.0 / (1.0 + i_w * i_w + kDamping * i_w);
    return (amplitude * std::pow(i_w, derivative) * std::polar(1.0, kFrequency * time)).real();
  }
  // Right-sided at multiples of the period, left-sided at -0.
  static double green(double time, int derivative = 0, bool left = false) {
    const double turns = std::floor(time / kPeriod);
    const double tau = left ? kPeriod : time - turns * kPeriod;
    const double decay = 0.5 * kDamping, w = std::sqrt(1.0 - decay * decay);
    const Complex mu(-decay, w);
    return (std::pow(mu, derivative) * std::exp(mu * tau) / (1.0 - std::exp(mu * kPeriod))).imag() / w;
  }
  [[nodiscard]] double velocity_before() const { return linear(impact_, 1) - impulse_ * green(0.0, 1, true); }
  [[nodiscard]] double velocity_after() const { return linear(impact_, 1) - impulse_ * green(0.0, 1); }

  double e_, impact_, impulse_ = 0.0;
};

std::vector<OrbitAtRest> orbits_at_rest(double restitution) {
  constexpr int kInstants = 4000;
  std::vector<OrbitAtRest> found;
  const auto residual = [&](double t) { return OrbitAtRest(restitution, t).residual(); };
  for (int i = 0; i < kInstants; ++i) {
    double low = i * kPeriod / kInstants, high = (i + 1) * kPeriod / kInstants;
    const bool rises = residual(low) < 0.0;
    if (rises == (residual(high) < 0.0)) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      ((residual(middle) < 0.0) == rises ? low : high) = middle;
    }
    if (const OrbitAtRest orbit(restitution, low); orbit.admissible()) found.push_back(orbit);
  }
  return found;
}

// Largest distance of x, which is told from the stop, to one of the orbits at rest [m].
double distance(const Trajectory& trajectory, const std::vector<OrbitAtRest>& orbits) {
  constexpr int kInstants = 1000;
  const Eigen::VectorXd x = trajectory.sample(kInstants).x.col(0);
  double least = 1e300;
  for (const OrbitAtRest& orbit : orbits) {
    double largest = 0.0;
    for (int i = 0; i < kInstants; ++i) {
      const double t = i * kPeriod / kInstants;
      largest = std::max(largest, std::abs(x[i] + stop_at(t) - orbit.x(t)));
    }
    least = std::min(least, largest);
  }
  return least;
}

TEST(MovingStop, OrbitsAreThoseInCoordinatesAtRest) {
  for (const double e : {0.0, 0.5, 0.8, 1.0}) {
    SCOPED_TRACE(e);
    const auto orbits = orbits_at_rest(e);
    ASSERT_FALSE(orbits.empty());
    const Solution exact = test::solve<ExactOrbitMethod>(scene(e), {});
    ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
    EXPECT_LT(distance(*exact.trajectory, orbits), 1e-10);
    const auto impulses = exact.trajectory->impulses();
    ASSERT_EQ(impulses.size(), 1U);
    const Solution marched = test::solve<EventDriven>(scene(e), {});
    ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
    EXPECT_LT(distance(*marched.trajectory, orbits), 1e-6);
  }
}

TEST(MovingStop, IsMetByMethodsOfTimeAndOfFrequency) {
  const auto orbits = orbits_at_rest(0.8);
  const Solution series = test::solve<ClosedHbm>(scene(0.8), {.harmonics = 80});
  ASSERT_EQ(series.verdict, Verdict::converged) << series.message;
  EXPECT_LT(distance(*series.trajectory, orbits), 2e-3) << "what 80 harmonics cut off at a kink";
  std::vector<double> errors;
  for (const int samples : {256, 1024}) {
    const Solution nodal = test::solve<HatLcp>(scene(0.8), {.samples = samples});
    ASSERT_EQ(nodal.verdict, Verdict::converged) << nodal.message;
    errors.push_back(distance(*nodal.trajectory, orbits));
  }
  EXPECT_LT(errors.back(), 0.5 * errors.front());
  EXPECT_LT(errors.back(), 2e-2);
}

// The wall and the stop move together: told from them, nothing moves but inertia. Told at rest, the wall
// pulls at spring and damper, and the stop moves.
TEST(MovingBase, IsTheSameMotionToldAtRest) {
  constexpr double kCos = 0.3, kSin = -0.2;
  Problem relative = test::to_problem(
      {.damping = kDamping, .load = 0.0, .frequency = kFrequency, .gap = 0.1, .restitution = 0.7});
  Problem at_rest = relative;
  move_base(relative, Eigen::VectorXd::Ones(1), {{.cos = kCos, .sin = kSin}});
  at_rest.force = {{.dof = 0, .cos = kCos, .sin = kSin},
                   {.dof = 0, .cos = kDamping * kSin, .sin = -kDamping * kCos, .omega_power = 1}};
  move_stops(at_rest, {{.cos = kCos, .sin = kSin}});
  const Solution a = test::solve<ExactOrbitMethod>(relative, {}),
                 b = test::solve<ExactOrbitMethod>(at_rest, {});
  ASSERT_EQ(a.verdict, Verdict::converged) << a.message;
  ASSERT_EQ(b.verdict, Verdict::converged) << b.message;
  ASSERT_FALSE(a.trajectory->impulses().empty());
  EXPECT_LT(test::relative_distance(*a.trajectory, *b.trajectory), 1e-11);
}

// A spring that stands on a moving wall is a force that follows it.
TEST(MovingStop, OfASpringIsTheSpringsForceAtRest) {
  constexpr double kStiffness = 50.0;
  Problem problem = scene(1.0);
  problem.set_law(Penalty{{kStiffness}});
  const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  // The equation of motion at rest, by differences of the absolute displacement.
  constexpr int kInstants = 20000;
  const Samples samples = solution.trajectory->sample(kInstants);
  const double step = kPeriod / kInstants;
  const auto x = [&](int i) {
    const int k = (i + kInstants) % kInstants;
    return samples.x(k, 0) + stop_at(k * step);
  };
  double worst = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const double acceleration = (x(i + 1) - 2.0 * x(i) + x(i - 1)) / (step * step);
    const double velocity = (x(i + 1) - x(i - 1)) / (2.0 * step);
    const double push = kStiffness * std::max(0.0, x(i) - kGap - stop_at(i * step));
    worst = std::max(
        worst, std::abs(acceleration + kDamping * velocity + x(i) - std::cos(kFrequency * i * step) + push));
  }
  EXPECT_LT(worst, 2e-3) << "the force has kinks, where differences err by a slope times a step";
}

}  // namespace
}  // namespace signorini::moving_stop_test
