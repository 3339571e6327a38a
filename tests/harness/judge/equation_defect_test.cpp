#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "harness/judge/certificate.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::equation_defect_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

EquationDefect defect_of(const Problem& problem, const Trajectory& answer) {
  KeptSpace spaces;
  return equation_defect(problem, sample_answer(problem, answer).motion, spaces);
}

/// F / (k - m omega^2 + i d omega) of kStop: m = k = F = 1.
test::FormulaMotion linear_motion(std::optional<int> bandwidth = {}) {
  const double w = kStop.frequency, re = 1.0 - w * w, im = kStop.damping * w, size = re * re + im * im;
  const auto x = [=](double t) { return (re * std::cos(w * t) + im * std::sin(w * t)) / size; };
  const auto v = [=](double t) { return w * (im * std::cos(w * t) - re * std::sin(w * t)) / size; };
  return {6.283185307179586 / w, x, v, [](double) { return 0.0; }, {}, bandwidth};
}

// 48 nodes a period are some 0.05 from the motion that they stand for.
TEST(EquationDefect, IsSmallOfRightAnswersHoweverCoarse) {
  const Problem problem = test::to_problem(kStop);
  for (const int samples : {48, 128}) {
    const auto coarse = test::solve<HatLcp>(problem, {.samples = samples}).trajectory;
    const EquationDefect defect = defect_of(problem, *coarse);
    EXPECT_LE(defect.motion, 0.1) << samples;
    EXPECT_LE(defect.penetration, 0.01) << samples;
  }
}

// The load and the contact force leave the mean of a part open that no spring holds: it is the answer's own.
TEST(EquationDefect, TakesTheMeanOfALoosePartFromTheAnswer) {
  const Problem gear = test::gear_backlash();
  const auto answer = test::solve<HatLcp>(gear, {.samples = 256}).trajectory;
  EXPECT_LE(defect_of(gear, *answer).motion, 0.01);
  Problem driven = gear;
  driven.force[1].cos *= 3.0;
  const auto other = test::solve<HatLcp>(driven, {.samples = 256}).trajectory;
  EXPECT_GE(defect_of(gear, *other).motion, 0.1) << "the motion under another load";
}

TEST(EquationDefect, IsThatOfTheLoadWhereAnAnswerStandsStill) {
  const Problem problem = test::to_problem(kStop);
  const auto nothing = [](double) { return 0.0; };
  EXPECT_GE(defect_of(problem, test::FormulaMotion(problem.period(), nothing, nothing)).motion, 1.0);
}

// 1 / sqrt((1 - omega^2)^2 + (d omega)^2) = 0.260: the stop at 0.2 is passed by 0.060 / 0.260.
TEST(EquationDefect, IsThePenetrationOfAMotionThatTakesNoNoticeOfTheStop) {
  const Problem problem = test::to_problem(kStop);
  const EquationDefect defect = defect_of(problem, linear_motion());
  EXPECT_LE(defect.motion, 1e-6);
  EXPECT_NEAR(defect.penetration, 0.2285, 0.005);
  EXPECT_EQ(defect_of(problem, linear_motion(10)).penetration, 0.0) << "ten harmonics may pass it by as much";
}

}  // namespace
}  // namespace signorini::equation_defect_test
