#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "methods/discretisation/trajectories.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::fourier_lipschitz_test {
namespace {

using test::relative_error;
using test::solve;

// The oscillator "S-A" with restitution 1: one impact per period, stable.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

const FourierTrajectory::Data& data_of(const Solution& solution) {
  return dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data();
}

/// Root mean square of the orbit, to turn relative errors into the absolute ones of published tables.
double root_mean_square(const test::SingleImpactOrbit& orbit) {
  double sum = 0.0;
  for (int i = 0; i < 1000; ++i) sum += std::pow(orbit.x(orbit.period * i / 1000), 2) / 1000;
  return std::sqrt(sum);
}

TEST(FourierLipschitz, ErrorAgainstTheClosedFormOrbitIsBoundedAtEachOrder) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  const struct {
    int harmonics;
    double bound;  // of the root mean square error at c = 1 N/m
  } levels[] = {{20, 9.2e-2}, {40, 5.6e-2}, {80, 3.2e-2}};
  for (const auto& [harmonics, bound] : levels) {
    const Solution solution =
        solve<FourierLipschitz>(test::to_problem(kStop), {.common = {.harmonics = harmonics}, .c = 1.0});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const double error = relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); });
    EXPECT_LE(error * root_mean_square(orbit), bound) << "H = " << harmonics;
  }
}

TEST(FourierLipschitz, ConvergesAtFirstOrderWithImpacts) {
  const auto orbit = test::single_impact_orbits(kStop).front();
  std::vector<double> steps;
  std::vector<double> errors;
  for (const int harmonics : {10, 20, 40, 80, 160}) {
    const Solution solution = solve<FourierLipschitz>(test::to_problem(kStop), {{.harmonics = harmonics}});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    steps.push_back(1.0 / harmonics);
    errors.push_back(relative_error(*solution.trajectory, [&](double t) { return orbit.x(t); }));
  }
  const double order = test::observed_order(steps, errors);
  EXPECT_GE(order, 0.8);
  EXPECT_LE(order, 1.2);
}

TEST(FourierLipschitz, IsExactWithOneHarmonicWhereNothingTouches) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 3.0});
  const std::complex<double> amplitude = 1.0 / std::complex<double>(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  const Solution solution = solve<FourierLipschitz>(problem, {{.harmonics = 1}});
  EXPECT_LE(relative_error(*solution.trajectory,
                           [&](double t) { return (amplitude * std::polar(1.0, 2.2 * t)).real(); }),
            1e-14);
  EXPECT_EQ(solution.work.pivots.value_or(0), 0);
  EXPECT_EQ(solution.work.iterations.value_or(0), 0);
}

// At restitution 1 bouncing orbits coexist with permanent contact, and a cold start may meet them first:
// started from the static guess, the method must confirm permanent contact to rounding.
TEST(FourierLipschitz, HoldsPermanentContactExactlyWithOneHarmonic) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = -1.5});
  const auto guess = std::make_shared<test::GivenMotion>(
      problem.period(), [](double) { return -1.5; }, [](double) { return -1.5; });
  const Solution solution = solve<FourierLipschitz>(problem, {{.harmonics = 1}}, guess);
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Samples samples = solution.trajectory->sample(32);
  for (int i = 0; i < 32; ++i) {
    EXPECT_NEAR(samples.x(i, 0), -1.5, 1e-12);
    EXPECT_NEAR(samples.force(i, 0), -1.5 - std::cos(2.0 * std::numbers::pi * i / 32), 1e-10);
  }
}

class RoundOffIdentity : public testing::TestWithParam<std::tuple<int, int, double>> {};

// mean(lambda (x - g)) = -mean(s^2) / c on the grid, s = lambda + max(0, c (x - g) - lambda): exact for
// every N, c and H at a converged solution.
TEST_P(RoundOffIdentity, HoldsAtAConvergedSolution) {
  const auto [harmonics, samples, c] = GetParam();
  const Solution solution = solve<FourierLipschitz>(
      test::to_problem(kStop),
      {.common = {.harmonics = harmonics, .samples = samples, .quadrature = Quadrature::sampled}, .c = c});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const auto& data = data_of(solution);
  double left = 0.0;
  double right = 0.0;
  double scale = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double phase = 2.0 * std::numbers::pi * i / samples;
    double x = data.x(0, 0).real();
    double lambda = data.lambda(0, 0).real();
    for (int n = 1; n <= harmonics; ++n) {
      x += 2.0 * (data.x(n, 0) * std::polar(1.0, n * phase)).real();
      lambda += 2.0 * (data.lambda(n, 0) * std::polar(1.0, n * phase)).real();
    }
    const double s = std::max(lambda, c * (x - 0.2));
    left += lambda * (x - 0.2) / samples;
    right -= s * s / c / samples;
    scale += std::abs(lambda * (x - 0.2)) / samples;
  }
  EXPECT_NEAR(left, right, 1e-12 * scale);
}

INSTANTIATE_TEST_SUITE_P(AnyGridAndConstant, RoundOffIdentity,
                         testing::Values(std::tuple{5, 160, 1.0}, std::tuple{10, 320, 10.0},
                                         std::tuple{20, 640, 100.0}, std::tuple{7, 225, 1000.0}));

TEST(FourierLipschitz, ContactDoesNoNetWork) {
  const Problem problem = test::to_problem(kStop);
  const struct {
    Quadrature quadrature;
    double bound;  // of the contact's work relative to the load's, at N = 64 H
  } ways[] = {{Quadrature::exact, 1e-7}, {Quadrature::sampled, 3e-3}};
  for (const auto& [quadrature, bound] : ways) {
    for (const int harmonics : {5, 10, 20, 40}) {
      const Solution solution = solve<FourierLipschitz>(
          problem, {{.harmonics = harmonics, .samples = 64 * harmonics, .quadrature = quadrature}});
      ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
      const auto& data = data_of(solution);
      double contact = 0.0;
      for (int n = 1; n <= harmonics; ++n) {
        contact -= 4.0 * std::numbers::pi * n * (std::conj(data.lambda(n, 0)) * data.x(n, 0)).imag();
      }
      const double load = -4.0 * std::numbers::pi * (0.5 * data.x(1, 0)).imag();
      EXPECT_LE(std::abs(contact), bound * std::abs(load)) << "H = " << harmonics;
    }
  }
}

TEST(FourierLipschitz, WithTheExactContactIntegralTheGridNoLongerMatters) {
  const Problem problem = test::to_problem(kStop);
  const Solution coarse = solve<FourierLipschitz>(problem, {{.harmonics = 20, .samples = 640}});
  const Solution fine = solve<FourierLipschitz>(problem, {{.harmonics = 20, .samples = 5120}});
  EXPECT_LE(test::relative_distance(*coarse.trajectory, *fine.trajectory), 1e-8);
  const Solution sampled = solve<FourierLipschitz>(
      problem, {{.harmonics = 20, .samples = 20480, .quadrature = Quadrature::sampled}});
  EXPECT_LE(test::relative_distance(*sampled.trajectory, *fine.trajectory), 5e-4);
}

TEST(FourierLipschitz, OnASpringStopWithTheSpringsOwnConstantIsThePenaltySolution) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{50.0}});
  const Solution spring =
      solve<FourierLipschitz>(problem, {.common = {.harmonics = 15, .samples = 480}, .c = 50.0});
  const Solution other =
      solve<FourierLipschitz>(problem, {.common = {.harmonics = 15, .samples = 480}, .c = 7.0});
  ASSERT_EQ(spring.verdict, Verdict::converged);
  ASSERT_EQ(other.verdict, Verdict::converged);
  // The projected force is the spring's own at c = k_p.
  const Samples samples = spring.trajectory->sample(480);
  for (int i = 0; i < 480; ++i) {
    EXPECT_NEAR(samples.force(i, 0), -50.0 * std::max(0.0, samples.x(i, 0) - 0.2), 1e-10);
  }
  // Another constant solves the same law another way: equal in the limit, near here.
  EXPECT_LE(test::relative_distance(*spring.trajectory, *other.trajectory), 2e-2);
}

// A spring that the highest harmonics kept do not feel: the error is that of the spring's own law, x of order
// H^-3.5, whatever the form.
TEST(FourierLipschitz, OnASoftSpringStopConvergesAsThePenaltyForm) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{50.0}});
  const Solution exact = solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(exact.verdict, Verdict::converged);
  std::vector<double> steps, errors;
  for (const int harmonics : {40, 80, 160}) {
    const Solution ours = solve<FourierLipschitz>(problem, {.common = {.harmonics = harmonics}});
    const Solution penalty = solve<PenaltyHbm>(problem, {.common = {.harmonics = harmonics}});
    ASSERT_EQ(ours.verdict, Verdict::converged);
    steps.push_back(1.0 / harmonics);
    errors.push_back(test::relative_distance(*ours.trajectory, *exact.trajectory));
    EXPECT_LE(errors.back(), 1.2 * test::relative_distance(*penalty.trajectory, *exact.trajectory));
  }
  EXPECT_GE(test::observed_order(steps, errors), 3.0);
}

TEST(FourierLipschitz, NewtonReachesTheSameSolutionFromTheAnswer) {
  const Problem problem = test::to_problem(kStop);
  const FourierLipschitz::Options options{
      {.harmonics = 20, .samples = 640, .quadrature = Quadrature::sampled}};
  const Solution pivoted = solve<FourierLipschitz>(problem, options);
  auto newton = options;
  newton.solver = ComplementaritySolver::newton;
  const Solution solution = solve<FourierLipschitz>(problem, newton, pivoted.trajectory);
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_LE(solution.work.iterations.value(), 2);
  EXPECT_LE(test::relative_distance(*pivoted.trajectory, *solution.trajectory), 1e-10);
}

TEST(FourierLipschitz, RepresentsRestitutionOneWhateverTheSceneAsksAndSaysSo) {
  Problem problem = test::to_problem({.frequency = 2.2, .gap = 0.2, .restitution = 0.5});
  for (const HarmonicOptions& common : {HarmonicOptions{}, HarmonicOptions{.plain = true}}) {
    const FourierLipschitz method({.common = common});
    EXPECT_EQ(std::get<Restitution>(method.law(problem)).e, 1.0);
    EXPECT_FALSE(law_matches(method.law(problem), problem.law()));
  }
  problem.set_law(Penalty{{3.0}});
  EXPECT_TRUE(law_matches(FourierLipschitz({}).law(problem), problem.law()));
}

// The same equations whatever restitution is asked.
TEST(FourierLipschitz, AnswersAlikeWhateverRestitutionTheSceneAsks) {
  Problem problem = test::to_problem(kStop);
  const Solution elastic = solve<FourierLipschitz>(problem, {});
  problem.set_law(Restitution{0.3});
  const Solution lossy = solve<FourierLipschitz>(problem, {});
  ASSERT_EQ(elastic.verdict, Verdict::converged) << elastic.message;
  EXPECT_EQ(elastic.trajectory->sample(64).x, lossy.trajectory->sample(64).x);
}

// A node without mass on a spring before a rigid stop is a spring stop on the mass behind it.
TEST(FourierLipschitz, SolvesAContactWithoutMassAsTheSpringStopThatItIs) {
  const Problem on_mass = parse_scene(R"(
schema = 1
name = "sprung"
system = { kind = "chain", masses = [1.0, 1.0], dampers = [0.1, 0.1], springs = [1.0, 1.0] }
forcing = { frequency = 1.0, term = [{ dof = 1, cos = 1.0 }] }
contact = [{ dof = 1, gap = 0.5 }]
law = { penalty = 50.0 }
)",
                                      "sprung");
  const Problem on_node = load_scene(find_scene("chain3-massless"));
  const Solution sprung = solve<FourierLipschitz>(on_mass, {{.harmonics = 20}});
  const Solution massless = solve<FourierLipschitz>(on_node, {{.harmonics = 20}});
  ASSERT_EQ(massless.verdict, Verdict::converged) << massless.message;
  ASSERT_EQ(sprung.verdict, Verdict::converged) << sprung.message;
  const Eigen::MatrixXcd force = data_of(sprung).lambda;
  EXPECT_LT((data_of(massless).lambda - force).norm(), 1e-8 * force.norm());
}

// The tube of code_aster V5.02.301 between eight springs with dampers.
TEST(FourierLipschitz, FindsAMotionOfATubeAmongItsDampedStops) {
  const Problem problem = load_scene(find_scene("sdnl301d"));
  const Solution series = solve<FourierLipschitz>(problem, {});
  ASSERT_EQ(series.verdict, Verdict::converged) << series.message;
  const Solution orbit = solve<ExactOrbitMethod>(problem, {}, series.trajectory);
  ASSERT_EQ(orbit.verdict, Verdict::converged) << orbit.message;
  EXPECT_NE(orbit.message.find("from the guess"), std::string::npos) << orbit.message;
  EXPECT_LT(test::relative_distance(*series.trajectory, *orbit.trajectory), 0.02);
}

TEST(FourierLipschitz, RefusesOptionsOutOfRange) {
  EXPECT_THROW(FourierLipschitz({{.harmonics = 0}}), InvalidOption);
  EXPECT_THROW(FourierLipschitz({{.harmonics = 10, .samples = 20}}), InvalidOption);
  EXPECT_THROW(FourierLipschitz({.c = 0.0}), InvalidOption);
  EXPECT_THROW(FourierLipschitz({.c = -1.0}), InvalidOption);
  EXPECT_THROW(FourierLipschitz({{.tolerance = 1.0}}), InvalidOption);
}

TEST(FourierLipschitz, SaysWhichHarmonicOfTheLoadIsBeyondIt) {
  Problem problem = test::to_problem(kStop);
  problem.force.push_back({0, 4, 1.0, 0.0});
  EXPECT_FALSE(FourierLipschitz({{.harmonics = 3}}).supports(problem).ok);
  EXPECT_TRUE(FourierLipschitz({{.harmonics = 4}}).supports(problem).ok);
}

// The load asks for more harmonics than the samples carry.
TEST(FourierLipschitz, RefusesSamplesThatDoNotCarryTheHarmonicsItChooses) {
  Problem problem = test::to_problem(kStop);
  problem.force.push_back({.dof = 0, .harmonic = 50, .cos = 0.1, .sin = 0.0});
  EXPECT_TRUE(FourierLipschitz({}).supports(problem).ok);
  EXPECT_EQ(FourierLipschitz({{.samples = 64}}).supports(problem).reason,
            "the load reaches harmonic 50 of the motion's base frequency: samples = 64 are too few");
}

TEST(FourierLipschitz, SolvesAGearInItsBacklashAsAnIndependentFlowDoes) {
  const Solution solution = solve<FourierLipschitz>(test::gear_backlash(), {{.harmonics = 20}});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Samples motion = solution.trajectory->sample(4096);
  EXPECT_NEAR(motion.x.col(0).minCoeff(), 0.83924924, 1e-5);
  EXPECT_NEAR(motion.x.col(0).maxCoeff(), 1.29758104, 1e-5);
  const Eigen::MatrixXcd lambda = data_of(solution).lambda;
  EXPECT_NEAR(0.1 + lambda(0, 0).real() - lambda(0, 1).real(), 0.0, 1e-12);
}

}  // namespace
}  // namespace signorini::fourier_lipschitz_test
