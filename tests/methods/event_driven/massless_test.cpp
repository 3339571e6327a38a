// Contacts without mass: one solution, no impact law, whichever method computes it.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/flow/flow.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/structure/periodic_response.hpp"
#include "problems/validation.hpp"
#include "tests/methods/event_driven/scenes.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/massless_scenes.hpp"
#include "tests/support/relaxing_scenes.hpp"

namespace signorini::massless_test {
namespace {

using test::solve;

const std::vector<int> kMassless{4, 5, 6};  // of coupled_massless_scene

FlowState at_rest(const EventFlow& flow) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(flow.dynamics().size());
  return flow.place(0.0, {.u = zero, .v = zero});
}

class MasslessFlow : public testing::TestWithParam<Integrator> {};

TEST_P(MasslessFlow, SolvesTheStaticContactProblemAtEveryInstant) {
  int together = 0, changes = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Problem problem = test::coupled_massless_scene(seed);
    ASSERT_NO_THROW(validate(problem));
    const ContactDynamics dynamics(problem);
    EventFlow flow(
        dynamics, 1e-10, [] { return false; }, GetParam());
    FlowState state = at_rest(flow);
    for (int step = 0; step < 60; ++step) {
      FlowRecord record;
      flow.advance(state, 0.17, record);
      changes += static_cast<int>(record.events.size());
      const auto closed = std::count(state.closed.begin(), state.closed.end(), true);
      if (closed > 1) ++together;
      const MotionDerivatives motion =
          dynamics.derivatives(dynamics.mode(state.closed), state.time, state.state, 2);
      const test::StaticContact expected =
          test::static_contact(problem, kMassless, state.time, state.state.u);
      const double X = dynamics.scales().displacement;
      EXPECT_LT((motion.x.col(0) - expected.x).norm(), 1e-9 * X) << "t = " << state.time;
      EXPECT_LT((motion.lambda.col(0) - expected.lambda).norm(),
                1e-9 * (X / dynamics.structure().compliance(0, 0)));
      EXPECT_EQ(dynamics.mode(flow.place(state.time, state.state).closed).active,
                dynamics.mode(state.closed).active);
    }
  }
  EXPECT_GT(together, 20);  // the coupling of the contacts is at work
  EXPECT_GT(changes, 40);
}

INSTANTIATE_TEST_SUITE_P(Both, MasslessFlow, testing::Values(Integrator::cvode, Integrator::modal),
                         [](const auto& info) {
                           return info.param == Integrator::cvode ? "Cvode" : "Modal";
                         });

TEST(MasslessContacts, BothFlowsAreTheSameMotion) {
  const Problem problem = test::coupled_massless_scene(2);
  const ContactDynamics dynamics(problem);
  State ends[2];
  for (const Integrator integrator : {Integrator::cvode, Integrator::modal}) {
    EventFlow flow(
        dynamics, 1e-11, [] { return false; }, integrator);
    FlowState state = at_rest(flow);
    FlowRecord record;
    flow.advance(state, 20.0, record);
    EXPECT_GT(record.events.size(), 10U);
    ends[integrator == Integrator::cvode ? 0 : 1] = state.state;
  }
  EXPECT_LT((ends[0].u - ends[1].u).norm(), 1e-9 * dynamics.scales().displacement);
  EXPECT_LT((ends[0].v - ends[1].v).norm(), 1e-9 * dynamics.scales().velocity);
}

// x = W^T Z^-1 (f + W lambda) in the scene's own matrices, massless coordinates included.
TEST(MasslessContacts, PeriodicMotionSatisfiesTheEquationsOfTheWholeScene) {
  for (const Problem& problem : {test::massless_node(), test::coupled_massless_scene(1)}) {
    const Solution solution = solve<EventDriven>(problem, {.tolerance = 1e-10});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples samples = solution.trajectory->sample(1024);
    EXPECT_LE((samples.x.rowwise() - contact_gaps(problem).transpose()).maxCoeff(), 1e-12);
    EXPECT_LT(samples.force.minCoeff(), 0.0);
    // Summed to H harmonics; those of a force with kinks fall like n^-2, which leaves some H^-3/2 of it.
    const Eigen::MatrixXd W = contact_directions(problem);
    std::vector<double> step, missing;
    for (const int harmonics : {64, 128, 256, 512}) {
      const Eigen::MatrixXd x =
          PeriodicResponse(problem, *solution.trajectory, harmonics).displacement(1024) * W;
      step.push_back(1.0 / harmonics);
      missing.push_back((x - samples.x).norm() / samples.x.norm());
    }
    EXPECT_LT(missing.back(), 3e-4);
    EXPECT_NEAR(test::observed_order(step, missing), 1.5, 0.15);
  }
}

// Oracle 1f: u_c = min(u_n, g), lambda = -k (u_n - g)_+, the mass as with a spring stop.
TEST(MasslessContacts, ANodeOnOneSpringIsThatSpringAsAStop) {
  const double g = 0.2, k = 50.0;
  Problem spring;
  spring.edit_structure([&](Structure& s) {
    s.mass = s.damping = s.stiffness = SparseMatrix(1, 1);
    s.mass.coeffRef(0, 0) = s.stiffness.coeffRef(0, 0) = 1.0;
    s.damping.coeffRef(0, 0) = 0.1;
  });
  spring.frequency = 2.2;
  spring.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  spring.contacts = {{.normal = {{0, 1.0}}, .gap = g}};
  spring.set_law(Penalty{{k}});
  for (const Integrator flow : {Integrator::cvode, Integrator::modal}) {
    const Solution node = solve<EventDriven>(test::massless_node(g, k), {.tolerance = 1e-11, .flow = flow});
    const Solution stop = solve<EventDriven>(spring, {.tolerance = 1e-11, .flow = flow});
    ASSERT_EQ(node.verdict, Verdict::converged) << node.message;
    const Samples ours = node.trajectory->sample(1000), theirs = stop.trajectory->sample(1000);
    for (int i = 0; i < 1000; ++i) {
      EXPECT_NEAR(ours.x(i, 0), std::min(g, theirs.x(i, 0)), 1e-9);
      EXPECT_NEAR(ours.force(i, 0), -k * std::max(0.0, theirs.x(i, 0) - g), 1e-8);
    }
  }
}

TEST(MasslessContacts, ExactOrbitsAndEventDrivenAgree) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Problem problem = test::coupled_massless_scene(seed);
    const Solution marched = solve<EventDriven>(problem, {.tolerance = 1e-11, .flow = Integrator::modal});
    const Solution exact = solve<ExactOrbitMethod>(problem, {});
    ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
    ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
    EXPECT_LT(test::relative_distance(*marched.trajectory, *exact.trajectory), 1e-9) << "seed " << seed;
  }
}

// A force with kinks: coefficients fall like n^-2, those of x (through a compliance at high frequency) too.
TEST(MasslessContacts, FourierAndHatFunctionsTendToTheExactOrbit) {
  const Problem problem = test::coupled_massless_scene(1);
  const Solution exact = solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
  std::vector<double> per_harmonic, fourier, step, hat;
  for (const int harmonics : {10, 20, 40, 80}) {
    const Solution solution = solve<FourierLipschitz>(problem, {{.harmonics = harmonics}});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    per_harmonic.push_back(1.0 / harmonics);
    fourier.push_back(test::relative_distance(*solution.trajectory, *exact.trajectory));
  }
  for (const int samples : {64, 128, 256, 512}) {
    const Solution solution = solve<HatLcp>(problem, {.samples = samples});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    step.push_back(1.0 / samples);
    hat.push_back(test::relative_distance(*solution.trajectory, *exact.trajectory));
  }
  EXPECT_GT(test::observed_order(per_harmonic, fourier), 1.3);
  EXPECT_LT(test::observed_order(per_harmonic, fourier), 2.2);
  EXPECT_GT(test::observed_order(step, hat), 1.3);
  EXPECT_LT(test::observed_order(step, hat), 2.2);
}

TEST(MasslessContacts, TheSameStopTwiceChangesNothingButTheShareOfTheForce) {
  const Problem once = test::coupled_massless_scene(1);
  Problem twice = once;
  twice.contacts.push_back(once.contacts[1]);
  ASSERT_NO_THROW(validate(twice));
  for (const Integrator flow : {Integrator::cvode, Integrator::modal}) {
    const Solution one = solve<EventDriven>(once, {.tolerance = 1e-10, .flow = flow});
    const Solution two = solve<EventDriven>(twice, {.tolerance = 1e-10, .flow = flow});
    ASSERT_EQ(two.verdict, Verdict::converged) << two.message;
    const Samples expected = one.trajectory->sample(1000), found = two.trajectory->sample(1000);
    const double x = expected.x.cwiseAbs().maxCoeff(), lambda = expected.force.cwiseAbs().maxCoeff();
    EXPECT_LT((found.x.leftCols(3) - expected.x).cwiseAbs().maxCoeff(), 1e-8 * x);
    EXPECT_LT((found.x.col(3) - expected.x.col(1)).cwiseAbs().maxCoeff(), 1e-8 * x);
    EXPECT_LT((found.force.col(1) + found.force.col(3) - expected.force.col(1)).cwiseAbs().maxCoeff(),
              1e-8 * lambda);
  }
}

TEST(MasslessContacts, DampedByTheirStiffnessAreTheSameForEveryMethod) {
  const Problem problem = test::damped_coupled_scene(1, 0.2);
  ASSERT_NO_THROW(validate(problem));
  const Solution exact = solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
  EXPECT_GT(exact.trajectory->events()->size(), 1U);
  for (const Integrator flow : {Integrator::cvode, Integrator::modal}) {
    const Solution followed = solve<EventDriven>(problem, {.tolerance = 1e-10, .flow = flow});
    ASSERT_EQ(followed.verdict, Verdict::converged) << followed.message;
    EXPECT_LT(test::relative_distance(*followed.trajectory, *exact.trajectory), 1e-8);
  }
  const Solution hat = solve<HatLcp>(problem, {.samples = 512});
  ASSERT_EQ(hat.verdict, Verdict::converged) << hat.message;
  EXPECT_LT(test::relative_distance(*hat.trajectory, *exact.trajectory), 1e-2);
}

TEST(MasslessContacts, DampedOtherwiseAreRefusedWithTheReason) {
  Problem damped = test::massless_node();
  damped.edit_structure([&](Structure& s) {
    s.damping = SparseMatrix(0.1 * s.stiffness);
    s.damping.coeffRef(1, 1) += 0.1;
  });
  EXPECT_EQ(EventDriven({}).supports(damped).reason,
            "the damping of coordinates without mass is not proportional to their stiffness");
  EXPECT_EQ(ExactOrbitMethod({}).supports(damped).reason, EventDriven({}).supports(damped).reason);
  Problem sprung = test::massless_node();
  sprung.edit_structure([&](Structure& s) { s.damping = SparseMatrix(0.1 * s.stiffness); });
  EXPECT_EQ(EventDriven({}).supports(sprung).reason, "");
  sprung.set_law(Penalty{.stiffness = {50.0}});
  EXPECT_EQ(EventDriven({}).supports(sprung).reason,
            "contact 0 is a spring on a coordinate without mass that is damped");
}

/// Radius of the synchronous full rub of oracle 1i without friction: the solutions of
/// (a^2 + b^2) r^2 - 2 k_c d a r + k_c^2 d^2 = (m e W^2)^2, a = k + k_c - m W^2, b = c W; the larger one.
double rub_radius(double speed, double spring) {
  const double a = 1.0 + spring - speed * speed, b = 0.05 * speed, d = 0.3;
  const double load = 0.1 * speed * speed;
  const double A = a * a + b * b, B = spring * d * a, C = spring * spring * d * d - load * load;
  return (B + std::sqrt(B * B - A * C)) / A;
}

// A rotor whose massless ring slides in a polygon of F stops: its projection on the polygon tends to that on
// the circle, and the polygon's ripple, of frequency F W, moves the mass by 1/F^2 of the force.
TEST(MasslessContacts, FullAnnularRubInAPolygonTendsToTheRoundStator) {
  constexpr double kSpeed = 1.1, kSpring = 20.0;
  const double radius = rub_radius(kSpeed, kSpring);
  ASSERT_GT(radius, 0.3);
  std::vector<double> pitch, errors;
  for (const int facets : {16, 32, 64, 128}) {
    const Problem problem = test::ring_in_polygon(facets, kSpeed, kSpring);
    ASSERT_NO_THROW(validate(problem));
    const Solution solution = solve<EventDriven>(problem, {.tolerance = 1e-9, .flow = Integrator::modal});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    // Mean radial force: that of the spring at the radius of the rub.
    const Samples samples = solution.trajectory->sample(4096);
    double force = 0.0;
    for (int j = 0; j < facets; ++j) force -= samples.force.col(j).mean();
    pitch.push_back(1.0 / facets);
    errors.push_back(std::abs(force - kSpring * (radius - 0.3)) / (kSpring * (radius - 0.3)));
  }
  EXPECT_LT(errors.back(), 2e-2);
  EXPECT_NEAR(test::observed_order(pitch, errors), 2.0, 0.3);
}

}  // namespace
}  // namespace signorini::massless_test
