// Loads that do not change, or little, or slowly: the static contact problem, found by trying all active
// sets.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "methods/catalogue.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/expected_failure.hpp"
#include "tests/support/massless_scenes.hpp"
#include "tests/support/random_springs.hpp"

namespace signorini::static_contact_test {
namespace {

using std::string_view_literals::operator""sv;

std::vector<int> all_coordinates(const Problem& problem) {
  std::vector<int> all(static_cast<std::size_t>(problem.size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Static response of the whole structure at one instant, inertia and damping left out.
test::StaticContact static_response(const Problem& problem, double time) {
  return test::static_contact(problem, all_coordinates(problem), time, Eigen::VectorXd());
}

TEST(ConstantLoad, EveryMethodReturnsTheStaticContactProblem) {
  int solved = 0, closed = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Problem problem = test::coupled_massless_scene(seed);
    std::erase_if(problem.force, [](const ForceTerm& term) { return term.harmonic != 1; });
    for (ForceTerm& term : problem.force) term = {.dof = term.dof, .harmonic = 0, .cos = 2.0 * term.cos};
    ASSERT_NO_THROW(validate(problem));
    const test::StaticContact expected = static_response(problem, 0.0);
    closed += static_cast<int>((expected.lambda.array() < 0.0).count());
    for (const MethodEntry& entry : method_catalogue()) {
      const std::unique_ptr<Method> method = entry.make({});
      // A spring in place of the stop is another static problem.
      if (!method->supports(problem).ok || entry.name == "penalty-hbm") continue;
      SCOPED_TRACE(testing::Message() << entry.name << ", seed " << seed);
      const Solution solution = method->prepare(problem)->solve({});
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      const Samples samples = solution.trajectory->sample(64);
      const double x = expected.x.norm(), force = load_at(problem, 0.0).norm();
      for (int i = 0; i < 64; ++i) {
        EXPECT_LT((samples.x.row(i).transpose() - expected.x).norm(), 1e-7 * x);
        EXPECT_LT((samples.force.row(i).transpose() - expected.lambda).norm(), 1e-6 * force);
      }
      ++solved;
    }
  }
  EXPECT_GT(closed, 1);
  EXPECT_GE(solved, 15);  // five methods
}

// Oracle 1g: u tends to the static response; the damping force, of order omega, is what is left.
TEST(SlowLoad, MotionTendsToTheStaticResponseWithTheFrequency) {
  std::vector<double> rates, errors;
  for (const double frequency : {0.04, 0.02, 0.01, 0.005}) {
    Problem problem = test::coupled_massless_scene(2);
    problem.frequency = frequency;
    const Solution solution =
        test::solve<EventDriven>(problem, {.tolerance = 1e-8, .flow = Integrator::modal});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    constexpr int kInstants = 200;
    const Samples samples = solution.trajectory->sample(kInstants);
    double error = 0.0, size = 0.0;
    for (int i = 0; i < kInstants; ++i) {
      const test::StaticContact expected =
          static_response(problem, solution.trajectory->period() * i / kInstants);
      error = std::max(error, (samples.x.row(i).transpose() - expected.x).norm());
      size = std::max(size, expected.x.norm());
    }
    rates.push_back(frequency);
    errors.push_back(error / size);
  }
  EXPECT_LT(errors.back(), 2e-2);
  EXPECT_NEAR(test::observed_order(rates, errors), 1.0, 0.2);
}

/// Five masses, any two tied by a spring and each to the wall, three rigid contacts on combinations of three
/// of them. A constant load presses some and leaves others open; a small harmonic one changes none of it.
Problem pressed_structure(unsigned seed, const Law& law, double ripple) {
  constexpr int kMasses = 5, kContacts = 3;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(kMasses, kMasses);
  Problem problem;
  problem.name = "pressed-structure";
  problem.edit_structure([&](Structure& s) {
    s.mass = SparseMatrix(kMasses, kMasses);
    for (int i = 0; i < kMasses; ++i) {
      s.mass.coeffRef(i, i) = 2.0 + draw(random);
      K(i, i) += 2.0 + draw(random);
      test::tie_to_all_before(K, i, random);
    }
    s.stiffness = K.sparseView();
    s.damping = 0.2 * s.mass;
  });
  problem.frequency = 1.3;
  for (int dof = 0; dof < kMasses; ++dof) {
    problem.force.push_back({.dof = dof, .harmonic = 0, .cos = 4.0 * draw(random), .sin = 0.0});
    problem.force.push_back(
        {.dof = dof, .harmonic = 1, .cos = ripple * draw(random), .sin = ripple * draw(random)});
  }
  for (int c = 0; c < kContacts; ++c) {
    Contact contact{.normal = {}, .gap = 0.1 * draw(random)};
    for (int i = 0; i < 3; ++i) contact.normal.emplace_back(i, (i == c ? 1.0 : 0.0) + 0.3 * draw(random));
    problem.contacts.push_back(contact);
  }
  problem.set_law(law);
  return problem;
}

/// The static contact problem of a scene whose stops are springs: to a structure with a rigid stop behind a
/// massless coordinate they are the same, x_j = x_b + |lambda| / k.
test::StaticContact static_on_springs(const Problem& problem) {
  const auto stop = std::get<Penalty>(problem.law());
  const int size = problem.size(), contacts = problem.contact_count();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size + contacts, size + contacts);
  K.topLeftCorner(size, size) = problem.stiffness();
  Problem rigid = problem;
  for (int c = 0; c < contacts; ++c) {
    Eigen::VectorXd stretch = Eigen::VectorXd::Zero(size + contacts);
    for (const auto& [dof, coefficient] : problem.contacts[static_cast<std::size_t>(c)].normal)
      stretch[dof] += coefficient;
    stretch[size + c] = -1.0;
    K += stop.stiffness[static_cast<std::size_t>(c)] * stretch * stretch.transpose();
    rigid.contacts[static_cast<std::size_t>(c)].normal = {{size + c, 1.0}};
  }
  rigid.edit_structure([&](Structure& s) {
    s.mass = SparseMatrix(size + contacts, size + contacts);
    s.stiffness = K.sparseView();
  });
  test::StaticContact found = static_response(rigid, 0.0);
  for (int c = 0; c < contacts; ++c)
    found.x[c] -= found.lambda[c] / stop.stiffness[static_cast<std::size_t>(c)];
  return found;
}

/// The static contact problem under the constant load and, on top of it, the harmonic response of the
/// structure with x of the closed contacts held: Z u - W_A lambda_A = f, W_A^T u = 0.
struct HeldMotion {
  test::StaticContact rest;
  Eigen::VectorXcd x, lambda;  // amplitudes, of Re(.. e^{i w t})

  explicit HeldMotion(const Problem& problem) {
    Problem constant = problem;
    std::erase_if(constant.force, [](const ForceTerm& term) { return term.harmonic != 0; });
    rest = static_response(constant, 0.0);
    std::vector<int> closed;
    for (int c = 0; c < problem.contact_count(); ++c) {
      if (rest.lambda[c] < 0.0) closed.push_back(c);
    }
    const double w = problem.frequency;
    const std::complex<double> i(0.0, 1.0);
    const Eigen::MatrixXd W = contact_directions(problem), K = problem.stiffness();
    const auto n = K.rows(), a = static_cast<Eigen::Index>(closed.size());
    Eigen::MatrixXcd A = Eigen::MatrixXcd::Zero(n + a, n + a);
    A.topLeftCorner(n, n) =
        K - w * w * Eigen::MatrixXd(problem.mass()) + i * w * Eigen::MatrixXd(problem.damping());
    A.topRightCorner(n, a) = -W(Eigen::all, closed);
    A.bottomLeftCorner(a, n) = W(Eigen::all, closed).transpose();
    Eigen::VectorXcd right = Eigen::VectorXcd::Zero(n + a);
    right.head(n) = load_harmonic(problem, 1);
    const Eigen::VectorXcd z = CompleteComplexLuFactors(A).solve(right);
    x = W.transpose() * z.head(n);
    lambda = Eigen::VectorXcd::Zero(problem.contact_count());
    lambda(closed) = z.tail(a);
  }

  /// Least distance of an open contact from its stop and least force of a closed one, relative to the
  /// largest.
  [[nodiscard]] double margin(const Problem& problem) const {
    const Eigen::VectorXd gap = contact_gaps(problem);
    double least = 1.0;
    for (Eigen::Index c = 0; c < gap.size(); ++c) {
      const double open = (gap[c] - rest.x[c] - std::abs(x[c])) / rest.x.norm();
      const double pressed = (-rest.lambda[c] - std::abs(lambda[c])) / rest.lambda.norm();
      least = std::min(least, rest.lambda[c] < 0.0 ? pressed : open);
    }
    return least;
  }
};
std::unique_ptr<Method> method_named(std::string_view name) {
  for (const MethodEntry& entry : method_catalogue()) {
    if (entry.name == name) return entry.make({});
  }
  throw std::invalid_argument("no method " + std::string(name));
}

/// Solves from a cold start in at most a minute, which only a solver that loses its way needs.
Solution solve_soon(const Method& method, const Problem& problem) {
  return method.prepare(problem)->solve(
      {.deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1)});
}

void expect_held_motion(const Problem& problem, std::string_view name) {
  SCOPED_TRACE(name);
  const HeldMotion expected(problem);
  ASSERT_GT(expected.margin(problem), 0.1);
  const Solution solution = solve_soon(*method_named(name), problem);
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  constexpr int kInstants = 64;
  const Samples samples = solution.trajectory->sample(kInstants);
  double x_error = 0.0, force_error = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const auto phase = std::polar(1.0, 2.0 * std::numbers::pi * i / kInstants);
    const Eigen::VectorXd x = expected.rest.x + (phase * expected.x).real();
    const Eigen::VectorXd lambda = expected.rest.lambda + (phase * expected.lambda).real();
    x_error = std::max(x_error, (samples.x.row(i).transpose() - x).norm());
    force_error = std::max(force_error, (samples.force.row(i).transpose() - lambda).norm());
  }
  // Hat functions on 256 nodes change the response to the ripple by (2 pi / 256)^2 of it.
  const double ripple = name == "hat-lcp" ? 1e-3 : 0.0;
  EXPECT_LT(x_error, 1e-7 * expected.rest.x.norm() + ripple * expected.x.norm());
  EXPECT_LT(force_error, 1e-6 * expected.rest.lambda.norm() + ripple * expected.lambda.norm());
}

// Contacts that are closed for ever, beside others that are open for ever. It takes no impact law: the motion
// is one of all.
TEST(PressedContacts, StayAsTheConstantLoadLeavesThem) {
  int closed = 0, open = 0;
  for (const unsigned seed : {5U, 6U, 7U, 11U}) {
    for (const double restitution : {0.0, 0.5}) {
      for (const double ripple : {0.0, 0.1}) {
        const Problem problem = pressed_structure(seed, Restitution{restitution}, ripple);
        ASSERT_NO_THROW(validate(problem));
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", e " << restitution << ", ripple " << ripple);
        const auto count = static_cast<int>((HeldMotion(problem).rest.lambda.array() < 0.0).count());
        closed += count;
        open += problem.contact_count() - count;
        for (const char* name : {"hat-lcp", "closed-hbm", "exact-orbit"}) expect_held_motion(problem, name);
        if (seed == 7) expect_held_motion(problem, "event-driven");
      }
    }
  }
  EXPECT_EQ(closed, 32);
  EXPECT_EQ(open, 16);
}

// Restitution 1 leaves the same motion; it is one of many then, which not every solver meets.
TEST(PressedContacts, MayRestBesideElasticImpacts) {
  for (const unsigned seed : {5U, 6U, 7U, 11U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Problem problem = pressed_structure(seed, Restitution{1.0}, 0.1);
    expect_held_motion(problem, "closed-hbm");
  }
}

TEST(PressedContacts, RestOnSprings) {
  int solved = 0;
  for (const unsigned seed : {1U, 5U, 6U, 7U, 8U}) {
    const Problem problem = pressed_structure(seed, Penalty{{50.0, 20.0, 100.0}}, 0.0);
    ASSERT_NO_THROW(validate(problem));
    const test::StaticContact expected = static_on_springs(problem);
    ASSERT_LT(expected.lambda.minCoeff(), 0.0);
    for (const MethodEntry& entry : method_catalogue()) {
      SCOPED_TRACE(testing::Message() << entry.name << ", seed " << seed);
      const Solution solution = solve_soon(*entry.make({}), problem);
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      const Samples samples = solution.trajectory->sample(64);
      for (int i = 0; i < 64; ++i) {
        EXPECT_LT((samples.x.row(i).transpose() - expected.x).norm(), 1e-7 * expected.x.norm());
        EXPECT_LT((samples.force.row(i).transpose() - expected.lambda).norm(), 1e-6 * expected.lambda.norm());
      }
      ++solved;
    }
  }
  EXPECT_GE(solved, 30);
}

// The state in which a converged period begins may lie further from a stop that holds it than what counts as
// touching; a contact that begins open there would fall, and hit.
TEST(PressedContacts, AreClosedWhereAPeriodBegins) {
  const Problem problem = pressed_structure(11, Restitution{0.0}, 0.0);
  expect_held_motion(problem, "event-driven");
  EXPECT_TRUE(solve_soon(*method_named("event-driven"), problem).trajectory->impulses().empty());
}

/// Two masses on springs of their own, pressed alike, that come to rest one after the other.
Problem pressed_pair(double coupling, double restitution) {
  Problem problem;
  problem.name = "pressed-pair";
  problem.edit_structure([&](Structure& s) {
    s.mass = SparseMatrix(2, 2);
    s.mass.setIdentity();
    s.stiffness = s.mass;
    s.damping = 0.2 * s.mass;
  });
  problem.force = {{.dof = 0, .harmonic = 0, .cos = 1.0, .sin = 0.0},
                   {.dof = 1, .harmonic = 0, .cos = 1.0, .sin = 0.0}};
  problem.contacts = {{.normal = {{0, 1.0}, {1, coupling}}, .gap = 0.1},
                      {.normal = {{0, coupling}, {1, 1.0}}, .gap = 0.12}};
  problem.set_law(Restitution{restitution});
  return problem;
}

void expect_rest(double coupling, double restitution, Integrator flow) {
  const Problem problem = pressed_pair(coupling, restitution);
  const Solution solution = test::solve<EventDriven>(problem, {.flow = flow});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Samples samples = solution.trajectory->sample(1);
  EXPECT_LT((samples.x.row(0).transpose() - contact_gaps(problem)).norm(), 1e-8);
  EXPECT_LT((samples.force.row(0).transpose() - static_response(problem, 0.0).lambda).norm(), 1e-7);
}

TEST(PressedPair, ComesToRest) {
  expect_rest(0.0, 0.0, Integrator::cvode);
  expect_rest(0.0, 0.5, Integrator::cvode);
  expect_rest(0.2, 0.5, Integrator::cvode);
  expect_rest(-0.2, 0.0, Integrator::cvode);
}

// Nothing moves and no load changes: time passes all the same.
TEST(PressedPair, ComesToRestInTheClosedFormFlow) {
  for (const double restitution : {0.0, 0.5}) expect_rest(0.0, restitution, Integrator::modal);
}

// Each impact lifts the other contact, G_12 > 0, at a speed that shrinks by the ratio G_12^2 / (G_11 G_22): a
// chatter of two.
TEST(PressedPair, DoesNotComeToRestWhereEachImpactLiftsTheOtherMass) {
  test::expect_failure("a chatter of two contacts is not carried to its limit",
                       [] { expect_rest(0.2, 0.0, Integrator::cvode); });
}

// Restitution 1, a constant load, one contact closed and the other one out of reach.
void expect_one_at_rest(const char* name) {
  SCOPED_TRACE(name);
  Problem problem = pressed_pair(0.0, 1.0);
  problem.contacts[1].gap = 2.0;
  const Solution solution = solve_soon(*method_named(name), problem);
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const bool soft = name == "penalty-hbm"sv;
  EXPECT_NEAR(solution.trajectory->sample(1).x(0, 0), 0.1, soft ? 0.01 : 1e-7);
  EXPECT_NEAR(solution.trajectory->sample(1).force(0, 0), -0.9, soft ? 0.05 : 1e-6);
}

TEST(PressedPair, RestsBesideAnOpenContact) {
  for (const char* name : {"fourier-lipschitz", "penalty-hbm", "aft-hbm", "closed-hbm"})
    expect_one_at_rest(name);
}

TEST(PressedPair, DoesNotRestBesideAnOpenContactOnHatFunctions) {
  test::expect_failure("the pivots of an elastic mass at rest on its stop do not end",
                       [] { expect_one_at_rest("hat-lcp"); });
}

}  // namespace
}  // namespace signorini::static_contact_test
