// Scenes whose contacts have different laws, against a march through time of their own.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::mixed_laws_test {
namespace {

using test::solve;

/// Three masses between springs; `stops` are its contacts and laws.
Problem chain_before(const std::string& stops, double last_mass = 1.0) {
  return parse_scene(
      "schema = 1\nname = \"chain\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 1.2, " +
          std::to_string(last_mass) +
          "]\ndampers = [0.3, 0.3, 0.0]\nsprings = [1.0, 1.5, 2.0]\n[forcing]\nfrequency = "
          "0.9\n[[forcing.term]]\ndof = 0\ncos = 0.8\n[[forcing.term]]\ndof = 1\ncos = 0.3\nsin = 0.2\n" +
          stops,
      "chain.toml");
}

/// The classical Runge-Kutta method through time on the coordinates with mass; a step in which a rigid stop
/// is passed is halved until it ends there, and Newton's law follows. Stops that are springs are part of the
/// force. Motions that stay at a rigid stop are beyond it.
class March {
 public:
  struct Stop {
    Eigen::VectorXd normal;
    double gap = 0.0, stiffness = 0.0, restitution = 0.0;  // a spring if its stiffness is not 0
  };

  March(const Problem& problem, std::vector<Stop> stops)
      : n_(stops.front().normal.size()),
        problem_(problem),
        inverse_(Eigen::MatrixXd(problem.mass()).topLeftCorner(n_, n_).inverse()),
        damping_(Eigen::MatrixXd(problem.damping()).topLeftCorner(n_, n_)),
        stiffness_(Eigen::MatrixXd(problem.stiffness()).topLeftCorner(n_, n_)),
        stops_(std::move(stops)),
        y_(Eigen::VectorXd::Zero(2 * n_)) {}

  /// Moves on by `periods`; the displacements at the ends of `count` equal parts of the last one.
  Eigen::MatrixXd run(int periods, int count) {
    constexpr int kSteps = 8;  // per part
    const double part = problem_.period() / count;
    Eigen::MatrixXd x(count, n_);
    for (int k = 0; k < periods * count; ++k) {
      for (int i = 0; i < kSteps; ++i) advance((k + static_cast<double>(i) / kSteps) * part, part / kSteps);
      x.row((k + 1) % count) = y_.head(n_).transpose();
    }
    return x;
  }

 private:
  [[nodiscard]] Eigen::VectorXd rate(double t, const Eigen::VectorXd& y) const {
    Eigen::VectorXd force = load_at(problem_, t).head(n_) - stiffness_ * y.head(n_) - damping_ * y.tail(n_);
    for (const Stop& stop : stops_)
      force -= stop.stiffness * std::max(0.0, stop.normal.dot(y.head(n_)) - stop.gap) * stop.normal;
    Eigen::VectorXd result(2 * n_);
    result << y.tail(n_), inverse_ * force;
    return result;
  }
  [[nodiscard]] Eigen::VectorXd stepped(double t, double h) const {
    const Eigen::VectorXd a = rate(t, y_), b = rate(t + 0.5 * h, y_ + 0.5 * h * a),
                          c = rate(t + 0.5 * h, y_ + 0.5 * h * b), d = rate(t + h, y_ + h * c);
    return y_ + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  [[nodiscard]] const Stop* passed(const Eigen::VectorXd& y) const {
    for (const Stop& stop : stops_) {
      if (stop.stiffness == 0.0 && stop.normal.dot(y.head(n_)) > stop.gap &&
          stop.normal.dot(y.tail(n_)) > 0.0)
        return &stop;
    }
    return nullptr;
  }
  void advance(double t, double h) {
    Eigen::VectorXd next = stepped(t, h);
    if (passed(next) == nullptr) {
      y_ = next;
      return;
    }
    double safe = 0.0, beyond = h;
    while (beyond - safe > 1e-15) {
      const double middle = 0.5 * (safe + beyond);
      (passed(stepped(t, middle)) == nullptr ? safe : beyond) = middle;
    }
    next = stepped(t, beyond);
    const Stop& stop = *passed(next);
    y_ = next;
    const Eigen::VectorXd back = inverse_ * stop.normal;
    y_.tail(n_) -= (1.0 + stop.restitution) * stop.normal.dot(y_.tail(n_)) / stop.normal.dot(back) * back;
    if (h > beyond) advance(t + beyond, h - beyond);
  }

  Eigen::Index n_;
  const Problem& problem_;
  Eigen::MatrixXd inverse_, damping_, stiffness_;
  std::vector<Stop> stops_;
  Eigen::VectorXd y_;
};

Eigen::VectorXd along(int dof, int size, double sign = 1.0) {
  return sign * Eigen::VectorXd::Unit(size, dof);
}

constexpr int kCount = 256, kPeriods = 60;
constexpr double kMarched = 1e-5;  // what the march errs at the springs [m]

/// By event-driven from rest, and the exact orbit next to that.
std::vector<Solution> solutions(const Problem& problem) {
  std::vector<Solution> found{solve<EventDriven>(problem, {})};
  found.push_back(ExactOrbitMethod({}).prepare(problem)->solve({.guess = found.front().trajectory}));
  return found;
}

/// x of both contacts is that of the march.
void expect_marched(const Problem& problem, const std::vector<March::Stop>& stops) {
  March march(problem, stops);
  const Eigen::MatrixXd u = march.run(kPeriods, kCount);
  for (const Solution& solution : solutions(problem)) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Eigen::MatrixXd found = solution.trajectory->sample(kCount).x;
    for (std::size_t j = 0; j < stops.size(); ++j) {
      const Eigen::VectorXd x = u * stops[j].normal;
      EXPECT_LT((found.col(static_cast<Eigen::Index>(j)) - x).cwiseAbs().maxCoeff(), kMarched)
          << solution.message;
    }
  }
}

TEST(MixedLaws, RigidBesideRubber) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\nrestitution = 0.6\n[[contact]]\ndof = 2\nside = \"below\"\ngap = "
      "0.3\npenalty = 7.0\n");
  expect_marched(problem, {{.normal = along(0, 3), .gap = 0.4, .restitution = 0.6},
                           {.normal = along(2, 3, -1.0), .gap = 0.3, .stiffness = 7.0}});
}

TEST(MixedLaws, TwoRestitutions) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\n[[contact]]\ndof = 2\ngap = 0.5\nrestitution = "
      "0.3\n[law]\nrestitution = "
      "0.8\n");
  expect_marched(problem, {{.normal = along(0, 3), .gap = 0.4, .restitution = 0.8},
                           {.normal = along(2, 3), .gap = 0.5, .restitution = 0.3}});
}

// A tip without mass on its spring is that spring for the mass behind it.
TEST(MixedLaws, MasslessBesideMassive) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\n[[contact]]\ndof = 2\ngap = 0.3\nmassless = true\n[law]\nrestitution "
      "= "
      "0.6\n",
      0.0);
  // Without the spring to the tip, which the march has as its stop.
  Problem behind = problem;
  behind.edit_structure([](Structure& s) { s.stiffness.coeffRef(1, 1) -= 2.0; });
  March march(behind, {{.normal = along(0, 2), .gap = 0.4, .restitution = 0.6},
                       {.normal = along(1, 2), .gap = 0.3, .stiffness = 2.0}});
  const Eigen::MatrixXd u = march.run(kPeriods, kCount);
  for (const Solution& solution : solutions(problem)) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples found = solution.trajectory->sample(kCount);
    EXPECT_LT((found.x.col(0) - u.col(0)).cwiseAbs().maxCoeff(), kMarched);
    EXPECT_LT((found.x.col(1).array() - u.col(1).array().min(0.3)).abs().maxCoeff(), kMarched);
    EXPECT_LT((found.force.col(1).array() + 2.0 * (u.col(1).array() - 0.3).max(0.0)).abs().maxCoeff(),
              10.0 * kMarched);
  }
}

TEST(MixedLaws, SpringBesideMassless) {
  const Problem problem =
      chain_before("[[contact]]\ndof = 0\ngap = 0.4\npenalty = 5.0\n[[contact]]\ndof = 2\ngap = 0.3\n", 0.0);
  Problem behind = problem;
  behind.edit_structure([](Structure& s) { s.stiffness.coeffRef(1, 1) -= 2.0; });
  March march(behind, {{.normal = along(0, 2), .gap = 0.4, .stiffness = 5.0},
                       {.normal = along(1, 2), .gap = 0.3, .stiffness = 2.0}});
  const Eigen::MatrixXd u = march.run(kPeriods, kCount);
  for (const Solution& solution : solutions(problem)) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples found = solution.trajectory->sample(kCount);
    EXPECT_LT((found.x.col(0) - u.col(0)).cwiseAbs().maxCoeff(), kMarched);
  }
}

TEST(MixedLaws, EqualOnesAreTheSceneOfOneLaw) {
  const std::string one = "[[contact]]\ndof = 0\ngap = 0.4\n", two = "[[contact]]\ndof = 2\ngap = 0.5\n";
  for (const std::string law : {"restitution = 0.6\n", "penalty = 7.0\n"}) {
    const Problem own = chain_before(one + law + two + law),
                  common = chain_before(one + two + "[law]\n" + law);
    const Solution a = solve<ExactOrbitMethod>(own, {}), b = solve<ExactOrbitMethod>(common, {});
    ASSERT_EQ(a.verdict, Verdict::converged) << a.message;
    EXPECT_EQ(a.trajectory->sample(64).x, b.trajectory->sample(64).x);
    EXPECT_EQ(a.message, b.message);
  }
}

// x at t = 0, T / 4 and T / 2 by tests/attack/own_flow.py, which shares no code with ours.
TEST(MixedLaws, OfTheCatalogueMoveAsAnIndependentFlowDoes) {
  const Problem scene = load_scene(find_scene("chain2-housing-and-buffer"));
  for (const Solution& solution : {solve<ExactOrbitMethod>(scene, {}), solve<EventDriven>(scene, {})}) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Eigen::VectorXd x = solution.trajectory->sample(4).x.col(0);
    EXPECT_LT((x.head(3) - Eigen::Vector3d(0.16765568, 0.16253195, -0.41006704)).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(MixedLaws, AreRefusedByMethodsOfOneLaw) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\nrestitution = 0.6\n[[contact]]\ndof = 2\ngap = 0.3\npenalty = 7.0\n");
  const std::string reason =
      "contacts of different laws, contact 0 with restitution 0.6 and contact 1 with a spring: the method "
      "knows "
      "one law for all";
  EXPECT_EQ(HatLcp({}).supports(problem).reason, reason);
  EXPECT_EQ(PenaltyHbm({}).supports(problem).reason, reason);
}

}  // namespace
}  // namespace signorini::mixed_laws_test
