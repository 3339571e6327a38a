#include "harness/judge/measures/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "harness/judge/measures/impacts.hpp"
#include "methods/catalogue.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::motion_test {
namespace {

using test::FormulaMotion;

constexpr double kPeriod = std::numbers::pi;  // of one_mass(): omega = 2

/// cos(omega t) and a subharmonic of half the frequency, over `order` forcing periods, `shift` of them late.
Motion motion(int order, double subharmonic, int shift = 0, std::vector<Impulse> impulses = {}) {
  const double late = shift * kPeriod;
  return sample_motion(
      test::one_mass(),
      FormulaMotion(
          order * kPeriod, [=](double t) { return std::cos(2.0 * t) + subharmonic * std::cos(t - late); },
          [=](double t) { return -2.0 * std::sin(2.0 * t) - subharmonic * std::sin(t - late); },
          [](double) { return 0.0; }, std::move(impulses)));
}

TEST(SampleMotion, KnowsTheOrderOfTheMotion) {
  EXPECT_EQ(motion(1, 0.0).order, 1);
  EXPECT_EQ(motion(2, 0.5).order, 2);
  EXPECT_EQ(motion(2, 0.5).count(), 2 * kGrid);
  EXPECT_NEAR(motion(2, 0.5).period(), 2.0 * kPeriod, 1e-12);
}

TEST(Distance, IsTakenOverTheCommonPeriod) {
  // |0.5 cos t| against |cos 2 t|: 0.5; the other way the norm is that of both together.
  EXPECT_NEAR(distance(motion(2, 0.5), motion(1, 0.0)).x_l2.value(), 0.5, 1e-12);
  EXPECT_NEAR(distance(motion(1, 0.0), motion(2, 0.5)).x_l2.value(), 0.5 / std::sqrt(1.25), 1e-12);
  EXPECT_NEAR(distance(motion(3, 0.0), motion(2, 0.5)).x_l2.value(), 0.5 / std::sqrt(1.25), 1e-12);
  EXPECT_EQ(distance(motion(2, 0.5), motion(2, 0.5)).x_l2.value(), 0.0);
}

TEST(Distance, KnowsNoOriginOfDisplacements) {
  Motion a = motion(2, 0.5), b = motion(1, 0.0);
  const Distance before = distance(a, b);
  a.samples.x.array() += 1e3;
  b.samples.x.array() += 1e3;
  const Distance after = distance(a, b);
  EXPECT_NEAR(after.x_l2.value(), before.x_l2.value(), 1e-9);
  EXPECT_NEAR(after.x_max.value(), before.x_max.value(), 1e-9);
  EXPECT_EQ(after.velocity_l2, before.velocity_l2);
}

TEST(Distance, IsInUnitsOfAMotionHoweverSmall) {
  // |0.5 cos t| against |cos 2 t|, of a root mean square of 1 / sqrt(2): smaller than the unit of rest.
  Motion a = motion(2, 0.5);
  a.least = 3.0;
  EXPECT_NEAR(distance(a, motion(1, 0.0)).x_l2.value(), 0.5, 1e-12);
  Motion still = motion(1, 0.0);
  still.least = 3.0;
  still.samples.x.setConstant(2.0);
  EXPECT_NEAR(distance(still, motion(1, 0.0)).x_l2.value(), std::sqrt(1.0 + 2.0 * 4.0), 1e-12);
  still.samples.x.setZero();
  EXPECT_NEAR(distance(still, motion(1, 0.0)).x_l2.value(), 1.0, 1e-12);
}

TEST(Distance, OfAMotionAtRestHasTheLeastSizeAsItsUnit) {
  Motion a = motion(2, 0.5), rest = motion(1, 0.0);
  rest.samples.x.setConstant(7.0);
  rest.samples.velocity.setZero();
  a.samples.x.array() += 7.0;
  a.least = 3.0;
  const double size = std::sqrt(1.25) * std::numbers::sqrt2 / 2.0;  // of a
  EXPECT_NEAR(distance(a, rest).x_l2.value(), size / 3.0, 1e-9);
  EXPECT_NEAR(distance(a, rest).x_worst.value(), size / 3.0, 1e-9);
  EXPECT_NEAR(distance(a, rest).x_max.value(), 1.5 / (3.0 * std::numbers::sqrt2), 1e-9);
  // x' is 2 sin 2 t + 0.5 sin t; the unit of speed is 2 pi / T = 2 times that of x.
  EXPECT_NEAR(distance(a, rest).velocity_l2.value(), std::sqrt(4.25) * std::numbers::sqrt2 / 2.0 / 6.0, 1e-9);
}

TEST(Distance, OfTheWorstContactIsInUnitsOfItsOwnMotion) {
  Motion a = motion(1, 0.0), b = a;
  const Eigen::VectorXd x = b.samples.x.col(0);
  b.samples.x.resize(x.size(), 2);
  b.samples.x << x, 0.1 * x;
  b.samples.velocity = b.samples.force = b.samples.x;
  a = b;
  a.samples.x.col(1).setZero();  // the smaller one stands still
  EXPECT_NEAR(distance(a, b).x_l2.value(), 0.1 / std::sqrt(1.01), 1e-9);
  EXPECT_NEAR(distance(a, b).x_worst.value(), 1.0, 1e-12);
  b.samples.x.col(1) = 1e-5 * x;  // it hardly moves: 1 % of the unit of both, 1 / sqrt(2) of the larger one's
  a.samples.x.col(1) = 101e-5 * x;
  EXPECT_NEAR(distance(a, b).x_worst.value(), 0.1 * std::numbers::sqrt2, 1e-6);
  b.samples.x.col(1).setZero();  // it does not move at all
  EXPECT_NEAR(distance(a, b).x_worst.value(), 1.01e-3 * std::numbers::sqrt2, 1e-6);
}

TEST(LeastSize, IsATenthOfTheContactFreeMotionOrOfItsRoom) {
  const double free = std::numbers::sqrt2 / 2.0 / std::hypot(1.0 - 4.0, 0.2);  // |1 / Z| / sqrt(2)
  EXPECT_NEAR(least_size(test::one_mass(10.0)), 0.1 * free, 1e-9);
  EXPECT_NEAR(least_size(test::one_mass(0.01)), 0.1 * 0.01, 1e-9);
}

TEST(LeastSize, OfALooseMassIsThatOfItsLoad) {
  Problem loose = test::one_mass(0.0, 0.5);
  loose.edit_structure([](Structure& s) {
    s.stiffness.coeffRef(0, 0) = 0.0;
    s.damping.coeffRef(0, 0) = 0.0;
  });
  loose.force.push_back({.dof = 0, .harmonic = 0, .cos = 6.0});  // pressed against its stop
  // x'' = cos 2 t apart from that: 1/4 cos 2 t.
  EXPECT_NEAR(least_size(loose), 0.1 * 0.25 * std::numbers::sqrt2 / 2.0, 1e-9);
  loose.force.erase(loose.force.begin());
  EXPECT_NEAR(least_size(loose), 0.1 * 6.0 / 4.0, 1e-9) << "m omega^2 = 4 is the stiffness of a loose mass";
}

TEST(ResolvedHarmonics, AreNoFewerThanAnAnswerShows) {
  const auto answer = [](int bandwidth) {
    const FormulaMotion told(
        kPeriod, [](double t) { return std::cos(2.0 * t) + 0.01 * std::cos(10.0 * t); },
        [](double t) { return -2.0 * std::sin(2.0 * t) - 0.1 * std::sin(10.0 * t); },
        [](double) { return 0.0; }, {}, bandwidth);
    return check_answer(test::one_mass(), told).motion;
  };
  EXPECT_EQ(resolved_harmonics(answer(1)), 5);
  EXPECT_EQ(resolved_harmonics(answer(7)), 7);
  EXPECT_NEAR(time_resolution(answer(1)), kPeriod / 10.0, 1e-12);
  EXPECT_EQ(resolved_harmonics(motion(1, 0.0)), std::nullopt);
}

TEST(BestShift, UndoesAShiftByForcingPeriods) {
  const Motion original = motion(2, 0.5);
  const Motion late = motion(2, 0.5, 1);
  EXPECT_NEAR(distance(original, late).x_l2.value(), 1.0 / std::sqrt(1.25), 1e-12);
  EXPECT_EQ(best_shift(original, late), 1);
  EXPECT_LT(distance(original, late, 1).x_l2.value(), 1e-12);
}

TEST(LeastOrder, FindsTheTruePeriod) {
  EXPECT_EQ(least_order(motion(1, 0.0)), 1);
  EXPECT_EQ(least_order(motion(6, 0.0)), 1);
  EXPECT_EQ(least_order(motion(6, 0.5)), 2);
  EXPECT_EQ(least_order(motion(2, 0.5)), 2);
}

TEST(SampleAnswer, SaysWhatIsWrongWithIt) {
  const Problem problem = test::one_mass();
  const FormulaMotion::Formula zero = [](double) { return 0.0; };
  const auto defect = [&](const FormulaMotion& answer) { return sample_answer(problem, answer).defect; };
  EXPECT_EQ(defect(FormulaMotion(kPeriod, zero, zero)), "");
  EXPECT_EQ(defect(FormulaMotion(3.0 * kPeriod, zero, zero)), "");
  EXPECT_NE(defect(FormulaMotion(1.5 * kPeriod, zero, zero)).find("no whole multiple"), std::string::npos);
  EXPECT_NE(defect(FormulaMotion(kPeriod, zero, zero, zero, {}, {}, 2)).find("2 contacts"),
            std::string::npos);
  EXPECT_NE(defect(FormulaMotion(
                       kPeriod, [](double) { return std::nan(""); }, zero))
                .find("not finite"),
            std::string::npos);
  EXPECT_NE(defect(FormulaMotion(kPeriod, zero, zero, zero, {{0, 2.0 * kPeriod, -1.0}})).find("outside"),
            std::string::npos);
}

TEST(SampleAnswer, GivesTheMotionOfASoundAnswer) {
  const auto answer = test::free_motion(test::one_mass());
  const SampledAnswer sampled = sample_answer(test::one_mass(), *answer);
  EXPECT_EQ(sampled.motion.samples.x, answer->sample(kGrid).x);
  EXPECT_EQ(sampled.motion.bandwidth, answer->bandwidth());
}

/// Force -(2 + cos 4t) N, the second harmonic of the load, and an impulse of -3 N s at a quarter of the
/// period.
Motion pushing(int order, std::optional<int> bandwidth = {}) {
  const FormulaMotion::Formula zero = [](double) { return 0.0; };
  return sample_motion(test::one_mass(),
                       FormulaMotion(
                           order * kPeriod, zero, zero, [](double t) { return -2.0 - std::cos(4.0 * t); },
                           {{0, 0.25 * order * kPeriod, -3.0}}, bandwidth));
}

TEST(ForceSeries, OfAMotionAreTheCoefficientsOfForceAndImpulses) {
  for (const int order : {1, 3}) {
    const ForceSeries series = force_series(test::one_mass(), pushing(order), 20);
    const double period = order * kPeriod;
    EXPECT_EQ(series.order, order);
    EXPECT_NEAR(series.base_frequency, 2.0 / order, 1e-15);
    ASSERT_EQ(series.lambda.rows(), 21);
    for (int n = 0; n <= 20; ++n) {
      std::complex<double> expected = -3.0 / period * std::polar(1.0, -0.5 * std::numbers::pi * n);
      if (n == 0) expected -= 2.0;
      if (n == 2 * order) expected -= 0.5;
      EXPECT_LT(std::abs(series.lambda(n, 0) - expected), 1e-13) << n << " of order " << order;
    }
  }
}

TEST(ForceSeries, EndsAtTheBandwidthButNotBelowTheLoad) {
  EXPECT_EQ(force_series(test::one_mass(), pushing(1, 7), 20).lambda.rows(), 8);
  EXPECT_EQ(force_series(test::one_mass(), pushing(3, 1), 20).lambda.rows(), 4);
}

TEST(ImpulsePerForcingPeriod, IsTheMeanOverTheOrder) {
  EXPECT_NEAR(impulse_per_forcing_period(pushing(1))[0], -2.0 * kPeriod - 3.0, 1e-12);
  EXPECT_NEAR(impulse_per_forcing_period(pushing(3))[0], -2.0 * kPeriod - 1.0, 1e-12);
}

/// The least stiff levels of the family are resolved by samples, the stiffest closes for a tenth of a step.
TEST(ImpulsePerForcingPeriod, IsThatOfAContactShorterThanTheStep) {
  for (const std::string level : {"1e4", "1e8", "1e10"}) {
    const Problem problem = read_scene(find_scene("stiff-penalty@" + level)).problem;
    for (const std::string method : {"exact-orbit", "event-driven"}) {
      const Solution solution = find_method(method).make({})->prepare(problem)->solve({});
      ASSERT_EQ(solution.verdict, Verdict::converged) << method << ", " << level;
      const Motion orbit = sample_motion(problem, *solution.trajectory);
      // The mean of M x'' + D x' + K x = f + lambda, f without a mean.
      const double mean = problem.stiffness().coeff(0, 0) * orbit.samples.x.col(0).mean();
      const double exact = mean * orbit.forcing_period;
      EXPECT_NEAR(impulse_per_forcing_period(orbit)[0], exact, 1e-5 * std::abs(exact))
          << method << ", " << level;
      const std::vector<ContactPhase> phases = contact_phases(orbit);
      ASSERT_EQ(phases.size(), 1U);
      EXPECT_NEAR(phases[0].impulse, orbit.order * exact, 1e-5 * std::abs(orbit.order * exact));
    }
  }
}

// Nodes that are no instants of the grid push as much as the others.
TEST(ImpulsePerForcingPeriod, IsThatOfAGridWithMoreNodesThanInstants) {
  const Problem problem = test::one_mass();
  const double period = problem.forcing_period();
  for (const int nodes : {kGrid, 2 * kGrid, 3 * kGrid + 7, 8 * kGrid}) {
    Eigen::MatrixXd force = Eigen::MatrixXd::Zero(nodes, 1);
    for (const int node : {1, nodes / 3 + 1, nodes - 1}) force(node) = -nodes / period;  // 1 N s each
    const NodalTrajectory grid(period, Eigen::MatrixXd::Zero(nodes, 1), force);
    EXPECT_NEAR(impulse_per_forcing_period(sample_motion(problem, grid))[0], -3.0, 1e-9) << nodes;
  }
}

TEST(ShortPushes, DecideWhereSamplesAreSilentAndNowhereElse) {
  using Kind = ContactEvent::Kind;
  Motion answer = motion(1, 0.0);  // no sample of a force
  const auto pushes = [&](double steps, std::optional<double> push) {
    answer.events = {{.kind = Kind::close, .contact = 0, .time = 1.0},
                     {.kind = Kind::open, .contact = 0, .time = 1.0 + steps * answer.step(), .push = push}};
    return short_pushes(answer, 0);
  };
  ASSERT_EQ(pushes(4.0, -3.0).size(), 1U);
  EXPECT_EQ(pushes(4.0, -3.0)[0].impulse, -3.0);
  EXPECT_EQ(impulse_per_forcing_period(answer)[0], -3.0);
  EXPECT_TRUE(pushes(4.0, {}).empty());
  EXPECT_TRUE(pushes(20.0, -3.0).empty()) << "twenty samples show that nothing pushes";
  EXPECT_NEAR(impulse_per_forcing_period(answer)[0], 0.0, 1e-15);
  EXPECT_TRUE(pushes(2000.0, 0.0).empty()) << "samples resolve it";
  pushes(4.0, -3.0);
  answer.events->push_back({.kind = Kind::open, .contact = 0, .time = 2.0, .push = -1.0});
  EXPECT_TRUE(short_pushes(answer, 0).empty()) << "an opening without a closing";
}

TEST(Amplitude, IsThatOfTheContactThatMovesMost) {
  Motion two = motion(1, 0.0);
  two.samples.x.conservativeResize(Eigen::NoChange, 2);
  two.samples.x.col(1) = 5.0 + 3.0 * two.samples.x.col(0).array();
  EXPECT_NEAR(amplitude(two), 3.0, 1e-12);
}

}  // namespace
}  // namespace signorini::motion_test
