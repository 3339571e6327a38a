// What the families of `hard` claim of their scenes, by closed forms; and scenes from elsewhere by their
// numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::hard_families_test {
namespace {

using test::ImpactOscillator;
using test::SingleImpactOrbit;

Problem shipped(const std::string& name) { return load_scene(find_scene(name)); }

std::vector<Problem> levels_of(const std::string& family) {
  std::vector<Problem> scenes;
  const auto file = problems_folder() / "families" / (family + ".toml");
  for (const std::string& level : load_levels(file)) scenes.push_back(load_scene({file, level}));
  return scenes;
}

// The closed form's own parameters, one impact in `order` forcing periods.
ImpactOscillator oscillator_of(const Problem& problem, int order) {
  return {.mass = problem.mass().coeff(0, 0),
          .damping = problem.damping().coeff(0, 0),
          .stiffness = problem.stiffness().coeff(0, 0),
          .load = problem.force.front().cos,
          .frequency = problem.frequency,
          .gap = problem.contacts.front().gap,
          .restitution = std::get<Restitution>(problem.law()).e,
          .order = order};
}

bool any_stable(const std::vector<SingleImpactOrbit>& orbits) {
  return std::ranges::any_of(orbits, [](const SingleImpactOrbit& orbit) { return orbit.stable(); });
}

TEST(HardFamilies, PeriodDoublingIsPastTheStableMotionOfOnePeriod) {
  for (const Problem& problem : levels_of("period-doubling")) {
    SCOPED_TRACE(problem.name);
    EXPECT_EQ(problem.subharmonic, 2);
    ImpactOscillator oscillator = oscillator_of(problem, 1);
    const auto orbits = single_impact_orbits(oscillator);
    ASSERT_FALSE(orbits.empty());
    EXPECT_FALSE(any_stable(orbits));
    EXPECT_LT(orbits.front().trace, -(1.0 + orbits.front().determinant));
    oscillator.frequency = 2.6587;  // short of the doubling
    EXPECT_TRUE(any_stable(single_impact_orbits(oscillator)));
  }
}

TEST(HardFamilies, ChaosHasAnUnstableMotionOfOnePeriod) {
  for (const Problem& problem : levels_of("chaos")) {
    SCOPED_TRACE(problem.name);
    const auto orbits = single_impact_orbits(oscillator_of(problem, 1));
    ASSERT_FALSE(orbits.empty());
    EXPECT_FALSE(any_stable(orbits));
    EXPECT_FALSE(any_stable(single_impact_orbits(oscillator_of(problem, 2))));
  }
}

TEST(HardFamilies, IsolatedBranchEndsAtItsFold) {
  for (const Problem& problem : levels_of("isolated-branch")) {
    SCOPED_TRACE(problem.name);
    EXPECT_EQ(problem.subharmonic, 3);
    ImpactOscillator oscillator = oscillator_of(problem, 3);
    EXPECT_FALSE(single_impact_orbits(oscillator).empty());
    EXPECT_GT(oscillator.gap, 1.0 / (oscillator.frequency * oscillator.frequency - 1.0))
        << "the motion without contact exists too";
    oscillator.frequency = 5.2763;
    EXPECT_TRUE(single_impact_orbits(oscillator).empty()) << "beyond the fold";
  }
}

TEST(HardFamilies, InternalResonanceIsTunedToThreeTimesTheFirstMode) {
  const std::vector<double> detuning{0.1, 0.03, 0.01, 0.001, 0.0};
  const std::vector<Problem> scenes = levels_of("internal-resonance");
  ASSERT_EQ(scenes.size(), detuning.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Eigen::VectorXd squares = generalised_eigen(scenes[i].stiffness(), scenes[i].mass()).values;
    EXPECT_NEAR(std::sqrt(squares[0]), 1.0, 1e-9);
    EXPECT_NEAR(std::sqrt(squares[1]), 3.0 * (1.0 + detuning[i]), 1e-9);
  }
}

TEST(PublishedScenes, CocosImpactOscillatorHasItsImpact) {
  const Solution solution = test::solve<ExactOrbitMethod>(shipped("sdof-coco-impact"), {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const std::vector<Impulse> impulses = solution.trajectory->impulses();
  ASSERT_EQ(impulses.size(), 1U);
  EXPECT_NEAR(impulses[0].time, 0.075952164938, 1e-11);
  EXPECT_NEAR(impulses[0].value, -1.8 * 1.695732937595, 1e-11);
}

// Its grazing at A = 0.1 and its fold at A = 0.0999707536.
TEST(PublishedScenes, CocosImpactOscillatorHasItsFold) {
  ImpactOscillator oscillator = oscillator_of(shipped("sdof-coco-impact"), 1);
  for (const auto& [load, count] :
       {std::pair(0.09997075, 0U), std::pair(0.09997076, 2U), std::pair(0.101, 1U)}) {
    oscillator.load = load;
    EXPECT_EQ(single_impact_orbits(oscillator).size(), count) << load;
  }
}

// Largest residual of x'' + c x' + F(x) - f(t) over a period of the motion found, by differences.
double residual_of(const Problem& problem, double c, const std::function<double(double)>& spring,
                   const std::function<double(double)>& load) {
  const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  if (!solution.trajectory) return 1e300;
  constexpr int kInstants = 20000;
  const Eigen::VectorXd x = solution.trajectory->sample(kInstants).x.col(0);
  const double step = solution.trajectory->period() / kInstants;
  double worst = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const double before = x[(i + kInstants - 1) % kInstants], after = x[(i + 1) % kInstants];
    const double residual = (after - 2.0 * x[i] + before) / (step * step) +
                            c * (after - before) / (2.0 * step) + spring(x[i]) - load(i * step);
    worst = std::max(worst, std::abs(residual));
  }
  return worst;
}

// The published equations, at every instant of the motions found; their forces have kinks, where differences
// err by a slope times a step.
TEST(PublishedScenes, PermasOneSidedSpringObeysItsEquation) {
  const Problem problem = shipped("sdof-permas-039");
  EXPECT_EQ(std::get<Penalty>(problem.law()).stiffness, std::vector<double>{15.0});
  const auto spring = [](double x) { return x + 15.0 * std::max(0.0, x); };
  EXPECT_LT(residual_of(problem, 0.25, spring, [](double t) { return std::cos(2.6 * t); }), 1e-3);
}

// F(x) = x + (1 - alpha)/2 ((x - b) sign(x - b) - (x + b) sign(x + b)), alpha 1/4, b 4; the example has
// tanh(10 x) for the sign.
TEST(PublishedScenes, PermasClearanceObeysItsEquation) {
  const Problem problem = shipped("sdof-permas-046");
  const auto spring = [](double x) { return x + 0.375 * (std::abs(x - 4.0) - std::abs(x + 4.0)); };
  const auto load = [](double t) { return 1.2 + std::sin(1.7 * t); };
  EXPECT_LT(residual_of(problem, 0.04, spring, load), 1e-3);
}

// Its picture has the orbit of the first mass between -0.8 and 0.2 and between -0.6 and 0.6 in velocity, with
// lines every 0.2: the axes are those of the motion.
TEST(PublishedScenes, PermasTwoMassesMoveAsTheirPictureHasThem) {
  const Solution solution = test::solve<ExactOrbitMethod>(shipped("chain-permas-008"), {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  constexpr int kInstants = 20000;
  const Samples samples = solution.trajectory->sample(kInstants);
  EXPECT_GT(samples.x.minCoeff(), -0.8);
  EXPECT_LT(samples.x.minCoeff(), -0.6);
  EXPECT_GT(samples.x.maxCoeff(), 0.0);
  EXPECT_LT(samples.x.maxCoeff(), 0.2);
  EXPECT_GT(samples.velocity.maxCoeff(), 0.4);
  EXPECT_LT(samples.velocity.cwiseAbs().maxCoeff(), 0.6);
  // q1'' + 0.1 q1' + 5 max(q1, 0) + q1 - q2 = 0 gives q2, which then must obey
  // q2'' + 0.1 q2' + 2 q2 - q1 = 0.375 cos(1.44 t), of which the first harmonics:
  const double w = 1.44;
  std::complex<double> q1 = 0.0, push = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const std::complex<double> wave = std::polar(2.0 / kInstants, -2.0 * std::numbers::pi * i / kInstants);
    q1 += samples.x(i, 0) * wave;
    push += 5.0 * std::max(0.0, samples.x(i, 0)) * wave;
  }
  const std::complex<double> drag(-w * w, 0.1 * w);
  const std::complex<double> q2 = (drag + 1.0) * q1 + push;
  EXPECT_LT(std::abs((drag + 2.0) * q2 - q1 - 0.375), 1e-6);
}

// A disc goes round on a bed of springs of k N / (2 pi) per radian in a circle of radius r, where
// ((K - m w^2) r + F(r))^2 + (d w r)^2 = (m e w^2)^2, F(r) = k N / (2 pi) (r (a + sin a cos a) - 2 g sin a),
// cos a = g / r. So many facets are such a bed up to the ripple of their number.
TEST(RotorScenes, AnnularRubIsTheCircleOnABedOfSprings) {
  const Problem problem = shipped("rotor-annular-rub");
  constexpr double kGap = 0.3, kFrequency = 1.2, kDamping = 0.05, kMoment = 0.1;
  const double bed = 5.0 * problem.contact_count() / (2.0 * std::numbers::pi);
  double low = kGap, high = 0.4;
  for (int i = 0; i < 60; ++i) {
    const double r = 0.5 * (low + high), a = std::acos(kGap / r);
    const double push = bed * (r * (a + std::sin(a) * std::cos(a)) - 2.0 * kGap * std::sin(a));
    const double w = kFrequency;
    const double lags = std::hypot((1.0 - w * w) * r + push, kDamping * w * r) - kMoment * w * w;
    (lags < 0.0 ? low : high) = r;
  }
  const Solution solution = test::solve<ExactOrbitMethod>(problem, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  constexpr int kInstants = 4096;
  const Samples samples = solution.trajectory->sample(kInstants);
  for (const int contact : {0, 4, 7}) {  // forward whirl: each facet sees the same, later
    const double angle = 2.0 * std::numbers::pi * contact / problem.contact_count();
    std::complex<double> first = 0.0;
    for (int i = 0; i < kInstants; ++i)
      first +=
          samples.x(i, contact) * std::polar(2.0 / kInstants, angle - 2.0 * std::numbers::pi * i / kInstants);
    EXPECT_NEAR(std::abs(first), low, 2e-5 * low);
    EXPECT_NEAR(std::arg(first), -std::asin(kDamping * low / (kMoment * kFrequency)), 1e-4);
  }
}

}  // namespace
}  // namespace signorini::hard_families_test
