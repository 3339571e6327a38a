// Structures that nothing but their stops holds: the stiffness matrix is singular, the contacts carry the
// mean load.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "methods/catalogue.hpp"
#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::free_structure_test {
namespace {

using test::solve;

/// Masses in a row, springs and dampers between neighbours and none to the ground; a stop for the last one,
/// on which a load at the first one presses it, mean + amplitude cos(w t).
struct FreeChain {
  int masses = 1;
  double spread = 0.0;     ///< of masses and springs about 1, at random, in [0, 1)
  double mean = 0.5;       ///< [N]
  double amplitude = 1.0;  ///< [N]
  double damping = 0.0;    ///< times the springs [s]
  bool massless = false;   ///< the last one, which is not damped then
  double restitution = 0.0;
};

constexpr double kFrequency = 1.1, kPeriod = 2.0 * std::numbers::pi / kFrequency, kGap = 0.2;

void tie(SparseMatrix& matrix, int i, double coefficient) {
  matrix.coeffRef(i, i) += coefficient;
  matrix.coeffRef(i - 1, i - 1) += coefficient;
  matrix.coeffRef(i, i - 1) -= coefficient;
  matrix.coeffRef(i - 1, i) -= coefficient;
}

Problem to_problem(const FreeChain& chain) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(1.0 - chain.spread, 1.0 + chain.spread);
  const int n = chain.masses;
  Problem problem;
  problem.name = "free-chain";
  problem.edit_structure([&](Structure& s) {
    s.mass = s.stiffness = s.damping = SparseMatrix(n, n);
    for (int i = 0; i < n; ++i) {
      const bool massless = chain.massless && i == n - 1;
      if (!massless) s.mass.coeffRef(i, i) = draw(random);
      if (i == 0) continue;
      const double spring = draw(random);
      tie(s.stiffness, i, spring);
      if (!massless) tie(s.damping, i, chain.damping * spring);
    }
  });
  problem.frequency = kFrequency;
  problem.force = {{.dof = 0, .harmonic = 0, .cos = chain.mean, .sin = 0.0},
                   {.dof = 0, .harmonic = 1, .cos = chain.amplitude, .sin = 0.0}};
  problem.contacts = {{.normal = {{n - 1, 1.0}}, .gap = kGap}};
  if (chain.massless) {
    problem.set_law(Massless{});
  } else {
    problem.set_law(Restitution{chain.restitution});
  }
  return problem;
}

// The mean of the rigid motion is an unknown of all methods but impact closure, which says that it has none.
void expect_taken(const Problem& problem) {
  ASSERT_NO_THROW(validate(problem));
  for (const MethodEntry& entry : method_catalogue()) {
    const std::unique_ptr<Method> method = entry.make({});
    if (!method->supports(problem).ok) continue;  // too many coordinates to be followed through time
    SCOPED_TRACE(entry.name);
    std::unique_ptr<PreparedMethod> prepared;
    ASSERT_NO_THROW(prepared = method->prepare(problem));
    if (entry.name != ClosedHbm::kText.name || std::holds_alternative<Massless>(problem.law())) continue;
    const Solution solution = prepared->solve({});
    EXPECT_EQ(solution.verdict, Verdict::not_converged);
    EXPECT_NE(solution.message.find("no spring holds"), std::string::npos) << solution.message;
  }
}

TEST(FreeStructure, IsTakenByPeriodicMethods) {
  for (const int masses : {1, 2, 10, 100}) {
    SCOPED_TRACE(testing::Message() << masses << " masses");
    expect_taken(to_problem({.masses = masses}));
  }
  expect_taken(to_problem({.masses = 20, .spread = 0.5}));
}

// A sparse factorisation meets a pivot of rounding size here, not zero: left to itself it would go on.
TEST(FreeStructure, OfManyUnequalMassesIsTakenToo) {
  for (const int masses : {40, 200, 500}) expect_taken(to_problem({.masses = masses, .spread = 0.5}));
}

/// A free mass on an inelastic stop, pressed by p(t) = P + F cos(w t), F > P > 0. It leaves when p becomes
/// negative and stays where it lands, p being positive by then. From the instant t0 of departure
///
///     x - g = P s^2 / 2 - F / w^2 (cos w t - cos w t0) - F / w sin(w t0) s,   s = t - t0.
class Hop {
 public:
  Hop(double mean, double amplitude)
      : mean_(mean), amplitude_(amplitude), leave_(std::acos(-mean / amplitude) / kFrequency) {
    constexpr double kStep = 1e-3;
    land_ = leave_ + kStep;
    while (height(land_) < 0.0) land_ += kStep;
    double before = land_ - kStep;
    while (land_ - before > 1e-14) {
      const double middle = 0.5 * (before + land_);
      (height(middle) < 0.0 ? before : land_) = middle;
    }
  }

  [[nodiscard]] double x(double time) const {
    const double t = time - kPeriod * std::floor((time - leave_) / kPeriod);
    return kGap + (t < land_ ? height(t) : 0.0);
  }
  [[nodiscard]] bool stays() const {
    return mean_ + amplitude_ * std::cos(kFrequency * land_) > 0.0 && land_ < leave_ + kPeriod;
  }

 private:
  [[nodiscard]] double height(double t) const {
    const double s = t - leave_, w = kFrequency;
    return 0.5 * mean_ * s * s - amplitude_ / (w * w) * (std::cos(w * t) - std::cos(w * leave_)) -
           amplitude_ / w * std::sin(w * leave_) * s;
  }

  double mean_, amplitude_, leave_, land_ = 0.0;
};

TEST(FreeStructure, HopsAsTheClosedFormSays) {
  for (const double amplitude : {0.6, 0.8, 1.0}) {
    const Hop hop(0.5, amplitude);
    ASSERT_TRUE(hop.stays());
    for (const Integrator flow : {Integrator::cvode, Integrator::modal}) {
      const Problem problem = to_problem({.mean = 0.5, .amplitude = amplitude});
      const Solution solution = solve<EventDriven>(problem, {.flow = flow});
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      EXPECT_LT(test::relative_error(*solution.trajectory, [&](double t) { return hop.x(t); }), 1e-8)
          << "F " << amplitude;
    }
  }
}

Problem on_a_ground(double stiffness) {
  Problem problem = to_problem({});
  problem.edit_structure([&](Structure& s) { s.stiffness.coeffRef(0, 0) = stiffness; });
  return problem;
}

TEST(FreeStructure, HopsOnHatFunctionsAtFirstOrder) {
  const Hop hop(0.5, 0.8);
  std::vector<double> steps, errors;
  for (const int samples : {64, 128, 256, 512}) {
    const Solution solution =
        solve<HatLcp>(to_problem({.mean = 0.5, .amplitude = 0.8}), {.samples = samples});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    steps.push_back(1.0 / samples);
    errors.push_back(test::relative_error(*solution.trajectory, [&hop](double time) { return hop.x(time); }));
  }
  EXPECT_GT(test::observed_order(steps, errors), 0.9);
  EXPECT_LT(errors.back(), 1e-3);
}

// A spring to the ground changes the motion by as much as it is weak.
TEST(NearlyFreeMass, HopsAsTheFreeOneButForItsGround) {
  const Hop hop(FreeChain{}.mean, FreeChain{}.amplitude);
  const auto x = [&hop](double time) { return hop.x(time); };
  std::vector<double> grounds, marched, exact;
  for (const double ground : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const Problem problem = on_a_ground(ground);
    const Solution flow = solve<EventDriven>(problem, {}), orbit = solve<ExactOrbitMethod>(problem, {});
    ASSERT_EQ(flow.verdict, Verdict::converged) << flow.message;
    ASSERT_EQ(orbit.verdict, Verdict::converged) << orbit.message;
    grounds.push_back(ground);
    marched.push_back(test::relative_error(*flow.trajectory, x));
    exact.push_back(test::relative_error(*orbit.trajectory, x));
  }
  EXPECT_NEAR(test::observed_order(grounds, marched), 1.0, 0.02);
  EXPECT_NEAR(test::observed_order(grounds, exact), 1.0, 0.02);

  std::vector<double> steps, errors;
  for (const int samples : {64, 128, 256, 512}) {
    const Solution nodes = solve<HatLcp>(on_a_ground(1e-6), {.samples = samples});
    ASSERT_EQ(nodes.verdict, Verdict::converged) << nodes.message;
    steps.push_back(1.0 / samples);
    errors.push_back(test::relative_error(*nodes.trajectory, x));
  }
  EXPECT_GT(test::observed_order(steps, errors), 0.9);  // an impact: first order at least
  EXPECT_LT(errors.back(), 1e-3);
}

double impulse(const Trajectory& trajectory) {
  double sum = -trajectory.sample(20000).force.col(0).mean() * trajectory.period();
  for (const Impulse& one : trajectory.impulses()) sum -= one.value;
  return sum;
}

// A period leaves the momentum as it was.
TEST(FreeStructure, IsHeldByTheImpulseOfItsMeanLoad) {
  const FreeChain chains[] = {{.masses = 2, .amplitude = 0.4, .restitution = 0.5},
                              {.masses = 2, .amplitude = 1.0, .restitution = 0.5},
                              {.masses = 3, .amplitude = 1.0},
                              {.masses = 6, .amplitude = 1.0},
                              {.masses = 3, .amplitude = 0.4, .massless = true},
                              {.masses = 6, .amplitude = 0.4, .massless = true}};
  for (FreeChain chain : chains) {
    chain.spread = chain.damping = 0.3;
    SCOPED_TRACE(testing::Message() << chain.masses << " masses, F " << chain.amplitude);
    const Problem problem = to_problem(chain);
    ASSERT_NO_THROW(validate(problem));
    const Solution solution = solve<EventDriven>(problem, {.flow = Integrator::modal});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    // The force jumps at instants known to one of 20000 samples.
    const double expected = chain.mean * solution.trajectory->period();
    EXPECT_NEAR(impulse(*solution.trajectory), expected, 1e-3 * expected);
  }
}

// Stops only push: nothing comes back that is pulled away.
TEST(FreeStructure, HasNoPeriodicMotionWhereTheMeanLoadPullsItAway) {
  for (const double mean : {-0.1, -1.0}) {
    const Problem problem = to_problem({.masses = 3, .spread = 0.3, .mean = mean, .damping = 0.3});
    const Solution solution = solve<EventDriven>(problem, {.flow = Integrator::modal, .max_iterations = 50});
    EXPECT_EQ(solution.verdict, Verdict::not_converged) << solution.message;
    EXPECT_FALSE(solution.work.iterations) << "known before a period is marched";
    EXPECT_NE(solution.message.find("no periodic motion"), std::string::npos) << solution.message;
  }
}

}  // namespace
}  // namespace signorini::free_structure_test
