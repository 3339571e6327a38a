#include "methods/hat_functions/continuation/hat_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "methods/hat_functions/continuation/hat_tracer.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::hat_curve_test {
namespace {

// m = k = F = 1, c = .1, gap .2. With a spring of 100 for its stop, exact orbits have the fold of the motions
// with one contact in two periods at 3.5167117.
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};
constexpr double kGrazing = 2.448265181813, kSpringFold = 3.5167116923;

Problem sprung(double stiffness) {
  Problem problem = test::to_problem(kStop);
  problem.set_law(Penalty{{stiffness}});
  return problem;
}

/// Curves of one period of which none was followed before.
class NoCurves final : public FollowedCurves {
  [[nodiscard]] Eigen::VectorXd begun_later(const Eigen::VectorXd& x, int /*periods*/,
                                            int /*shift*/) const override {
    return x;
  }
  [[nodiscard]] double rounding_of(const Eigen::VectorXd& /*x*/) const override { return 1e-9; }
};

HatLcp with_samples(int samples) {
  HatLcp::Options options;
  options.samples = samples;
  return HatLcp(options);
}

TEST(HatCurve, DerivativesAreThoseOfDifferences) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> pressure(0.1, 1.0);
  for (const NodalRestitution& restitution : {NodalRestitution{}, NodalRestitution{0.8}}) {
    HatFamily family{curve_family(test::to_problem(kStop), 1.5, 4.5)};
    family.samples = 16;
    family.restitution = restitution;
    HatCurve curve(family, 2);
    curve.press({3, 4, 20});
    Eigen::VectorXd x(4);
    x << pressure(random), pressure(random), pressure(random), 2.2;
    ASSERT_TRUE(curve.evaluate(x));
    const Eigen::MatrixXd jacobian = curve.jacobian();
    for (Eigen::Index i = 0; i < 4; ++i) {
      constexpr double kStep = 1e-6;
      constexpr int kOpen = 10;
      const Eigen::VectorXd along = Eigen::VectorXd::Unit(4, i);
      ASSERT_TRUE(curve.evaluate(x));
      const double rate = curve.gap_rate(kOpen, along);
      ASSERT_TRUE(curve.evaluate(x + kStep * along));
      const Eigen::VectorXd above = curve.residual();
      const double open_above = curve.gaps()[kOpen];
      ASSERT_TRUE(curve.evaluate(x - kStep * along));
      EXPECT_LT(((above - curve.residual()) / (2.0 * kStep) - jacobian.col(i)).norm(), 1e-8) << i;
      EXPECT_NEAR((open_above - curve.gaps()[kOpen]) / (2.0 * kStep), rate, 1e-8) << i;
    }
  }
}

TEST(HatCurve, GapsAreThoseOfTheMotion) {
  HatFamily family{curve_family(test::to_problem(kStop), 1.5, 4.5)};
  family.samples = 32;
  HatCurve curve(family, 1);
  curve.press({7});
  ASSERT_TRUE(curve.evaluate(Eigen::Vector2d(0.5, 2.0)));
  const Eigen::VectorXd expected =
      (0.2 - curve.motion().col(0).array()) / family.displacement_unit;  // without restitution at the nodes
  EXPECT_LT((curve.gaps() - expected).norm(), 1e-12);
}

TEST(HatTracer, WithoutContactIsTheResponseOfTheGrid) {
  const Problem problem = test::to_problem({.damping = 0.2, .gap = 9.0});
  const BranchDiagram diagram = with_samples(64).follow(over_frequency(problem, 0.5, 2.0), {});
  ASSERT_EQ(diagram.branches.size(), 1U);
  const Branch& branch = diagram.branches.front();
  EXPECT_EQ(branch.ended, "end of the interval");
  EXPECT_NEAR(branch.points.back().parameter, 2.0, 1e-12);
  for (const SolutionPoint& point : branch.points) {
    const double w = point.parameter;
    const double exact = 1.0 / std::hypot(1.0 - w * w, 0.2 * w);
    EXPECT_NEAR(point.amplitude[0], exact, 5e-3 * exact) << "of second order in the step of the grid";
  }
}

std::vector<double> special(const BranchDiagram& diagram, SpecialKind kind, int order) {
  std::vector<double> found;
  for (const Branch& branch : diagram.branches) {
    for (const SpecialPoint& at : branch.special)
      if (at.kind == kind && at.point.order == order) found.push_back(at.point.parameter);
  }
  return found;
}

TEST(HatTracer, PassesTheFoldOfTwoPeriodsOnASpring) {
  const BranchDiagram diagram = with_samples(128).follow(over_frequency(sprung(100.0), 2.0, 4.0), {});
  const std::vector<double> births = special(diagram, SpecialKind::contact_change, 1);
  ASSERT_EQ(births.size(), 1U);
  EXPECT_NEAR(births[0], kGrazing, 5e-4) << "of second order in the step of the grid";
  const std::vector<double> folds = special(diagram, SpecialKind::fold, 2);
  ASSERT_FALSE(folds.empty());
  EXPECT_NEAR(*std::max_element(folds.begin(), folds.end()), kSpringFold, 3e-3);
  for (const Branch& branch : diagram.branches) {
    EXPECT_FALSE(branch.ended.empty());
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      EXPECT_LE(std::abs(branch.points[i].parameter - branch.points[i - 1].parameter), 0.11);
      EXPECT_LE(std::abs(branch.points[i].amplitude[0] - branch.points[i - 1].amplitude[0]), 0.15);
    }
  }
}

// Every point of a branch solves the complementarity problem: pressures and gaps are not negative.
TEST(HatTracer, PointsAreSolutionsOfTheComplementarityProblem) {
  HatFamily family{curve_family(sprung(100.0), 2.0, 4.0)};
  family.samples = 64;
  HatCurve curve(family, 1);
  ASSERT_TRUE(curve.evaluate(Eigen::VectorXd::Constant(1, 4.0 / family.frequency_unit)));
  const TracedBranch<HatStart> traced = trace_hat(
      family,
      {.multiple = 1, .pressing = {}, .x = curve.x(), .tangent = -Eigen::VectorXd::Ones(1), .origin = {}}, {},
      NoCurves());
  EXPECT_EQ(traced.branch.ended, "end of the interval");
  int pressing_points = 0;
  for (const Eigen::VectorXd& all : traced.points.x) {
    std::vector<int> pressing;
    for (int node = 0; node < curve.nodes(); ++node) {
      EXPECT_GE(all[node], -1e-12);
      if (all[node] != 0.0) pressing.push_back(node);
    }
    pressing_points += pressing.empty() ? 0 : 1;
    curve.press(pressing);
    ASSERT_TRUE(curve.evaluate(curve.on_pressing(all)));
    EXPECT_GE(curve.gaps().minCoeff(), -1e-11);
    if (!pressing.empty()) {
      EXPECT_LT(curve.residual().norm(), 1e-11);
    }
  }
  EXPECT_GT(pressing_points, 10);
}

// Where a node joins or leaves, a motion is the same with one set and the other, its mean on no spring too.
TEST(HatTracer, FoldsOfALooseMassAreOnItsCurve) {
  const BranchDiagram diagram = with_samples(64).follow(over_frequency(test::gear_backlash(), 0.4, 1.2), {});
  ASSERT_EQ(diagram.branches.size(), 1U);
  const Branch& branch = diagram.branches.front();
  int folds = 0;
  for (const SpecialPoint& special : branch.special) {
    if (special.text != "at a change of the pressing nodes") continue;
    const SolutionPoint& before = branch.points.at(special.after - 1);
    EXPECT_EQ(special.point.frequency, before.frequency);
    EXPECT_NEAR(special.point.x_max[0], before.x_max[0], 1e-9);
    ++folds;
  }
  EXPECT_GE(folds, 2);
}

TEST(HatTracer, LimitsAreSaid) {
  const BranchDiagram few =
      with_samples(64).follow(over_frequency(sprung(100.0), 4.0, 2.0), {.max_points = 5});
  ASSERT_FALSE(few.branches.empty());
  EXPECT_EQ(few.branches.front().ended, "limit of 5 points");
  const BranchDiagram late =
      with_samples(64).follow(over_frequency(sprung(100.0), 4.0, 2.0),
                              {.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)});
  EXPECT_EQ(late.unfinished, "the time is up");
  Problem free = test::to_problem(kStop);
  free.contacts.clear();
  free.set_law(std::monostate{});
  EXPECT_EQ(with_samples(64).follow(over_frequency(free, 1.0, 2.0), {}).unfinished,
            "the scene has no contact");
}

}  // namespace
}  // namespace signorini::hat_curve_test
