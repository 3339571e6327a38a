// Branch points of the motions between two stops against the half-period return map of their closed form.

#include "methods/orbit/family/branch_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/methods/orbit/continuation/diagrams.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::branch_point_test {
namespace {

constexpr double kDamping = 0.1, kGap = 0.5;

// x'' + c x' + x = cos(w t), |x| <= g: the symmetric orbit of the larger speed with one impact on either
// stop.
struct SymmetricImpacts {
  double restitution = 1.0, w = 1.0;
  double speed = 0.0;           // before an impact
  Eigen::Vector2d forced = {};  // (x, x') of the forced part at the impact on the stop at g

  // The free motion over a time.
  static Eigen::Matrix2d flight(double time) {
    const double zeta = 0.5 * kDamping, wd = std::sqrt(1.0 - zeta * zeta);
    const double fade = std::exp(-zeta * time), c = std::cos(wd * time), s = std::sin(wd * time) / wd;
    Eigen::Matrix2d P;
    P << fade * (c + zeta * s), fade * s, -fade * s, fade * (c - zeta * s);
    return P;
  }
  [[nodiscard]] double half() const { return M_PI / w; }

  SymmetricImpacts(double e, double frequency) : restitution(e), w(frequency) {
    // From (g, -e v) to (-g, -v): (I + P) p = P (g, -e v) + (g, v) is affine in v and lies on an ellipse.
    const Eigen::Matrix2d P = flight(half()), Q = (Eigen::Matrix2d::Identity() + P).inverse();
    const Eigen::Vector2d a = Q * (P * Eigen::Vector2d(kGap, 0.0) + Eigen::Vector2d(kGap, 0.0));
    const Eigen::Vector2d b = Q * (P * Eigen::Vector2d(0.0, -e) + Eigen::Vector2d(0.0, 1.0));
    const Eigen::Vector2d metric(1.0, 1.0 / (w * w));
    const double largest = 1.0 / (std::pow(1.0 - w * w, 2) + std::pow(kDamping * w, 2));
    const double A = b.dot(metric.cwiseProduct(b)), B = a.dot(metric.cwiseProduct(b));
    const double C = a.dot(metric.cwiseProduct(a)) - largest;
    speed = (-B + std::sqrt(B * B - A * C)) / A;
    forced = a + speed * b;
  }

  // det(H + 1), H the derivative of the map over half a period with x turned into -x: zero where the
  // symmetry breaks.
  [[nodiscard]] double breaking() const {
    const double force = -w * w * forced[0] + kDamping * forced[1] + forced[0];
    const double before = force - kDamping * speed - kGap;
    const double after = force + kDamping * restitution * speed - kGap;
    Eigen::Matrix2d jump;
    jump << -restitution, 0.0, (after + restitution * before) / speed, -restitution;
    return (Eigen::Matrix2d::Identity() - jump * flight(half())).determinant();
  }

  // As a sequence, begun a quarter of a period after the impact on the stop at g.
  [[nodiscard]] OrbitGuess orbit() const {
    const double lag = std::atan2(kDamping * w, 1.0 - w * w);  // forced = X (cos, -w sin)(w t - lag)
    const double impact = (std::atan2(-forced[1] / w, forced[0]) + lag) / w, quarter = 0.5 * half();
    const Eigen::Vector2d later(std::cos(w * quarter) * forced[0] + std::sin(w * quarter) / w * forced[1],
                                -w * std::sin(w * quarter) * forced[0] + std::cos(w * quarter) * forced[1]);
    const Eigen::Vector2d y =
        flight(quarter) * (Eigen::Vector2d(kGap, -restitution * speed) - forced) + later;
    OrbitGuess guess{.start = {.time = impact + quarter,
                               .state = {.u = y.head(1), .v = y.tail(1)},
                               .closed = {false, false}},
                     .events = {},
                     .origin = "closed form"};
    for (const int contact : {1, 0})
      guess.events.push_back({.kind = ContactEvent::Kind::impact,
                              .contact = contact,
                              .time = guess.start.time + quarter + (contact == 1 ? 0.0 : half()),
                              .pushed = {contact},
                              .restitution = {restitution},
                              .closed = {false, false}});
    return guess;
  }
};

double breaking_between(double restitution, double low, double high) {
  const double first = SymmetricImpacts(restitution, low).breaking();
  EXPECT_LT(first * SymmetricImpacts(restitution, high).breaking(), 0.0);
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (SymmetricImpacts(restitution, middle).breaking() * first > 0.0 ? low : high) = middle;
  }
  return low;
}

struct Breaking {
  double restitution, low, high;
};

// Newton's method on the curve's own equations knew them to 3e-9, or not at all, by the steps.
TEST(BranchPoint, IsWhereTheClosedFormLosesItsSymmetry) {
  for (const Breaking& where :
       {Breaking{1.0, 1.0, 1.01}, Breaking{1.0, 1.57, 1.59}, Breaking{0.8, 1.52, 1.54}}) {
    const double exact = breaking_between(where.restitution, where.low, where.high);
    Problem problem = test::to_problem({.damping = kDamping, .gap = kGap, .restitution = where.restitution});
    problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = kGap, .law = problem.contacts.front().law});
    OrbitFamily family(over_frequency(problem, 0.8, 2.0));
    const SymmetricImpacts seed(where.restitution, 1.2);
    const SequencedOrbit orbit = sequenced(family, seed.orbit(), 2.0 * seed.half(), 1.2, 1.2);
    for (const double step : {0.15, 0.04}) {
      const OrbitDiagram diagram =
          trace_diagram(family, {orbit}, {.max_branches = 3, .step_share = step / kOrbitSteps.longest});
      EXPECT_NEAR(test::nearest(diagram, SpecialKind::branch_point, exact), exact, 1e-12)
          << where.restitution << " " << step;
      EXPECT_EQ(diagram.branches.size(), 3U);
    }
  }
}

}  // namespace
}  // namespace signorini::branch_point_test
