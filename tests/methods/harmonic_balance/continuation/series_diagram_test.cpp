#include "methods/harmonic_balance/continuation/series_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::series_diagram_test {
namespace {

// m = k = F = 1, c = .1, gap .2: grazing, period doubling of (1,1) and fold of (1,2) in closed form.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};
constexpr double kGrazing = 2.448265181813, kFold = 3.8553753210;
// The same with a spring of 100 for its stop, from the exact orbits of the bilinear oscillator.
constexpr double kSpringDoubling = 2.2062846538, kSpringFold = 3.5167116923;

Problem sprung(double stiffness) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{stiffness}});
  return problem;
}

template <class Method>
Method with_harmonics(int harmonics, bool plain = false) {
  typename Method::Options options;
  options.common.harmonics = harmonics;
  options.common.plain = plain;
  return Method(options);
}

/// The special point of a kind and order nearest to a frequency.
std::optional<double> nearest(const BranchDiagram& diagram, SpecialKind kind, int order, double frequency) {
  std::optional<double> best;
  for (const Branch& branch : diagram.branches) {
    for (const SpecialPoint& special : branch.special) {
      if (special.kind != kind || special.point.order != order) continue;
      if (!best || std::abs(special.point.parameter - frequency) < std::abs(*best - frequency))
        best = special.point.parameter;
    }
  }
  return best;
}

/// Every end has its reason, and consecutive points are neighbours.
void expect_sound(const BranchDiagram& diagram) {
  EXPECT_FALSE(diagram.branches.empty());
  for (const Branch& branch : diagram.branches) {
    EXPECT_FALSE(branch.began.empty());
    EXPECT_FALSE(branch.ended.empty());
    ASSERT_GE(branch.points.size(), 2U);
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const SolutionPoint &a = branch.points[i - 1], &b = branch.points[i];
      EXPECT_LE(std::abs(a.parameter - b.parameter), 0.11);
      EXPECT_LE(std::abs(a.amplitude[0] - b.amplitude[0]), 0.15 * std::max(0.1, a.amplitude[0]));
    }
  }
}

TEST(SeriesDiagram, WithoutContactIsTheClosedFormResponse) {
  const Problem problem = test::to_problem({.damping = 0.2, .gap = 9.0});
  const BranchDiagram diagram =
      with_harmonics<FourierLipschitz>(5).follow(over_frequency(problem, 0.5, 2.0), {});
  expect_sound(diagram);
  ASSERT_EQ(diagram.branches.size(), 1U) << "both ends and the method's answers lie on one branch";
  const Branch& branch = diagram.branches.front();
  EXPECT_EQ(branch.points.front().parameter, 0.5);
  EXPECT_NEAR(branch.points.back().parameter, 2.0, 1e-12);
  EXPECT_EQ(branch.ended, "end of the interval");
  EXPECT_TRUE(branch.special.empty());
  for (const SolutionPoint& point : branch.points) {
    const double w = point.parameter;
    EXPECT_NEAR(point.amplitude[0], 1.0 / std::hypot(1.0 - w * w, 0.2 * w), 1e-12);
    EXPECT_EQ(point.stability, OrbitStability::stable);
  }
}

TEST(SeriesDiagram, PassesGrazingIntoTheImpactingMotions) {
  const BranchDiagram diagram = with_harmonics<FourierLipschitz>(20).follow(
      over_frequency(test::to_problem(kStop), 3.5, 1.6), {.max_order = 1});
  expect_sound(diagram);
  ASSERT_EQ(diagram.branches.size(), 1U);
  const Branch& branch = diagram.branches.front();
  EXPECT_NEAR(branch.points.front().parameter, 3.5, 1e-12);
  EXPECT_NEAR(branch.points.back().parameter, 1.6, 1e-12);
  EXPECT_NEAR(*nearest(diagram, SpecialKind::grazing, 1, kGrazing), kGrazing, 1e-10);
  EXPECT_EQ(branch.points.front().impacts, 0);
  EXPECT_EQ(branch.points.back().impacts, 1);
  EXPECT_EQ(branch.points.front().stability, OrbitStability::stable);
  EXPECT_EQ(branch.points.back().stability, OrbitStability::unknown);
}

TEST(SeriesDiagram, FoldOfTwoPeriodsIsThatOfTheExactOrbitsUpToOneOverH) {
  std::vector<double> errors;
  for (const int harmonics : {5, 10, 20}) {
    const BranchDiagram diagram = with_harmonics<FourierLipschitz>(harmonics).follow(
        over_frequency(test::to_problem(kStop), 2.0, 4.2), {});
    expect_sound(diagram);
    const auto fold = nearest(diagram, SpecialKind::fold, 2, kFold);
    ASSERT_TRUE(fold) << harmonics;
    errors.push_back(std::abs(*fold - kFold));
  }
  EXPECT_LT(errors[2], 0.035);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_GT(errors[i] / errors[i + 1], 1.6);
    EXPECT_LT(errors[i] / errors[i + 1], 2.6);
  }
}

// The fold is found by the tangent, the doubling by a determinant, the multipliers by exponentials along the
// contacts; the truth by exact orbits.
TEST(SeriesDiagram, OfASpringConvergesToItsFoldAndItsDoubling) {
  double error = 1.0, multiplier_error = 1.0;
  for (const int harmonics : {10, 20}) {
    const BranchDiagram diagram =
        with_harmonics<PenaltyHbm>(harmonics).follow(over_frequency(sprung(100.0), 2.0, 4.0), {});
    expect_sound(diagram);
    const auto fold = nearest(diagram, SpecialKind::fold, 2, kSpringFold);
    const auto doubling = nearest(diagram, SpecialKind::period_doubling, 1, kSpringDoubling);
    ASSERT_TRUE(fold && doubling);
    EXPECT_LT(std::abs(*fold - kSpringFold), 0.1 * error);
    EXPECT_LT(std::abs(*doubling - kSpringDoubling), harmonics == 10 ? 2e-3 : 1e-4);
    error = std::abs(*fold - kSpringFold);
    for (const Branch& branch : diagram.branches) {
      for (const SpecialPoint& special : branch.special) {
        if (special.kind != SpecialKind::period_doubling) continue;
        if (std::abs(special.point.parameter - kSpringDoubling) > 0.01) continue;
        ASSERT_EQ(special.point.multipliers.size(), 2);
        const double nearest_to_minus_one = (special.point.multipliers.array() + 1.0).abs().minCoeff();
        EXPECT_LT(nearest_to_minus_one, 0.5 * multiplier_error);
        multiplier_error = nearest_to_minus_one;
      }
    }
  }
  EXPECT_LT(error, 1e-5);
  EXPECT_LT(multiplier_error, 0.1);
}

TEST(SeriesDiagram, LipschitzFormOfTheSpringLeadsToTheSameFold) {
  const BranchDiagram diagram =
      with_harmonics<FourierLipschitz>(20).follow(over_frequency(sprung(100.0), 2.0, 4.0), {});
  EXPECT_NEAR(*nearest(diagram, SpecialKind::fold, 2, kSpringFold), kSpringFold, 1e-3);
}

TEST(SeriesDiagram, AftOfTheSameLawFollowsTheSameCurve) {
  const Problem problem = test::to_problem(kStop);
  const BranchDiagram one =
      with_harmonics<FourierLipschitz>(10).follow(over_frequency(problem, 3.0, 2.0), {.max_order = 1});
  const BranchDiagram other =
      with_harmonics<AftHbm>(10).follow(over_frequency(problem, 3.0, 2.0), {.max_order = 1});
  ASSERT_EQ(one.branches.size(), other.branches.size());
  EXPECT_EQ(one.branches.front().points.size(), other.branches.front().points.size());
}

TEST(SeriesDiagram, PlainFormBreaksAndSaysWhere) {
  const BranchDiagram diagram = with_harmonics<FourierLipschitz>(20, true).follow(
      over_frequency(test::to_problem(kStop), 3.5, 1.6), {.max_order = 1});
  ASSERT_FALSE(diagram.branches.empty());
  const Branch& branch = diagram.branches.front();
  EXPECT_NE(branch.ended.find("the curve breaks at"), std::string::npos) << branch.ended;
  EXPECT_LT(branch.points.back().parameter, kGrazing);
  EXPECT_GT(branch.points.back().parameter, 1.6);
}

// Between two stops the symmetric motion crosses branches of unsymmetric ones, one the mirror image of the
// other: their mean is not 0. The exact orbits' branch points are at 1.004957 and 1.579605.
TEST(SeriesDiagram, FollowsTheBranchesThatCrossAtABranchPoint) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 1.6, .gap = 0.5, .restitution = 1.0});
  problem.contacts.push_back({.normal = {{0, -1.0}}, .gap = 0.5, .law = problem.contacts.front().law});
  CurveLimits limits;
  limits.max_order = 1;
  limits.phases = 64;
  const BranchDiagram diagram =
      with_harmonics<FourierLipschitz>(20).follow(over_frequency(problem, 0.8, 2.0), limits);
  expect_sound(diagram);
  const auto located = nearest(diagram, SpecialKind::branch_point, 1, 1.0);
  ASSERT_TRUE(located.has_value());
  EXPECT_NEAR(*located, 1.004957, 0.05);
  std::vector<double> means;
  for (const Branch& branch : diagram.branches) {
    if (!branch.began.starts_with("branch point")) continue;
    EXPECT_NEAR(branch.points.front().parameter, *located, 1e-9);
    EXPECT_NEAR(branch.points.front().motion.mean(), 0.0, 1e-6);
    means.push_back(branch.points[std::min<std::size_t>(8, branch.points.size() - 1)].motion.col(0).mean());
  }
  ASSERT_EQ(means.size(), 2U);
  EXPECT_GT(std::abs(means[0]), 1e-4);
  EXPECT_NEAR(means[0], -means[1], 1e-3 * std::abs(means[0]));
}

// The contact-free motion of two masses grazes at 1.862898513, leaves the stop at 1.536077381 and meets it
// again at 1.185080523 (exact orbits): each is a corner of the curve, from either side. At the last one the
// exact curve turns back to a fold at 1.185610.
TEST(SeriesDiagram, PassesEveryGrazingOfTwoMasses) {
  const Problem problem = load_scene(find_scene("chain2-stop"));
  for (const int harmonics : {10, 20}) {
    const BranchDiagram diagram = with_harmonics<FourierLipschitz>(harmonics).follow(
        over_frequency(problem, 2.5, 1.0), {.max_order = 1});
    ASSERT_EQ(diagram.branches.size(), 1U) << harmonics << ": one curve from one end to the other";
    const Branch& branch = diagram.branches.front();
    EXPECT_EQ(branch.ended, "end of the interval");
    EXPECT_NEAR(branch.points.back().parameter, 1.0, 1e-12);
    for (const double grazing : {1.862898513, 1.536077381, 1.185080523})
      EXPECT_NEAR(*nearest(diagram, SpecialKind::grazing, 1, grazing), grazing, 1e-8);
  }
}

// The tip of a rod meets a spring: the contact begins on a corner, and is there already by rounding where it
// is located. Steps after a corner are short and must not be taken for a curve that meets itself.
TEST(SeriesDiagram, IsOneCurveWhereContactBeginsOnASpring) {
  for (const char* level : {"0.4", "4", "20"}) {
    const Problem problem = load_scene(find_scene(std::string("rod-penalty@") + level));
    for (const int harmonics : {10, 20}) {
      const BranchDiagram diagram = with_harmonics<FourierLipschitz>(harmonics).follow(
          over_frequency(problem, 57000.0, 75000.0), {.max_order = 1});
      ASSERT_EQ(diagram.branches.size(), 1U) << level << ", H = " << harmonics;
      const Branch& branch = diagram.branches.front();
      EXPECT_EQ(branch.ended, "end of the interval");
      EXPECT_DOUBLE_EQ(branch.points.back().parameter, 75000.0);
      const auto folds = std::count_if(branch.special.begin(), branch.special.end(),
                                       [](const auto& special) { return special.kind == SpecialKind::fold; });
      EXPECT_EQ(folds, 2) << level << ", H = " << harmonics;
    }
  }
}

// Where the motions of one impact a period begin, those of one impact in two periods branch off on the
// corner.

TEST(SeriesDiagram, MotionsOfTwoPeriodsBranchOffWhereContactBegins) {
  const BranchDiagram diagram =
      with_harmonics<FourierLipschitz>(20).follow(over_frequency(test::to_problem(kStop), 2.4, 4.2), {});
  const auto doubling = nearest(diagram, SpecialKind::period_doubling, 1, kGrazing);
  ASSERT_TRUE(doubling);
  EXPECT_NEAR(*doubling, kGrazing, 1e-4);
  EXPECT_LT(*doubling, kGrazing);
}

TEST(SeriesDiagram, LimitsAreSaid) {
  const Problem problem = test::to_problem(kStop);
  const auto method = with_harmonics<FourierLipschitz>(10);
  const BranchDiagram few = method.follow(over_frequency(problem, 3.5, 2.0), {.max_points = 5});
  EXPECT_EQ(few.branches.front().ended, "limit of 5 points");
  EXPECT_EQ(few.branches.front().points.size(), 5U);
  const BranchDiagram one = method.follow(over_frequency(problem, 3.5, 2.0), {.max_branches = 1});
  EXPECT_EQ(one.branches.size(), 1U);
  EXPECT_EQ(one.unfinished, "limit of 1 branches");
  const BranchDiagram late =
      method.follow(over_frequency(problem, 3.5, 2.0),
                    {.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)});
  EXPECT_EQ(late.unfinished, "the time is up");
}

TEST(SeriesDiagram, MotionsOfTheScenesOwnOrderAreFollowed) {
  const Problem problem = with_subharmonic(test::to_problem(kStop), 2);
  const BranchDiagram diagram =
      with_harmonics<FourierLipschitz>(20).follow(over_frequency(problem, 4.2, 2.6), {.max_order = 2});
  ASSERT_FALSE(diagram.branches.empty());
  for (const Branch& branch : diagram.branches) EXPECT_EQ(branch.points.front().order, 2);
}

TEST(SeriesDiagram, RefusesASceneWithoutContactAndTooManyUnknowns) {
  Problem free = test::to_problem(kStop);
  free.contacts.clear();
  free.set_law(std::monostate{});
  EXPECT_EQ(with_harmonics<FourierLipschitz>(5).follow(over_frequency(free, 1.0, 2.0), {}).unfinished,
            "the scene has no contact");
  const BranchDiagram large =
      with_harmonics<FourierLipschitz>(2000).follow(over_frequency(test::to_problem(kStop), 1.0, 2.0), {});
  EXPECT_NE(large.unfinished.find("4001 unknowns"), std::string::npos) << large.unfinished;
}

}  // namespace
}  // namespace signorini::series_diagram_test
