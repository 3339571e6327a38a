// Rotors whose matrices have skew parts, gyroscopic in D and circulatory in K: against circular whirl in
// closed form, and with a stop against a time integration of its own.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <optional>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::skew_parts_test {
namespace {

using Complex = std::complex<double>;

// m = 1 in both directions; z = u_0 + i u_1.
struct Rotor {
  double damping = 0.3, gyroscopic = 0.4, stiffness = 1.0, circulatory = 0.12;
  double load = 1.0, frequency = 1.7;

  [[nodiscard]] Eigen::Matrix2d dampers() const {
    return Eigen::Matrix2d{{damping, gyroscopic}, {-gyroscopic, damping}};
  }
  [[nodiscard]] Eigen::Matrix2d springs() const {
    return Eigen::Matrix2d{{stiffness, circulatory}, {-circulatory, stiffness}};
  }
  [[nodiscard]] double period() const { return 2.0 * std::numbers::pi / frequency; }
  // z'' + (d - i g) z' + (k - i s) z = F e^{i w t}
  [[nodiscard]] Complex whirl() const {
    const double w = frequency;
    return load / Complex(stiffness - w * w + gyroscopic * w, damping * w - circulatory);
  }
};

// Both displacements are watched; only the stop in the first direction is near.
Problem scene(const Rotor& rotor, double gap, Law law) {
  Problem problem;
  problem.frequency = rotor.frequency;
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::Matrix2d::Identity().sparseView();
    s.damping = rotor.dampers().sparseView();
    s.stiffness = rotor.springs().sparseView();
  });
  problem.force = {{.dof = 0, .cos = rotor.load}, {.dof = 1, .sin = rotor.load}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = gap}, {.normal = {{1, 1.0}}, .gap = 50.0}};
  problem.set_law(std::move(law));
  validate(problem);
  return problem;
}

// Largest distance of both displacements from u(t), over the largest of u [-].
double distance(const Trajectory& trajectory, const std::function<Eigen::Vector2d(double)>& u) {
  constexpr int kInstants = 512;
  const Eigen::MatrixXd x = trajectory.sample(kInstants).x;
  double worst = 0.0, largest = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const Eigen::Vector2d exact = u(i * trajectory.period() / kInstants);
    worst = std::max(worst, (x.row(i).transpose() - exact).lpNorm<Eigen::Infinity>());
    largest = std::max(largest, exact.lpNorm<Eigen::Infinity>());
  }
  return worst / largest;
}

TEST(SkewParts, WhirlIsTheCircleInClosedForm) {
  for (const double circulatory : {0.12, -0.12}) {
    Rotor rotor;
    rotor.circulatory = circulatory;
    const auto exact = [&](double t) {
      const Complex z = rotor.whirl() * std::polar(1.0, rotor.frequency * t);
      return Eigen::Vector2d(z.real(), z.imag());
    };
    const Problem problem = scene(rotor, 40.0, Restitution{1.0});
    EXPECT_LT(distance(*test::solve<ExactOrbitMethod>(problem, {}).trajectory, exact), 1e-12);
    EXPECT_LT(distance(*test::solve<FourierLipschitz>(problem, {}).trajectory, exact), 1e-12);
    EXPECT_LT(distance(*test::solve<PenaltyHbm>(problem, {}).trajectory, exact), 1e-12);
    EXPECT_LT(distance(*test::solve<AftHbm>(problem, {}).trajectory, exact), 1e-12);
    EXPECT_LT(distance(*test::solve<EventDriven>(problem, {}).trajectory, exact), 1e-6);
    EXPECT_LT(distance(*test::solve<HatLcp>(problem, {.samples = 512}).trajectory, exact), 1e-3);
  }
}

// Runge and Kutta's method of order four, steps cut where u_0 passes the stop, by bisection.
class Integration {
 public:
  Integration(const Rotor& rotor, double gap, double restitution, std::optional<double> spring)
      : rotor_(rotor), gap_(gap), restitution_(restitution), spring_(spring.value_or(0.0)) {}

  void advance(double duration) {
    while (duration > 1e-14) {
      Eigen::Vector4d next = stepped(duration);
      const bool passes = beyond_ ? next[0] < gap_ : next[0] > gap_;
      if (!passes) {
        y_ = next;
        time_ += duration;
        return;
      }
      double low = 0.0, high = duration;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((stepped(middle)[0] > gap_) != beyond_ ? high : low) = middle;
      }
      y_ = stepped(low);
      time_ += low;
      duration -= low;
      if (spring_ > 0.0)
        beyond_ = !beyond_;
      else
        y_[2] *= -restitution_;
      // Off the stop, where the next step begins on the side it goes to.
      y_[0] = beyond_ ? std::max(y_[0], gap_) : std::min(y_[0], gap_);
    }
  }
  [[nodiscard]] Eigen::Vector2d u() const { return y_.head(2); }

 private:
  [[nodiscard]] Eigen::Vector4d rate(double t, const Eigen::Vector4d& y) const {
    const double angle = rotor_.frequency * t;
    Eigen::Vector2d force = rotor_.load * Eigen::Vector2d(std::cos(angle), std::sin(angle)) -
                            rotor_.springs() * y.head(2) - rotor_.dampers() * y.tail(2);
    if (beyond_) force[0] -= spring_ * (y[0] - gap_);
    Eigen::Vector4d result;
    result << y.tail(2), force;
    return result;
  }
  [[nodiscard]] Eigen::Vector4d stepped(double h) const {
    const Eigen::Vector4d a = rate(time_, y_), b = rate(time_ + 0.5 * h, y_ + 0.5 * h * a),
                          c = rate(time_ + 0.5 * h, y_ + 0.5 * h * b), d = rate(time_ + h, y_ + h * c);
    return y_ + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }

  Rotor rotor_;
  double gap_, restitution_, spring_, time_ = 0.0;
  bool beyond_ = false;
  Eigen::Vector4d y_ = Eigen::Vector4d::Zero();
};

// What the integration settles to from rest: 512 instants of a period, 2 rows.
Eigen::MatrixXd settled(const Rotor& rotor, double gap, double restitution, std::optional<double> spring) {
  constexpr int kInstants = 512, kSteps = 4, kPeriods = 60;
  Integration motion(rotor, gap, restitution, spring);
  Eigen::MatrixXd u(2, kInstants);
  for (int period = 0; period <= kPeriods; ++period) {
    for (int i = 0; i < kInstants; ++i) {
      u.col(i) = motion.u();
      for (int k = 0; k < kSteps; ++k) motion.advance(rotor.period() / (kInstants * kSteps));
    }
  }
  return u;
}

TEST(SkewParts, StopsAreMetAsATimeIntegrationMeetsThem) {
  const Rotor rotor;
  const double gap = 0.6 * std::abs(rotor.whirl());
  for (const std::optional<double> spring : {std::optional<double>(), std::optional<double>(40.0)}) {
    constexpr double kRestitution = 0.7;
    SCOPED_TRACE(spring.has_value());
    const Eigen::MatrixXd u = settled(rotor, gap, kRestitution, spring);
    const auto exact = [&](double t) {
      return Eigen::Vector2d(
          u.col(static_cast<Eigen::Index>(std::lround(t / rotor.period() * static_cast<double>(u.cols()))) %
                u.cols()));
    };
    const Problem problem =
        scene(rotor, gap, spring ? Law(Penalty{{*spring, *spring}}) : Law(Restitution{kRestitution}));
    const Solution orbit = test::solve<ExactOrbitMethod>(problem, {});
    ASSERT_EQ(orbit.verdict, Verdict::converged) << orbit.message;
    EXPECT_LT(distance(*orbit.trajectory, exact), 1e-9);
    const Solution marched = test::solve<EventDriven>(problem, {});
    ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
    EXPECT_LT(distance(*marched.trajectory, exact), 1e-6);
    const Solution series = test::solve<ClosedHbm>(problem, {.harmonics = 80});
    ASSERT_EQ(series.verdict, Verdict::converged) << series.message;
    EXPECT_LT(distance(*series.trajectory, exact), 5e-3);
    const Solution nodes = test::solve<HatLcp>(problem, {.samples = 2048});
    ASSERT_EQ(nodes.verdict, Verdict::converged) << nodes.message;
    EXPECT_LT(distance(*nodes.trajectory, exact), 2e-2);
  }
}

}  // namespace
}  // namespace signorini::skew_parts_test
