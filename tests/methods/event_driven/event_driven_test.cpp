#include "methods/event_driven/event_driven.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "methods/structure/periodic_response.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "tests/methods/event_driven/scenes.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini::event_driven_test {
namespace {

using test::free_chain;
using test::ImpactOscillator;
using test::solve;
using test::to_problem;
using test::two_masses;

std::string refusal(const EventDriven::Options& options) {
  try {
    const EventDriven method(options);
  } catch (const InvalidOption& error) {
    return error.what();
  }
  return "accepted";
}

TEST(EventDrivenOptions, OutOfRangeAreRefusedWithTheirName) {
  EXPECT_EQ(refusal({}), "accepted");
  EXPECT_NE(refusal({.tolerance = 0.0}).find("tolerance = 0 ("), std::string::npos)
      << refusal({.tolerance = 0.0});
  EXPECT_NE(refusal({.tolerance = 1e-14}).find("[1e-13, 1e-3]"), std::string::npos);
  EXPECT_NE(refusal({.tolerance = 0.1}).find("tolerance"), std::string::npos);
  EXPECT_NE(refusal({.tolerance = std::numeric_limits<double>::quiet_NaN()}).find("tolerance"),
            std::string::npos);
  EXPECT_NE(refusal({.max_iterations = 0}).find("max_iterations = 0 ("), std::string::npos);
  EXPECT_NE(refusal({.max_order = 65}).find("max_order = 65 ("), std::string::npos);
}

TEST(EventDrivenOptions, AreEchoedWithTheirUnits) {
  const auto echo = EventDriven({.tolerance = 1e-7, .steady = EventDriven::Steady::shooting}).options();
  ASSERT_EQ(echo.size(), 5U);
  EXPECT_EQ(std::get<double>(echo[0].value), 1e-7);
  EXPECT_EQ(std::get<std::string>(echo[1].value), "shooting");
  EXPECT_EQ(std::get<std::string>(echo[2].value), "cvode");
}

TEST(EventDriven, RepresentsTheLawOfTheSceneAndRefusesAMassMatrixThatIsSingular) {
  const EventDriven method({});
  Problem problem = two_masses(1.0, 0.5);
  EXPECT_TRUE(method.supports(problem).ok);
  EXPECT_TRUE(law_matches(method.law(problem), problem.law()));
  problem.set_law(Penalty{{10.0}});
  EXPECT_TRUE(method.supports(problem).ok);
  EXPECT_TRUE(law_matches(method.law(problem), problem.law()));
  const Problem massless = test::massless_node();
  EXPECT_TRUE(method.supports(massless).ok);
  EXPECT_TRUE(law_matches(method.law(massless), massless.law()));
  problem.set_law(Restitution{0.5});
  problem.edit_structure(
      [&](Structure& s) { s.mass = Eigen::MatrixXd(Eigen::Matrix2d::Ones()).sparseView(); });
  EXPECT_FALSE(method.supports(problem).ok);
  EXPECT_NE(method.supports(problem).reason.find("singular"), std::string::npos);
}

TEST(EventDriven, ReturnsTheLinearResponseOfASceneWithoutContact) {
  const Problem problem = free_chain(5, 0.9);
  const Solution solution = solve(problem, {.tolerance = 1e-11});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  // Oracle: one dense complex solve per harmonic.
  Eigen::VectorXcd u = Eigen::VectorXcd::Zero(5), v = u;
  const FlowState& start = test::trajectory_of(solution).start();
  for (const int h : {0, 1, 3}) {
    const std::complex<double> iw(0.0, 0.9 * h);
    const Eigen::MatrixXcd Z = Eigen::MatrixXcd(problem.stiffness().cast<std::complex<double>>()) +
                               iw * Eigen::MatrixXcd(problem.damping().cast<std::complex<double>>()) +
                               iw * iw * Eigen::MatrixXcd(problem.mass().cast<std::complex<double>>());
    const Eigen::VectorXcd response = std::exp(iw * start.time) * lu_solve(Z, load_harmonic(problem, h));
    u += response;
    v += iw * response;
  }
  EXPECT_LT((start.state.u - u.real()).norm(), 1e-10 * u.norm());
  EXPECT_LT((start.state.v - v.real()).norm(), 1e-10 * u.norm());
  EXPECT_EQ(solution.trajectory->sample(8).x.cols(), 0);
}

TEST(EventDriven, LeavesAMotionAloneThatNeverTouches) {
  const Problem problem = to_problem({.frequency = 2.2, .gap = 0.5, .restitution = 0.5});
  const Solution solution = solve(problem, {.tolerance = 1e-11});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_TRUE(solution.trajectory->impulses().empty());
  const Samples samples = solution.trajectory->sample(100);
  const std::complex<double> response = 1.0 / std::complex<double>(1.0 - 2.2 * 2.2, 0.22);
  for (int i = 0; i < 100; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 100;
    EXPECT_NEAR(samples.x(i, 0), (response * std::polar(1.0, angle)).real(), 1e-10);
  }
  EXPECT_EQ(samples.force.cwiseAbs().maxCoeff(), 0.0);
}

TEST(EventDriven, HoldsAPreloadedContactClosedForEver) {
  // g = -2: lambda = k g - F cos(w t) stays below zero as F < k |g|.
  for (const double e : {1.0, 0.5, 0.0}) {
    const Problem problem = to_problem({.frequency = 1.3, .gap = -2.0, .restitution = e});
    const Solution solution = solve(problem, {.tolerance = 1e-10});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_TRUE(solution.trajectory->impulses().empty());
    const Samples samples = solution.trajectory->sample(50);
    for (int i = 0; i < 50; ++i) {
      EXPECT_NEAR(samples.x(i, 0), -2.0, 1e-14);
      EXPECT_NEAR(samples.velocity(i, 0), 0.0, 1e-14);
      EXPECT_NEAR(samples.force(i, 0), -2.0 - std::cos(2.0 * std::numbers::pi * i / 50), 1e-12);
    }
  }
}

TEST(EventDriven, HoldsAPreloadedContactOfAChainWhileTheRestMoves) {
  Problem problem = two_masses(1.3, 0.5);
  problem.contacts[0].gap = -3.0;
  const Solution solution = solve(problem, {.tolerance = 1e-11});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  // u2 = -3: 1 DOF left, u1'' + 0.2 u1' + 2 u1 = -3; at rest in the long run. lambda = -3 - u1 - cos(w t).
  const Samples samples = solution.trajectory->sample(40);
  for (int i = 0; i < 40; ++i) {
    EXPECT_NEAR(samples.x(i, 0), -3.0, 1e-13);
    EXPECT_NEAR(samples.force(i, 0), -3.0 + 1.5 - std::cos(2.0 * std::numbers::pi * i / 40), 1e-9);
  }
}

// Symmetric motion between two stops: half a period later the mirror image. One flight from +g to -g,
// its phase by bisection; nothing is integrated.
struct SymmetricOrbit {
  double impact_time = 0.0, approach = 0.0;
};

SymmetricOrbit symmetric_orbit(const ImpactOscillator& o) {
  const double al = 0.5 * o.damping, wd = std::sqrt(1.0 - al * al), w = o.frequency,
               tau = std::numbers::pi / w;
  const std::complex<double> response = o.load / std::complex<double>(1.0 - w * w, o.damping * w);
  const double X = std::abs(response), E = std::exp(-al * tau), C = std::cos(wd * tau),
               S = std::sin(wd * tau);
  const auto speeds = [&](double phase) {  // x'(0+) and x'(tau-) of the flight from g to -g
    const double A = o.gap - X * std::cos(phase);
    const double B = ((-o.gap + X * std::cos(phase)) / E - A * C) / S;
    const double first = -al * A + wd * B - X * w * std::sin(phase);
    const double last = E * ((-al * A + wd * B) * C - (al * B + wd * A) * S) + X * w * std::sin(phase);
    return std::pair{first, last};
  };
  SymmetricOrbit best;
  constexpr int kScan = 2000;
  for (int i = 0; i < kScan; ++i) {
    double a = 2.0 * std::numbers::pi * i / kScan, b = 2.0 * std::numbers::pi * (i + 1) / kScan;
    const auto f = [&](double phase) { return speeds(phase).first - o.restitution * speeds(phase).second; };
    if (f(a) * f(b) > 0.0) continue;
    const bool rising = f(b) > 0.0;
    for (int k = 0; k < 100; ++k) {
      const double middle = 0.5 * (a + b);
      ((f(middle) > 0.0) == rising ? b : a) = middle;
    }
    const double approach = -speeds(a).second;  // towards -g, hence also towards +g half a period later
    if (approach > best.approach) {
      const double phase = a - std::arg(response);
      best = {.impact_time = std::fmod(phase / w + 4.0 * tau, 2.0 * tau), .approach = approach};
    }
  }
  return best;
}

TEST(EventDriven, BouncesSymmetricallyBetweenTwoStops) {
  const ImpactOscillator o{.frequency = 1.0, .gap = 0.4, .restitution = 0.6};
  Problem problem = to_problem(o);
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.4, .law = problem.contacts.front().law});
  const SymmetricOrbit expected = symmetric_orbit(o);
  ASSERT_GT(expected.approach, 0.0);
  const Solution solution = solve(problem, {.tolerance = 1e-11});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const auto events = test::events_of(solution);
  ASSERT_EQ(events.size(), 2U);
  const auto& upper = events[0].contact == 0 ? events[0] : events[1];
  const auto& lower = events[0].contact == 0 ? events[1] : events[0];
  EXPECT_EQ(lower.contact, 1);
  EXPECT_NEAR(upper.time, expected.impact_time, 1e-9);
  EXPECT_NEAR(test::approach_speed(upper, o.restitution), expected.approach, 1e-9);
  EXPECT_NEAR(test::approach_speed(lower, o.restitution), expected.approach, 1e-9);
  EXPECT_NEAR(std::abs(upper.time - lower.time), std::numbers::pi, 1e-9);
}

TEST(EventDriven, SeparateMassesMoveAsIfAlone) {
  // Block-diagonal: two impact oscillators of one frequency in one scene, the second a mirror image (normal
  // -1).
  const ImpactOscillator first{.frequency = 2.2, .gap = 0.2, .restitution = 0.8},
      second{.damping = 0.2, .frequency = 2.2, .gap = 0.1, .restitution = 0.8};
  Problem problem = to_problem(first);
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::Matrix2d::Identity()).sparseView();
    s.stiffness = s.mass;
    s.damping = Eigen::MatrixXd(Eigen::Vector2d(0.1, 0.2).asDiagonal()).sparseView();
  });
  problem.force.push_back({.dof = 1, .harmonic = 1, .cos = -1.0, .sin = 0.0});
  problem.contacts.push_back({.normal = {{1, -1.0}}, .gap = 0.1, .law = problem.contacts.front().law});
  const Solution solution = solve(problem, {.tolerance = 1e-11});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const auto expected =
      std::array{test::single_impact_orbits(first).at(0), test::single_impact_orbits(second).at(0)};
  const Samples samples = solution.trajectory->sample(500);
  for (int i = 0; i < 500; ++i) {
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(samples.x(i, j),
                  expected[static_cast<std::size_t>(j)].x(i * solution.trajectory->period() / 500), 1e-9);
    }
  }
}

// The trajectory's force and impulses must explain its own displacement: the structure's exact response
// to them is the motion, harmonic by harmonic. (A jump in velocity leaves 1/H of the impulse per mass.)
// Two rows of W that are equal, or nearly: the impulse is shared in any way, the motion is that of one stop.
TEST(EventDriven, TheSameRigidStopTwiceIsThatStop) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    const Problem once = two_masses(1.0, restitution);
    for (const double apart : {0.0, 1e-15, 1e-13}) {
      SCOPED_TRACE(testing::Message() << "e " << restitution << ", apart " << apart);
      Problem twice = once;
      twice.contacts.push_back(once.contacts.front());
      twice.contacts.back().gap *= 1.0 + apart;
      for (const Integrator flow : {Integrator::cvode, Integrator::modal}) {
        const EventDriven::Options options{.tolerance = 1e-9, .flow = flow};
        const Solution one = solve(once, options), two = solve(twice, options);
        ASSERT_EQ(one.verdict, Verdict::converged) << one.message;
        ASSERT_EQ(two.verdict, Verdict::converged) << two.message;
        const Samples expected = one.trajectory->sample(500), found = two.trajectory->sample(500);
        const double x = expected.x.cwiseAbs().maxCoeff();
        EXPECT_LT((found.x.col(0) - expected.x.col(0)).cwiseAbs().maxCoeff(), 1e-6 * x);
        EXPECT_LT((found.x.col(1) - expected.x.col(0)).cwiseAbs().maxCoeff(), 1e-6 * x);
        double impulse = 0.0, both = 0.0;
        for (const Impulse& each : one.trajectory->impulses()) impulse += each.value;
        for (const Impulse& each : two.trajectory->impulses()) both += each.value;
        EXPECT_NEAR(both, impulse, 1e-5 * std::abs(impulse));
      }
    }
  }
}

TEST(EventDriven, ForceAndImpulsesReproduceTheDisplacement) {
  for (const double e : {0.8, 0.0}) {
    const Problem problem = two_masses(0.6, e);
    const Solution solution = solve(problem, {.tolerance = 1e-10});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const PeriodicResponse response(problem, *solution.trajectory, 512);
    const Eigen::MatrixXd u = response.displacement(64);
    const Samples samples = solution.trajectory->sample(64);
    EXPECT_LT((u.col(1) - samples.x.col(0)).cwiseAbs().maxCoeff(), 5e-3) << e;
  }
}

TEST(EventDriven, AcceptsAnyTrajectoryAsGuess) {
  // A guess of another type, known at its contacts only: the harmonic response of a scene far from its stop.
  class Cosine final : public Trajectory {
   public:
    [[nodiscard]] int contact_count() const override { return 1; }
    [[nodiscard]] double period() const override { return 2.0 * std::numbers::pi / 2.2; }
    [[nodiscard]] Samples sample(int count) const override {
      return {.x = Eigen::MatrixXd::Zero(count, 1),
              .velocity = Eigen::MatrixXd::Zero(count, 1),
              .force = Eigen::MatrixXd::Zero(count, 1)};
    }
    [[nodiscard]] std::vector<Impulse> impulses() const override {
      return {{.contact = 0, .time = 1.3457, .value = -0.7998}};
    }
  };
  const ImpactOscillator o{.frequency = 2.2, .gap = 0.2, .restitution = 0.8};
  const Solution solution =
      solve(to_problem(o), {.tolerance = 1e-10, .steady = EventDriven::Steady::shooting},
            std::make_shared<Cosine>());
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_LE(solution.work.iterations.value_or(99), 4);  // it is a good guess
  EXPECT_LT(test::distance(*solution.trajectory, test::single_impact_orbits(o).at(0)), 1e-8);
}

TEST(EventDriven, IsDeterministic) {
  const EventDriven method({.tolerance = 1e-8});
  const Problem problem = two_masses(0.6, 0.5);
  const auto prepared = method.prepare(problem);
  const Solution first = prepared->solve({}), second = prepared->solve({});
  EXPECT_EQ(first.message, second.message);
  EXPECT_EQ(first.work.rhs_evaluations, second.work.rhs_evaluations);
  EXPECT_EQ(first.trajectory->sample(33).x, second.trajectory->sample(33).x);
}

TEST(EventDriven, StaysAtRestWithoutLoad) {
  for (const double gap : {0.3, 0.0}) {
    Problem problem = two_masses(1.0, 0.5);
    problem.force.clear();
    problem.contacts[0].gap = gap;
    const Solution solution = solve(problem, {.tolerance = 1e-9});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    EXPECT_EQ(solution.trajectory->sample(10).x.cwiseAbs().maxCoeff(), 0.0);
    EXPECT_TRUE(solution.trajectory->impulses().empty());
  }
}

TEST(EventDriven, GivesUpOnAResonanceWithoutDampingOrStop) {
  Problem problem = to_problem({.damping = 0.0, .frequency = 1.0});
  problem.contacts.clear();
  problem.set_law(std::monostate{});
  const Solution marched = solve(problem, {.tolerance = 1e-8, .max_iterations = 100});
  EXPECT_EQ(marched.verdict, Verdict::not_converged) << marched.message;
  const Solution shot = solve(problem, {.tolerance = 1e-8, .steady = EventDriven::Steady::shooting});
  EXPECT_EQ(shot.verdict, Verdict::not_converged) << shot.message;
}

TEST(EventDriven, SurvivesAGuessThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto steady : {EventDriven::Steady::marching, EventDriven::Steady::shooting}) {
    for (const double e : {0.5, 0.0}) {
      const Problem problem = two_masses(1.0, e);
      const auto guess = test::guess_from(problem, Eigen::Vector2d(0.1, nan), Eigen::Vector2d(0.0, 0.0));
      const Solution solution =
          solve(problem, {.tolerance = 1e-8, .steady = steady, .max_iterations = 50}, guess);
      EXPECT_EQ(solution.verdict, Verdict::not_converged);
      EXPECT_FALSE(solution.message.empty());
    }
  }
}

TEST(EventDriven, EndsNotConvergedWhenTheBudgetIsSpent) {
  const EventDriven method({.tolerance = 1e-9});
  const Problem problem = two_masses(1.5, 0.5);
  Start start;
  start.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  const Solution solution = method.prepare(problem)->solve(start);
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_NE(solution.message.find("time budget"), std::string::npos) << solution.message;
}

// Scaling load and gap by a scales the motion by a; scaling M, D, K and load by b changes nothing but the
// impulses.
TEST(EventDriven, ScalesWithTheScene) {
  const Problem plain = two_masses(0.6, 0.5);
  const Solution base = solve(plain, {.tolerance = 1e-10});
  ASSERT_EQ(base.verdict, Verdict::converged);
  Problem larger = plain;
  larger.force[0].cos *= 1e-5;
  larger.contacts[0].gap *= 1e-5;
  const Solution small = solve(larger, {.tolerance = 1e-10});
  ASSERT_EQ(small.verdict, Verdict::converged) << small.message;
  EXPECT_LT((small.trajectory->sample(50).x * 1e5 - base.trajectory->sample(50).x).cwiseAbs().maxCoeff(),
            1e-8);
  Problem heavier = plain;
  heavier.edit_structure([&](Structure& s) {
    s.mass *= 1e6;
    s.damping *= 1e6;
    s.stiffness *= 1e6;
  });
  heavier.force[0].cos *= 1e6;
  const Solution heavy = solve(heavier, {.tolerance = 1e-10});
  ASSERT_EQ(heavy.verdict, Verdict::converged) << heavy.message;
  EXPECT_LT((heavy.trajectory->sample(50).x - base.trajectory->sample(50).x).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR(heavy.trajectory->impulses().at(0).value / base.trajectory->impulses().at(0).value, 1e6, 1e-2);
}

}  // namespace
}  // namespace signorini::event_driven_test
