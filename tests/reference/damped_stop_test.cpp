// Stops with a damper beside their spring, against arcs of one mass in closed form.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/orbit/exact_trajectory.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/damped_stops.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::damped_stop_test {
namespace {

using Complex = std::complex<double>;

constexpr double kDamping = 0.1, kFrequency = 2.2, kGap = 0.2;
constexpr double kPeriod = 2.0 * std::numbers::pi / kFrequency;

// m = 1: x'' + d x' + k x = P + F cos(w t) from a state at an instant, by its two exponentials.
class Arc {
 public:
  Arc(double damping, double stiffness, double constant, double load, double start, double x, double v)
      : start_(start), rest_(constant / stiffness) {
    const Complex root = std::sqrt(Complex(0.25 * damping * damping - stiffness));
    rates_ = {-0.5 * damping + root, -0.5 * damping - root};
    const Complex i_w(0.0, kFrequency);
    forced_ = load / (stiffness + i_w * i_w + damping * i_w);
    const Complex u = x - rest_ - real_part(start, 0), du = v - real_part(start, 1);
    parts_ = {(du - rates_[1] * u) / (rates_[0] - rates_[1]), (rates_[0] * u - du) / (rates_[0] - rates_[1])};
  }
  [[nodiscard]] double at(double time, int derivative = 0) const {
    Complex sum = derivative == 0 ? rest_ : 0.0;
    for (int i = 0; i < 2; ++i)
      sum += std::pow(rates_[i], derivative) * parts_[i] * std::exp(rates_[i] * (time - start_));
    return sum.real() + real_part(time, derivative);
  }

 private:
  [[nodiscard]] double real_part(double time, int derivative) const {
    const Complex i_w(0.0, kFrequency);
    return (forced_ * std::pow(i_w, derivative) * std::polar(1.0, kFrequency * time)).real();
  }
  double start_, rest_;
  std::array<Complex, 2> rates_ = {}, parts_ = {};
  Complex forced_;
};

// The first zero that f reaches from below after `from`.
double first_rise(const std::function<double(double)>& f, double from) {
  constexpr double kStep = kPeriod / 3000.0;
  double low = from + 1e-7 * kPeriod;
  while (!(f(low + kStep) > 0.0)) low += kStep;
  double high = low + kStep;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

struct Stop {
  double stiffness = 0.0, damping = 0.0;
};

// One contact of a mass with such a stop, from closing to closing: the stop pushes with k (x - g) + c x'
// until that is zero, and goes back by itself until the mass meets it again.
struct Bounce {
  Bounce(const Stop& stop, double load, double closing, double x, double v)
      : closes(closing),
        pushed(kDamping + stop.damping, 1.0 + stop.stiffness, stop.stiffness * kGap, load, closing, x, v),
        opens(first_rise([&](double t) { return -push(stop, t); }, closing)),
        flown(kDamping, 1.0, 0.0, load, opens, pushed.at(opens), pushed.at(opens, 1)),
        compressed(pushed.at(opens) - kGap),
        rate(stop.stiffness / stop.damping) {}
  [[nodiscard]] double push(const Stop& stop, double t) const {
    return stop.stiffness * (pushed.at(t) - kGap) + stop.damping * pushed.at(t, 1);
  }
  // What the stop is compressed by, after it was left.
  [[nodiscard]] double compression(double t) const { return compressed * std::exp(-rate * (t - opens)); }
  [[nodiscard]] double meets_again() const {
    return first_rise([&](double t) { return flown.at(t) - kGap - compression(t); }, opens);
  }
  // The face, x less what the stop is compressed by.
  [[nodiscard]] double face(double t) const { return t < opens ? kGap : flown.at(t) - compression(t); }

  double closes;
  Arc pushed;
  double opens;
  Arc flown;
  double compressed, rate;
};

// Instant, x and velocity at the next closing, a period earlier.
Eigen::Vector3d returned(const Stop& stop, const Eigen::Vector3d& closing) {
  const Bounce bounce(stop, 1.0, closing[0], closing[1], closing[2]);
  const double next = bounce.meets_again();
  return {next - kPeriod, bounce.flown.at(next), bounce.flown.at(next, 1)};
}

// The bounce that repeats itself after a period, by Newton's method with differences. It may be unstable.
Bounce periodic_bounce(const Stop& stop) {
  Eigen::Vector3d closing(1.2, kGap + 0.02, 0.3);
  constexpr int kSteps = 12;
  for (int i = 0; i < kSteps; ++i) {
    constexpr double kDifference = 1e-6;
    Eigen::Matrix3d slope;
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d e = kDifference * Eigen::Vector3d::Unit(j);
      slope.col(j) = (returned(stop, closing + e) - returned(stop, closing - e)) / (2.0 * kDifference);
    }
    slope -= Eigen::Matrix3d::Identity();
    closing -= slope.partialPivLu().solve(returned(stop, closing) - closing);
  }
  return Bounce(stop, 1.0, closing[0], closing[1], closing[2]);
}

Problem scene(const Stop& stop) {
  Problem problem =
      test::to_problem({.damping = kDamping, .frequency = kFrequency, .gap = kGap, .restitution = 1.0});
  damp_stops(problem,
             {{.normal = problem.contacts[0].normal, .stiffness = stop.stiffness, .damping = stop.damping}});
  problem.set_law(Massless{});
  validate(problem);
  return problem;
}

// Largest distance of the face and of the force, the latter away from its jump, over the largest of each.
struct Distances {
  double face = 0.0, force = 0.0;
};
Distances distances(const Trajectory& trajectory, const Stop& stop, const Bounce& bounce) {
  constexpr int kInstants = 2000;
  const Samples samples = trajectory.sample(kInstants);
  Distances worst;
  for (int i = 0; i < kInstants; ++i) {
    double t = i * kPeriod / kInstants;
    t += kPeriod * std::ceil((bounce.closes - t) / kPeriod);
    worst.face = std::max(worst.face, std::abs(samples.x(i, 0) - bounce.face(t)));
    if (std::min(t - bounce.closes, bounce.closes + kPeriod - t) < 2.0 * kPeriod / kInstants) continue;
    const double push = t < bounce.opens ? bounce.push(stop, t) : 0.0;
    worst.force = std::max(worst.force, std::abs(samples.force(i, 0) + push));
  }
  return {worst.face / samples.x.lpNorm<Eigen::Infinity>(),
          worst.force / samples.force.lpNorm<Eigen::Infinity>()};
}

// Quick: done with when the mass comes back. Slow: met half way.
constexpr Stop kQuick{100.0, 4.0}, kSlow{1.0, 4.0};

TEST(DampedStopOracle, ThrowsAMassBackByTheKnownRatio) {
  // The mass on a stiff stop alone, without load: e = exp(-z / sqrt(1 - z^2) (pi - atan2(2 z sqrt(1 - z^2), 1
  // - 2 z^2))), z the damping ratio of the contact.
  for (const auto& [ratio, expected] : {std::pair(0.05, 0.85875810), std::pair(0.3, 0.45097545)}) {
    constexpr double kStiffness = 1e8;
    const Stop stop{kStiffness, 2.0 * ratio * std::sqrt(kStiffness)};
    const Arc pushed(stop.damping, stop.stiffness, stop.stiffness * kGap, 0.0, 0.0, kGap, 1.0);
    double low = 1e-6, high = std::numbers::pi / std::sqrt(kStiffness);
    const auto pushes = [&](double t) {
      return stop.stiffness * (pushed.at(t) - kGap) + stop.damping * pushed.at(t, 1) > 0.0;
    };
    ASSERT_TRUE(pushes(low));
    while (pushes(high)) high *= 1.1;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (pushes(middle) ? low : high) = middle;
    }
    EXPECT_NEAR(-pushed.at(high, 1), expected, 1e-8);
  }
}

TEST(DampedStop, OrbitsAreTheArcsInClosedForm) {
  for (const Stop& stop : {kQuick, kSlow}) {
    SCOPED_TRACE(stop.stiffness);
    const Bounce bounce = periodic_bounce(stop);
    ASSERT_NEAR(bounce.meets_again() - bounce.closes, kPeriod, 1e-10);
    const double left = bounce.compression(bounce.closes + kPeriod);
    if (stop.stiffness == kSlow.stiffness) {
      EXPECT_GT(left, 0.02) << "met before it is back";
    } else {
      EXPECT_LT(left, 1e-12);
    }
    const Solution exact = test::solve<ExactOrbitMethod>(scene(stop), {});
    ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
    ASSERT_NEAR(exact.trajectory->period(), kPeriod, 1e-12);
    const Distances apart = distances(*exact.trajectory, stop, bounce);
    EXPECT_LT(apart.face, 1e-9);
    EXPECT_LT(apart.force, 1e-9);
    const Solution marched =
        test::solve<EventDriven>(scene(stop), {.steady = EventDriven::Steady::shooting}, exact.trajectory);
    ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
    EXPECT_LT(distances(*marched.trajectory, stop, bounce).face, 1e-6);
  }
}

TEST(DampedStop, IsMetByMethodsOfTimeAndOfFrequency) {
  for (const Stop& stop : {kQuick, kSlow}) {
    SCOPED_TRACE(stop.stiffness);
    const Bounce bounce = periodic_bounce(stop);
    std::vector<double> series, nodes, springs;
    for (const int level : {0, 1}) {
      const Solution lipschitz =
          test::solve<FourierLipschitz>(scene(stop), {.common = {.harmonics = level == 0 ? 20 : 160}});
      ASSERT_EQ(lipschitz.verdict, Verdict::converged) << lipschitz.message;
      series.push_back(distances(*lipschitz.trajectory, stop, bounce).face);
      const Solution nodal = test::solve<HatLcp>(scene(stop), {.samples = level == 0 ? 256 : 2048});
      ASSERT_EQ(nodal.verdict, Verdict::converged) << nodal.message;
      nodes.push_back(distances(*nodal.trajectory, stop, bounce).face);
      const Solution penalty =
          test::solve<PenaltyHbm>(scene(stop), {.common = {.harmonics = level == 0 ? 20 : 160}});
      ASSERT_EQ(penalty.verdict, Verdict::converged) << penalty.message;
      springs.push_back(distances(*penalty.trajectory, stop, bounce).face);
    }
    EXPECT_LT(series[1], 0.25 * series[0]);
    EXPECT_LT(series[1], 5e-3);
    EXPECT_LT(nodes[1], 0.25 * nodes[0]);
    EXPECT_LT(nodes[1], 2e-3);
    EXPECT_LT(springs[1], 2e-2) << "a spring of a hundred times the stop's, at the face";
  }
}

// A stop on one side of the mass, at `gap` there; without damping a spring alone.
struct Side {
  Stop stop;
  double sign = 1.0, gap = 0.0;
  double compressed = 0.0;
  bool touched = false;

  void move(double u, double kept) {
    touched = sign * u - gap >= kept * compressed - 1e-12;
    compressed = touched ? sign * u - gap : kept * compressed;
  }
  [[nodiscard]] double push(double u, double v) const {
    const double pressed = stop.stiffness * (sign * u - gap) + stop.damping * sign * v;
    return touched ? -sign * std::max(0.0, pressed) : 0.0;
  }
};

// u of the mass between two stops at the ends of small steps, none of which looks for an event. First order
// in the step where a push jumps.
std::vector<double> small_steps(std::array<Side, 2> sides, double u, double v, int steps) {
  const double h = kPeriod / steps;
  for (Side& side : sides) side.move(u, 1.0);
  const auto acceleration = [&](double t, double x, double rate) {
    return std::cos(kFrequency * t) - kDamping * rate - x + sides[0].push(x, rate) + sides[1].push(x, rate);
  };
  std::vector<double> result;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h, x = u + 0.5 * h * v, rate = v + 0.5 * h * acceleration(t, u, v);
    v += h * acceleration(t + 0.5 * h, x, rate);
    u += h * rate;
    for (Side& side : sides)
      side.move(u, side.stop.damping > 0.0 ? std::exp(-side.stop.stiffness / side.stop.damping * h) : 0.0);
    result.push_back(u);
  }
  return result;
}

constexpr double kBehind = 0.15;

Problem between(const Stop& one, const Stop& other) {
  Problem problem = scene(one);
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = kBehind, .law = Spring{other.stiffness}});
  if (other.damping > 0.0)
    damp_stops(
        problem,
        {{.contact = 1, .normal = {{0, -1.0}}, .stiffness = other.stiffness, .damping = other.damping}});
  validate(problem);
  return problem;
}

TEST(DampedStop, BesideASpringAloneOrOneOfAnotherRatioIsFollowed) {
  constexpr Stop kSpring{30.0, 0.0}, kOther{30.0, 6.0};
  for (const auto& [one, other] :
       {std::pair(kQuick, kSpring), std::pair(kSlow, kSpring), std::pair(kQuick, kOther)}) {
    SCOPED_TRACE(one.stiffness + other.damping);
    const Problem problem = between(one, other);
    const Solution exact = test::solve<ExactOrbitMethod>(problem, {});
    ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
    const auto& orbit = dynamic_cast<const ExactTrajectory&>(*exact.trajectory);
    constexpr int kInstants = 2000, kFine = 400;
    const Samples samples = orbit.sample(kInstants);
    EXPECT_LT(samples.force.col(0).minCoeff(), -0.1);
    EXPECT_LT(samples.force.col(1).minCoeff(), -0.1);
    const double u = orbit.at(0.0).u[0], v = orbit.at(0.0).v[0];
    const double behind = other.damping > 0.0 ? -u - samples.x(0, 1) : std::max(0.0, -u - kBehind);
    const std::vector<double> steps = small_steps(
        {{{one, 1.0, kGap, u - samples.x(0, 0)}, {other, -1.0, kBehind, behind}}}, u, v, kInstants * kFine);
    double apart = std::abs(steps.back() - u);  // it is periodic
    for (int i = 1; i < kInstants; ++i) {
      const double there = orbit.at(i * kPeriod / kInstants).u[0];
      apart = std::max(apart, std::abs(steps[static_cast<std::size_t>(i * kFine - 1)] - there));
    }
    EXPECT_LT(apart, 1e-4);
    const Solution followed =
        test::solve<EventDriven>(problem, {.steady = EventDriven::Steady::shooting}, exact.trajectory);
    ASSERT_EQ(followed.verdict, Verdict::converged) << followed.message;
    EXPECT_LT(test::relative_distance(*followed.trajectory, *exact.trajectory), 1e-6);
  }
}

}  // namespace
}  // namespace signorini::damped_stop_test
