#include "methods/hat_lcp/hat_lcp.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"
#include "tests/support/massless_scenes.hpp"
#include "tests/support/population.hpp"

namespace signorini::hat_lcp_test {
namespace {

using test::observed_order;
using test::relative_error;
using test::solve;

// S-A of docs/theory.md, omega = 1.5: one impact per period for each e > 0.
test::ImpactOscillator oscillator(double e) {
  return {.damping = 0.1, .frequency = 1.5, .gap = 0.2, .restitution = e};
}

double error_at(const test::ImpactOscillator& system, const HatLcp::Options& options) {
  const auto orbit = test::single_impact_orbits(system).front();
  const Solution solution = solve<HatLcp>(test::to_problem(system), options);
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  return relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); });
}

struct OrderCase {
  HatLcp::Scheme scheme;
  double restitution;
};

void PrintTo(const OrderCase& c, std::ostream* out) {
  *out << EnumNames<HatLcp::Scheme>::values[static_cast<std::size_t>(c.scheme)] << " e = " << c.restitution;
}

class HatLcpOrder : public testing::TestWithParam<OrderCase> {};

TEST_P(HatLcpOrder, IsOneAgainstTheClosedFormOrbit) {
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int samples : {128, 256, 512, 1024, 2048}) {
    steps.push_back(1.0 / samples);
    errors.push_back(
        error_at(oscillator(GetParam().restitution), {.samples = samples, .scheme = GetParam().scheme}));
  }
  const double order = observed_order(steps, errors);
  EXPECT_GE(order, 0.9);
  EXPECT_LE(order, 1.3);
  EXPECT_LE(errors.back(), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(
    EachRestitution, HatLcpOrder,
    testing::Values(OrderCase{HatLcp::Scheme::galerkin, 0.5}, OrderCase{HatLcp::Scheme::galerkin, 0.8},
                    OrderCase{HatLcp::Scheme::galerkin, 1.0}, OrderCase{HatLcp::Scheme::nodal, 0.5},
                    OrderCase{HatLcp::Scheme::nodal, 0.8}, OrderCase{HatLcp::Scheme::nodal, 1.0}));

TEST(HatLcp, BackwardDifferencesRepresentRestitutionZero) {
  // One impact without sticking: S-A at e = 0.
  const test::ImpactOscillator system{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.0};
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int samples : {128, 256, 512, 1024}) {
    steps.push_back(1.0 / samples);
    errors.push_back(error_at(system, {.samples = samples, .scheme = HatLcp::Scheme::backward}));
  }
  EXPECT_GE(observed_order(steps, errors), 0.8);
  EXPECT_LE(errors.back(), 2e-2);
}

TEST(HatLcp, BackwardDifferencesOfSecondOrderTakeNoImpactLaw) {
  const HatLcp method({.scheme = HatLcp::Scheme::bdf2});
  const Support support = method.supports(test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = 0.2}));
  EXPECT_FALSE(support.ok);
  EXPECT_EQ(support.reason,
            "scheme = bdf2 represents no impact law: massless contacts and spring stops only");
}

// Left to itself it refines its grid until two agree, on one reduction of the structure.
TEST(HatLcp, MarchesMasslessContactsUnderBackwardDifferencesOfSecondOrder) {
  const Problem problem = test::massless_node();
  const Solution solution = solve<HatLcp>(problem, {.scheme = HatLcp::Scheme::bdf2});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_FALSE(solution.work.pivots);
  const Solution galerkin = solve<HatLcp>(problem, {.samples = 1024});
  ASSERT_EQ(galerkin.verdict, Verdict::converged) << galerkin.message;
  const Eigen::MatrixXd x = solution.trajectory->sample(256).x, other = galerkin.trajectory->sample(256).x;
  EXPECT_LE((x - other).norm(), 0.02 * other.norm());
}

TEST(HatLcp, IsSecondOrderWhereNothingTouches) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = 5.0});
  const std::complex<double> amplitude = 1.0 / std::complex<double>(1.0 - 2.25, 0.15);
  for (const auto scheme : {HatLcp::Scheme::galerkin, HatLcp::Scheme::nodal}) {
    std::vector<double> steps;
    std::vector<double> errors;
    for (const int samples : {32, 64, 128, 256}) {
      const Solution solution = solve<HatLcp>(problem, {.samples = samples, .scheme = scheme});
      EXPECT_EQ(solution.work.pivots, 0);
      steps.push_back(1.0 / samples);
      errors.push_back(relative_error(
          *solution.trajectory, [&](double t) { return (amplitude * std::polar(1.0, 1.5 * t)).real(); }, 0,
          samples));
    }
    EXPECT_NEAR(observed_order(steps, errors), 2.0, 0.1);
  }
}

TEST(HatLcp, BackwardDifferencesAreFirstOrderWhereNothingTouches) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = 5.0});
  const std::complex<double> amplitude = 1.0 / std::complex<double>(1.0 - 2.25, 0.15);
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int samples : {64, 128, 256, 512}) {
    const Solution solution =
        solve<HatLcp>(problem, {.samples = samples, .scheme = HatLcp::Scheme::backward});
    steps.push_back(1.0 / samples);
    errors.push_back(relative_error(
        *solution.trajectory, [&](double t) { return (amplitude * std::polar(1.0, 1.5 * t)).real(); }, 0,
        samples));
  }
  EXPECT_NEAR(observed_order(steps, errors), 1.0, 0.1);
}

TEST(HatLcp, PermanentContactIsHeldWithTheStaticForceAndTheLoad) {
  // Preload 1.5 against a load of 1: the mass never leaves the stop, lambda = k g - f.
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = -1.5, .restitution = 0.5});
  for (const auto scheme : {HatLcp::Scheme::galerkin, HatLcp::Scheme::nodal, HatLcp::Scheme::backward}) {
    const Solution solution = solve<HatLcp>(problem, {.samples = 64, .scheme = scheme});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples samples = solution.trajectory->sample(64);
    EXPECT_LE((samples.x.array() + 1.5).abs().maxCoeff(), 1e-12);
    for (int i = 0; i < 64; ++i) {
      const double load = std::cos(2.0 * std::numbers::pi * i / 64);
      EXPECT_NEAR(samples.force(i, 0), -1.5 - load, 4e-3);
    }
  }
}

TEST(HatLcp, WithoutRestitutionTheImpactLawIsUndetermined) {
  const Problem problem = test::to_problem(oscillator(0.8));
  const HatLcp method({.restitution = HatLcp::ImpactLaw::none});
  EXPECT_TRUE(std::holds_alternative<Undetermined>(method.law(problem)));
  EXPECT_FALSE(law_matches(method.law(problem), problem.law()));
}

TEST(HatLcp, RepresentsTheLawOfTheScene) {
  Problem problem = test::to_problem(oscillator(0.8));
  EXPECT_TRUE(law_matches(HatLcp({}).law(problem), problem.law()));
  EXPECT_FALSE(law_matches(HatLcp({.scheme = HatLcp::Scheme::backward}).law(problem), problem.law()));
  problem.set_law(Penalty{{50.0}});
  EXPECT_TRUE(law_matches(HatLcp({}).law(problem), problem.law()));
}

TEST(HatLcp, ASpringStopIsASecondOrderProblem) {
  // Compliance in the complementarity condition: compare with the penalty solution on a fine grid.
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  problem.set_law(Penalty{{100.0}});
  const Solution fine = solve<HatLcp>(problem, {.samples = 8192});
  for (const auto scheme : {HatLcp::Scheme::galerkin, HatLcp::Scheme::consistent}) {
    std::vector<double> steps;
    std::vector<double> errors;
    for (const int samples : {128, 256, 512, 1024}) {
      const Solution solution = solve<HatLcp>(problem, {.samples = samples, .scheme = scheme});
      steps.push_back(1.0 / samples);
      errors.push_back(test::relative_distance(*solution.trajectory, *fine.trajectory, samples));
    }
    EXPECT_NEAR(observed_order(steps, errors), 2.0, 0.4);
  }
}

TEST(HatLcp, HasNoImpactLawWhereHatFunctionsInterpolateTheForce) {
  const HatLcp method({.scheme = HatLcp::Scheme::consistent});
  EXPECT_TRUE(std::holds_alternative<Undetermined>(method.law(test::to_problem(oscillator(0.8)))));
  EXPECT_THROW(HatLcp({.scheme = HatLcp::Scheme::consistent, .restitution = HatLcp::ImpactLaw::scene}),
               InvalidOption);
}

TEST(HatLcp, ChatterEndsThroughMarchingWherePivotsWander) {
  // A scene of the seeded population on which the path of pivots takes 7,000 steps.
  const Problem problem =
      test::to_problem({.damping = 0.1922, .frequency = 0.543, .gap = -0.288, .restitution = 0.5});
  const Solution one_path = solve<HatLcp>(
      problem, {.samples = 256, .solver = ComplementaritySolver::pivoting, .max_iterations = 2000});
  EXPECT_EQ(one_path.verdict, Verdict::not_converged);
  const Solution solution = solve<HatLcp>(problem, {.samples = 256});
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_LE(solution.work.pivots.value(), 4 * 256);
  // The answer is a solution of the stated conditions, checked on the nodes.
  const Samples samples = solution.trajectory->sample(256);
  const double force = -samples.force.minCoeff();
  for (int i = 0; i < 256; ++i) {
    const double room = -0.288 - (samples.x((i + 1) % 256, 0) + 0.5 * samples.x((i + 255) % 256, 0)) / 1.5;
    EXPECT_GE(room, -1e-9);
    EXPECT_LE(samples.force(i, 0), 0.0);
    EXPECT_NEAR(room * samples.force(i, 0) / force, 0.0, 1e-9);
  }
}

TEST(HatLcp, TwoContactsOnOneMassBothPress) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = 0.2, .restitution = 1.0});
  problem.contacts.push_back({{{0, -1.0}}, 0.2, problem.contacts.front().law});
  const Solution solution = solve<HatLcp>(problem, {.samples = 256});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Samples samples = solution.trajectory->sample(256);
  EXPECT_LT(samples.force.col(0).minCoeff(), 0.0);
  EXPECT_LT(samples.force.col(1).minCoeff(), 0.0);
  EXPECT_LE(samples.x.col(0).maxCoeff(), 0.2 + 0.05);
  EXPECT_NEAR((samples.x.col(0) + samples.x.col(1)).norm(), 0.0, 1e-12);
}

TEST(HatLcp, StartsFromAGuess) {
  const Problem problem = test::to_problem(oscillator(0.8));
  const Solution cold = solve<HatLcp>(problem, {.samples = 256});
  const Solution warm = solve<HatLcp>(problem, {.samples = 256}, cold.trajectory);
  EXPECT_EQ(warm.verdict, Verdict::converged);
  EXPECT_EQ(warm.work.pivots, 0);
  EXPECT_LE(test::relative_distance(*cold.trajectory, *warm.trajectory), 1e-10);
}

TEST(HatLcp, RefusesOptionsOutOfRange) {
  EXPECT_THROW(HatLcp({.samples = 3}), InvalidOption);
  EXPECT_THROW(HatLcp({.samples = 64, .tolerance = 0.0}), InvalidOption);
  EXPECT_THROW(HatLcp({.samples = 64, .max_iterations = -1}), InvalidOption);
}

TEST(HatLcp, SaysWhyItCannotResolveTheLoad) {
  Problem problem = test::to_problem(oscillator(1.0));
  problem.force.push_back({0, 40, 1.0, 0.0});
  const Support support = HatLcp({.samples = 64}).supports(problem);
  EXPECT_FALSE(support.ok);
  EXPECT_NE(support.reason.find("harmonic 40"), std::string::npos);
}

// So lightly damped that 256 nodes have no periodic motion: the path of pivots ends on a ray.
TEST(HatLcp, RefinesItsGridWhereThePathOfPivotsFails) {
  const Problem problem =
      test::to_problem({.damping = 0.00158618, .frequency = 1.44982, .gap = 0.0972731, .restitution = 1.0});
  EXPECT_EQ(solve<HatLcp>(problem, {.samples = 256}).verdict, Verdict::not_converged);
  const Solution refined = solve<HatLcp>(problem, {});
  ASSERT_EQ(refined.verdict, Verdict::converged) << refined.message;
  // 1024 nodes have one, and 4096 agree.
  const Solution fine = solve<HatLcp>(problem, {.samples = 4096});
  ASSERT_EQ(fine.verdict, Verdict::converged) << fine.message;
  EXPECT_LE(test::relative_distance(*refined.trajectory, *fine.trajectory), 1e-9);
  EXPECT_GT(refined.work.pivots.value(), fine.work.pivots.value());  // those of the other grids count
}

// On 256 nodes the path ends at a motion that 1024 nodes do not have.
TEST(HatLcp, DoesNotClaimAMotionThatAFinerGridDoesNotShow) {
  const Problem problem = test::to_problem(test::hard_population(245).back());
  const Solution coarse = solve<HatLcp>(problem, {.samples = 256});
  ASSERT_EQ(coarse.verdict, Verdict::converged) << coarse.message;
  const Solution refined = solve<HatLcp>(problem, {});
  ASSERT_EQ(refined.verdict, Verdict::converged) << refined.message;
  EXPECT_GT(test::relative_distance(*refined.trajectory, *coarse.trajectory), 0.3);
  const Solution exact = solve<ExactOrbitMethod>(problem, {}, refined.trajectory);
  ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
  EXPECT_LE(test::relative_distance(*refined.trajectory, *exact.trajectory), 0.05);
}

TEST(HatLcp, SolvesByDefaultWhatHasNoContactOrNoMotion) {
  Problem free = test::to_problem({.damping = 0.1, .frequency = 2.0, .gap = 1.0, .restitution = 1.0});
  free.contacts.clear();
  EXPECT_EQ(solve<HatLcp>(free, {}).verdict, Verdict::converged);
  // Pressed against a stop at the place of rest: x = 0 but for rounding, whatever the grid.
  Problem pressed = test::to_problem({.damping = 0.1, .frequency = 2.0, .gap = 0.0, .restitution = 0.5});
  pressed.force.push_back({.dof = 0, .harmonic = 0, .cos = 10.0, .sin = 0.0});
  const Solution rest = solve<HatLcp>(pressed, {});
  EXPECT_EQ(rest.verdict, Verdict::converged) << rest.message;
}

TEST(HatLcp, LeavesItsGridAloneWhereItIsAskedForOrPlain) {
  const Problem problem =
      test::to_problem({.damping = 0.00158618, .frequency = 1.44982, .gap = 0.0972731, .restitution = 1.0});
  EXPECT_EQ(solve<HatLcp>(problem, {.max_iterations = 100000}).verdict, Verdict::not_converged);
  const Solution plain = solve<HatLcp>(problem, {.plain = true});
  EXPECT_EQ(plain.message.find("N = "), std::string::npos) << plain.message;
}

TEST(HatLcp, TakesTheNodesThatItsLoadNeedsWithinReason) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.0, .gap = 10.0, .restitution = 1.0});
  problem.force.push_back({.dof = 0, .harmonic = 1000, .cos = 0.1, .sin = 0.0});
  EXPECT_TRUE(HatLcp({}).supports(problem).ok);
  EXPECT_FALSE(HatLcp({.samples = 256}).supports(problem).ok);
  problem.force.back().harmonic = 10000;
  EXPECT_EQ(
      HatLcp({}).supports(problem).reason,
      "the load reaches harmonic 10000 of the motion's base frequency: samples = 4096 cannot resolve it");
}

// No spring holds the mass: its mean is an unknown, the balance of the mean load a row.
TEST(HatLcp, SolvesAGearInItsBacklashAsAnIndependentFlowDoes) {
  const Solution solution = solve<HatLcp>(test::gear_backlash(), {.samples = 512});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Eigen::VectorXd x = solution.trajectory->sample(512).x.col(0);
  EXPECT_NEAR(x.minCoeff(), 0.83924924, 2e-5);
  EXPECT_NEAR(x.maxCoeff(), 1.29758104, 2e-5);
}

TEST(HatLcp, BalancesTheWeightOfABallByItsImpulses) {
  const Solution solution = solve<HatLcp>(test::bouncing_ball(), {.samples = 256});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const double mean = solution.trajectory->sample(256).force.col(0).mean();
  EXPECT_NEAR(mean * solution.trajectory->period(), -test::kBallImpulse, 1e-8);
}

TEST(HatLcp, SaysThatAMotionWithoutContactIsOneOfAFamily) {
  Problem floating = test::loose_mass(1.0, 0.1);
  floating.force = {{.dof = 0, .cos = 1e-3}};
  floating.contacts = {{.normal = {{0, 1.0}}, .gap = 1.0}};
  floating.set_law(Restitution{0.5});
  const Solution solution = solve<HatLcp>(floating, {.samples = 64});
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_NE(solution.message.find("one of a family"), std::string::npos) << solution.message;
}

}  // namespace
}  // namespace signorini::hat_lcp_test
