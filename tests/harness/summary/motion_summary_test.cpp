// Figures of motions against closed forms: a sampled sine, the one-mass impact oscillator.

#include "harness/summary/motion_summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "methods/discretisation/trajectories.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::motion_summary_test {
namespace {

using test::FormulaMotion;

constexpr double kTurn = 2.0 * std::numbers::pi;

SampledDisplacement sampled_cosine(int count) {
  SampledDisplacement sampled{.period = 1.0, .x = Eigen::VectorXd(count), .velocity = Eigen::VectorXd(count)};
  for (int i = 0; i < count; ++i) {
    const double angle = kTurn * (static_cast<double>(i) / count + 0.1234);
    sampled.x[i] = 0.5 + 3.0 * std::cos(angle);
    sampled.velocity[i] = -3.0 * kTurn * std::sin(angle);
  }
  return sampled;
}

TEST(Extremes, LieBetweenTheSamplesToTheFourthOrder) {
  for (const int count : {16, 32, 64, 128}) {
    const Extremes range = extremes(sampled_cosine(count), {});
    const double step = 1.0 / count;
    EXPECT_NEAR(range.max, 3.5, 3.0 * std::pow(kTurn * step, 4) / 384.0 * 1.1) << count;
    EXPECT_NEAR(range.min, -2.5, 3.0 * std::pow(kTurn * step, 4) / 384.0 * 1.1) << count;
  }
  EXPECT_LT(sampled_cosine(64).x.maxCoeff(), 3.4999) << "no sample is at the crest";
}

/// An orbit of the oscillator with one impact per period, and the scene it is of.
struct Impacting {
  test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.05, .restitution = 0.8};
  test::SingleImpactOrbit orbit = test::single_impact_orbits(oscillator).front();
  Problem problem = test::to_problem(oscillator);
  FormulaMotion answer{orbit.period,
                       [this](double t) { return orbit.x(t); },
                       [this](double t) { return orbit.velocity(t); },
                       [](double) { return 0.0; },
                       {{.contact = 0, .time = orbit.impact_time, .value = -orbit.impulse}}};
  Motion motion = sample_motion(problem, answer);
};

TEST(SummariseMotion, OfAnImpactingMassHasItsLargestDisplacementAtTheStop) {
  const Impacting scene;
  ASSERT_LT(scene.motion.samples.x.maxCoeff(), scene.oscillator.gap - 1e-7) << "no sample meets the impact";
  const MotionSummary summary =
      summarise_motion(scene.problem, Restitution{0.8}, scene.answer, scene.motion, {});
  ASSERT_EQ(summary.x.size(), 1U);
  EXPECT_NEAR(summary.x[0].max, scene.oscillator.gap, 1e-12);
  EXPECT_EQ(summary.x[0].amplitude, 0.5 * (summary.x[0].max - summary.x[0].min));
  EXPECT_TRUE(summary.u.empty());
}

/// min(sin t, 1/2), as a massless contact that is held at its stop moves.
class Held final : public Trajectory {
 public:
  [[nodiscard]] int contact_count() const override { return 1; }
  [[nodiscard]] double period() const override { return kTurn; }
  [[nodiscard]] Samples sample(int count) const override { return motion_.sample(count); }
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override {
    return {{{.kind = ContactEvent::Kind::close, .contact = 0, .time = kTurn / 12.0},
             {.kind = ContactEvent::Kind::open, .contact = 0, .time = 5.0 * kTurn / 12.0}}};
  }

 private:
  FormulaMotion motion_{kTurn, [](double t) { return std::min(std::sin(t), 0.5); },
                        [](double t) { return std::sin(t) < 0.5 ? std::cos(t) : 0.0; },
                        [](double t) { return std::min(0.0, 0.5 - std::sin(t)); }};
};

// The kink where the contact closes is no turning point beyond the stop.
TEST(SummariseMotion, OfAMasslessContactHasItsLargestDisplacementAtTheStop) {
  const Held answer;
  Problem problem = test::to_problem({.frequency = 1.0, .gap = 0.5});
  problem.set_law(Massless{});
  const MotionSummary summary =
      summarise_motion(problem, Massless{}, answer, sample_motion(problem, answer), {});
  EXPECT_NEAR(summary.x[0].max, 0.5, 1e-10);
  EXPECT_NEAR(summary.x[0].min, -1.0, 1e-10);
}

TEST(SummariseMotion, TellsTheImpactAsTheClosedFormHasIt) {
  const Impacting scene;
  const MotionSummary summary =
      summarise_motion(scene.problem, Restitution{0.8}, scene.answer, scene.motion, {});
  ASSERT_EQ(summary.impacts.size(), 1U);
  const ImpactSummary& impact = summary.impacts.front();
  EXPECT_EQ(impact.time, scene.orbit.impact_time);
  EXPECT_EQ(impact.impulse, -scene.orbit.impulse);
  EXPECT_NEAR(impact.speed_before.value(), scene.orbit.approach, 1e-5);
  EXPECT_NEAR(impact.speed_after.value(), -0.8 * scene.orbit.approach, 1e-5);
  EXPECT_TRUE(summary.contact_phases.empty());
}

TEST(SummariseMotion, HasTheHarmonicsOfTheClosedForm) {
  const Impacting scene;
  const MotionSummary summary =
      summarise_motion(scene.problem, Restitution{0.8}, scene.answer, scene.motion, {.harmonics = 7});
  ASSERT_EQ(summary.x[0].harmonics.size(), 7U);
  EXPECT_NEAR(summary.x[0].mean, scene.orbit.fourier(0).real(), 1e-7);
  for (int n = 1; n <= 7; ++n) {
    const Harmonic& harmonic = summary.x[0].harmonics[static_cast<std::size_t>(n - 1)];
    EXPECT_NEAR(harmonic.frequency, n * scene.oscillator.frequency, 1e-12);
    const std::complex<double> found = 0.5 * std::polar(harmonic.amplitude, harmonic.phase);
    EXPECT_LT(std::abs(found - scene.orbit.fourier(n)), 1e-7) << n;
  }
}

TEST(SummariseMotion, OfAForceThatLastsIsAPhaseOfContactWithItsImpulse) {
  // At rest against the stop for a quarter of the period, pushed with 2 N.
  const double period = kTurn / 2.0;
  const auto force = [=](double t) { return t >= 0.25 * period && t < 0.5 * period ? -2.0 : 0.0; };
  const FormulaMotion answer(
      period, [](double) { return 0.1; }, [](double) { return 0.0; }, force);
  const Problem problem = test::one_mass(0.1, 0.0);
  const Motion motion = sample_motion(problem, answer);
  for (const RepresentedLaw& law : {RepresentedLaw(Restitution{0.0}), RepresentedLaw(Massless{})}) {
    const MotionSummary summary = summarise_motion(problem, law, answer, motion, {});
    ASSERT_EQ(summary.contact_phases.size(), 1U);
    EXPECT_NEAR(summary.contact_phases[0].begin, 0.25 * period, motion.step());
    EXPECT_NEAR(summary.contact_phases[0].end, 0.5 * period, motion.step());
    EXPECT_NEAR(summary.contact_phases[0].impulse, -0.5 * period, 2.0 * motion.step());
    EXPECT_TRUE(summary.impacts.empty());
  }
}

TEST(SummariseMotion, OfNodalValuesHasThoseOfTheNodes) {
  // Three nodes that no power of two meets, and a velocity that jumps at each.
  const Eigen::MatrixXd x = Eigen::Vector3d(0.0, 0.3, -0.2), force = Eigen::Vector3d::Zero();
  const NodalTrajectory answer(kTurn / 2.0, x, force);
  const Problem problem = test::one_mass();
  const MotionSummary summary =
      summarise_motion(problem, Restitution{1.0}, answer, sample_motion(problem, answer), {});
  EXPECT_EQ(summary.x[0].max, 0.3);
  EXPECT_EQ(summary.x[0].min, -0.2);
  EXPECT_EQ(summary.x[0].harmonics.size(), 1U) << "two more would be made of nothing";
}

TEST(SummariseMotion, OfACoordinateSaysWhyThereIsNone) {
  Problem problem = test::one_mass();
  problem.edit_structure([](Structure& s) {
    s.damping *= 0.0;
    s.stiffness *= 4.0;  // at the frequency of the load
  });
  const FormulaMotion answer(
      kTurn / 2.0, [](double) { return 0.0; }, [](double) { return 0.0; });
  const MotionSummary summary =
      summarise_motion(problem, Restitution{1.0}, answer, sample_motion(problem, answer), {.dofs = {0}});
  EXPECT_TRUE(summary.u.empty());
  EXPECT_FALSE(summary.no_u.empty());
}

}  // namespace
}  // namespace signorini::motion_summary_test
