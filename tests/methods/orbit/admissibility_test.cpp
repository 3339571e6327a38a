// Solutions of the orbit equations that are motions of the scene, and some that are not.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::admissibility_test {
namespace {

// The equations of a guess as they stand: a sequence on its own state, solved or not.
Admissibility check(const Problem& problem, const OrbitGuess& guess) {
  OrbitModel model(problem);
  OrbitEquations equations(model, guess);
  EXPECT_TRUE(equations.evaluate(equations.guess()));
  return check_admissible(model, guess, equations);
}

OrbitGuess orbit_of(const Problem& problem) {
  const auto found = test::cold_orbit(problem);
  EXPECT_TRUE(found.orbit) << found.solution.message;
  return found.orbit->orbit();
}

TEST(Admissibility, AcceptsAnOrbitAndMeasuresItsWeakestImpact) {
  const test::ImpactOscillator o{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};
  const Problem problem = test::to_problem(o);
  const Admissibility found = check(problem, orbit_of(problem));
  EXPECT_TRUE(found.ok) << found.reason;
  EXPECT_EQ(found.impacts, 1);
  EXPECT_NEAR(found.weakest_impact,
              test::single_impact_orbits(o).at(0).approach / ContactDynamics(problem).scales().velocity,
              1e-9);
  EXPECT_LE(found.violation, kAdmissible);
}

TEST(Admissibility, FindsPenetrationBetweenEvents) {
  // The linear response A cos(w t - phi) reaches beyond the stop by A - g.
  const double w = 2.2, d = 0.1, gap = 0.2;
  const Problem problem = test::to_problem({.damping = d, .frequency = w, .gap = gap});
  const std::complex<double> response = 1.0 / std::complex<double>(1.0 - w * w, d * w);
  const OrbitGuess linear{.start = {.time = 0.0,
                                    .state = {.u = Eigen::VectorXd::Constant(1, response.real()),
                                              .v = Eigen::VectorXd::Constant(1, -w * response.imag())},
                                    .closed = {false}},
                          .events = {},
                          .origin = "the linear response"};
  const Admissibility found = check(problem, linear);
  EXPECT_FALSE(found.ok);
  EXPECT_NE(found.reason.find("penetrates"), std::string::npos);
  EXPECT_NEAR(found.violation, (std::abs(response) - gap) / ContactDynamics(problem).scales().displacement,
              1e-12);
}

TEST(Admissibility, FindsTension) {
  // Held at the stop throughout, although the load pulls it away for half of the time.
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 0.7, .gap = 0.0});
  const OrbitGuess held{.start = {.time = 0.0,
                                  .state = {.u = Eigen::VectorXd::Zero(1), .v = Eigen::VectorXd::Zero(1)},
                                  .closed = {true}},
                        .events = {},
                        .origin = "held"};
  const Admissibility found = check(problem, held);
  EXPECT_FALSE(found.ok);
  EXPECT_NE(found.reason.find("pulls"), std::string::npos);
  EXPECT_NEAR(found.violation, 1.0 / ContactDynamics(problem).force_scale(0), 1e-12);  // lambda = -cos(w t)
}

TEST(Admissibility, FindsAnImpactThatIsNotTheScenesLaw) {
  const Problem elastic =
      test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8});
  OrbitGuess guess = orbit_of(elastic);
  guess.events.at(0).restitution = {0.0};
  const Admissibility found = check(elastic, guess);
  EXPECT_FALSE(found.ok);
  EXPECT_NE(found.reason.find("without the chatter"), std::string::npos) << found.reason;
}

// Two masses alike, apart from each other, that strike at one event: where the second one's stop is a little
// further away it is struck before it is there, though nothing penetrates and nothing pulls.
TEST(Admissibility, FindsAContactThatAnEventStopsBeforeItsStop) {
  const test::ImpactOscillator o{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};
  const OrbitGuess one = orbit_of(test::to_problem(o));
  Problem two = test::to_problem(o);
  two.edit_structure([](Structure& s) {
    for (SparseMatrix* matrix : {&s.mass, &s.damping, &s.stiffness}) {
      const double value = matrix->coeff(0, 0);
      *matrix = SparseMatrix(Eigen::MatrixXd(value * Eigen::Matrix2d::Identity()).sparseView());
    }
  });
  two.force.push_back(two.force[0]);
  two.force[1].dof = 1;
  two.contacts.push_back({.normal = {{1, 1.0}}, .gap = o.gap, .law = two.contacts.front().law});
  OrbitGuess both = one;
  both.start.state.u = Eigen::Vector2d::Constant(one.start.state.u[0]);
  both.start.state.v = Eigen::Vector2d::Constant(one.start.state.v[0]);
  both.start.closed = {false, false};
  ASSERT_EQ(both.events.size(), 1U);
  both.events[0].pushed = {0, 1};
  both.events[0].restitution = {o.restitution, o.restitution};
  both.events[0].closed = {false, false};
  const Admissibility alike = check(two, both);
  EXPECT_TRUE(alike.ok) << alike.reason;
  two.contacts[1].gap += 1e-9;
  const Admissibility apart = check(two, both);
  EXPECT_FALSE(apart.ok);
  EXPECT_NE(apart.reason.find("contact 1 is held"), std::string::npos) << apart.reason;
}

TEST(Admissibility, CallsACompleteChatterWhatItIs) {
  const Problem problem =
      test::to_problem({.damping = 0.02, .frequency = 0.5, .gap = 0.2, .restitution = 0.5});
  const Admissibility found = check(problem, orbit_of(problem));
  EXPECT_TRUE(found.ok) << found.reason;
  EXPECT_GT(found.chatter_error.maxCoeff(), 0.0);
  EXPECT_LE(found.chatter_error.maxCoeff(), kLeftOut);
}

}  // namespace
}  // namespace signorini::admissibility_test
