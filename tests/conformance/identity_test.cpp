// Identities that need no oracle: equivalent problems must get equivalent answers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "tests/conformance/method_case.hpp"
#include "tests/conformance/transformations.hpp"

namespace signorini {
namespace {

using test::MethodCase;

// Powers of no base: every product is rounded.
constexpr double kLoad = 3.7;
constexpr double kStructure = 0.23;
constexpr double kTime = 1.9;

// Pairs whose answer to an equivalent problem may be another solution, or none: pair -> reason. Where one
// is found it is checked to solve the scene. Take a pair off when its reason is gone.
using Ledger = std::map<std::string, std::string>;

const Ledger& decided_by_rounding() {
  static const Ledger ledger{
      // 2026-11-21: contact 2 mirrors contact 1 half a period later, so that two samples switch at once on
      // the homotopy's path, and its shift has nothing that separates them.
      {"AftHbm_sdof_two_sided", "tie between mirrored contacts"},
      {"AftHbm_sdof_two_sided_e08", "tie between mirrored contacts"},
  };
  return ledger;
}

const Ledger& decided_by_the_time_origin() {
  static const Ledger ledger{
      // 2026-11-21: x -> -x half a period later maps these scenes on themselves; what breaks the tie
      // (irregular part of the covering vector, the state marching begins in) is fixed to t = 0.
      {"FourierLipschitz_sdof_two_sided", "mirrored solution"},
      {"PenaltyHbm_sdof_two_sided", "mirrored solution"},
      {"AftHbm_sdof_two_sided", "mirrored solution"},
      {"AftHbm_sdof_two_sided_e08", "mirrored solution"},
      {"EventDriven_sdof_two_sided_e08", "another of several attractors"},
  };
  return ledger;
}

/// What the answer to the transformed problem must be, in terms of the original one.
struct Expected {
  double displacement = 1.0;
  double force = 1.0;
  double impulse = 1.0;
  int delay = 0;  // steps of the comparison grid
};

class Identity : public testing::TestWithParam<MethodCase> {
 protected:
  void SetUp() override {
    const Support support = method_->supports(problem_);
    if (!support.ok) GTEST_SKIP() << support.reason;
    if (base().verdict != Verdict::converged) GTEST_SKIP() << "not converged here: " << base().message;
  }

  [[nodiscard]] const Solution& base() const { return test::base_answer(GetParam()); }

  /// Largest deviation of an answer from what it must be, relative to the answer's own scales [-].
  [[nodiscard]] double deviation(const Trajectory& found, const Expected& expected) const {
    const int count = traits_.samples;
    const Samples before = base().trajectory->sample(count);
    const Samples after = found.sample(count);
    if (after.x.cols() == 0) return 0.0;
    const double x_scale = test::displacement_scale(problem_, before);
    // Forces on the scale of the load: a contact that barely presses is judged by what could press it.
    const double f_scale = std::max(before.force.cwiseAbs().maxCoeff(), load_scale());
    double worst = 0.0;
    for (int i = 0; i < count; ++i) {
      const int j = (i + expected.delay) % count;
      worst = std::max(
          worst, (after.x.row(j) / expected.displacement - before.x.row(i)).cwiseAbs().maxCoeff() / x_scale);
      worst = std::max(
          worst, (after.force.row(j) / expected.force - before.force.row(i)).cwiseAbs().maxCoeff() / f_scale);
    }
    return std::max(worst, impulse_deviation(found, expected));
  }

  void expect(const Problem& transformed, const Expected& expected) {
    ASSERT_NO_THROW(validate(transformed));
    const Solution solution = test::solve(*method_, transformed);
    const bool listed = decided_by_rounding().contains(pair_.name());
    if (listed && solution.verdict != Verdict::converged) return;
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    if (!listed) {
      EXPECT_LE(deviation(*solution.trajectory, expected), traits_.agreement);
      return;
    }
    expect_solution(transformed, solution.trajectory);
  }

  // A start from a solution must stay there.
  void expect_solution(const Problem& problem, const std::shared_ptr<const Trajectory>& motion) {
    const Solution again = test::solve(*method_, problem, motion);
    ASSERT_EQ(again.verdict, Verdict::converged) << again.message;
    const Samples given = motion->sample(traits_.samples), kept = again.trajectory->sample(traits_.samples);
    EXPECT_LE((given.x - kept.x).cwiseAbs().maxCoeff(),
              traits_.agreement * test::displacement_scale(problem, given));
  }

  MethodCase pair_ = GetParam();
  test::MethodTraits traits_ = test::traits_of(pair_.method);
  Problem problem_ = test::scene_of(pair_);
  std::unique_ptr<Method> method_ = test::method_of(pair_);

 private:
  [[nodiscard]] double load_scale() const {
    double scale = std::numeric_limits<double>::min();
    for (const ForceTerm& term : problem_.force) scale = std::max(scale, std::hypot(term.cos, term.sin));
    return scale;
  }

  // Impulse per period and contact.
  [[nodiscard]] double impulse_deviation(const Trajectory& found, const Expected& expected) const {
    std::vector<double> before(static_cast<std::size_t>(problem_.contact_count())), after = before;
    for (const Impulse& impulse : base().trajectory->impulses()) {
      before[static_cast<std::size_t>(impulse.contact)] += impulse.value;
    }
    for (const Impulse& impulse : found.impulses())
      after[static_cast<std::size_t>(impulse.contact)] += impulse.value;
    double worst = 0.0, scale = load_scale() * problem_.period();
    for (std::size_t c = 0; c < before.size(); ++c) {
      worst = std::max(
          worst, std::abs(after[c] / expected.impulse - before[c]) / std::max(scale, std::abs(before[c])));
    }
    return worst;
  }
};

TEST_P(Identity, AnswerScalesWithLoadAndGap) {
  expect(test::with_load_scaled(problem_, kLoad), {.displacement = kLoad, .force = kLoad, .impulse = kLoad});
}

TEST_P(Identity, ForceAloneScalesWithTheStructure) {
  expect(test::with_structure_scaled(problem_, kStructure), {.force = kStructure, .impulse = kStructure});
}

TEST_P(Identity, AnswerIsTheSameInOtherUnitsOfTime) {
  expect(test::with_time_scaled(problem_, kTime), {.impulse = kTime});
}

TEST_P(Identity, NumberingOfCoordinatesDoesNotMatter) {
  expect(test::with_coordinates_reversed(problem_), {});
}

TEST_P(Identity, TwoSolvesGiveTheSameBits) {
  const auto prepared = method_->prepare(problem_);
  const Solution first = prepared->solve({});
  const Solution second = prepared->solve({});
  const Solution third = test::solve(*method_, problem_);
  for (const Solution* other : {&second, &third}) {
    ASSERT_EQ(first.verdict, other->verdict);
    EXPECT_EQ(first.message, other->message);
    EXPECT_EQ(first.residual, other->residual);
    const Samples a = first.trajectory->sample(50), b = other->trajectory->sample(50);
    EXPECT_TRUE(a.x == b.x && a.velocity == b.velocity && a.force == b.force);
  }
}

TEST_P(Identity, AnswerComesLaterWithTheLoad) {
  const int grid = traits_.samples, steps = 5 * grid / 16 + 1, order = problem_.subharmonic;
  const double shift = steps * problem_.period() / grid;
  const Solution solution = test::solve(*method_, test::with_load_delayed(problem_, shift));
  if (decided_by_rounding().contains(pair_.name()) && solution.verdict != Verdict::converged) return;
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  // A subharmonic motion may come any number of forcing periods later still.
  double nearest = deviation(*solution.trajectory, {.delay = steps});
  for (int turn = 1; turn < order; ++turn) {
    nearest = std::min(nearest, deviation(*solution.trajectory, {.delay = steps + turn * grid / order}));
  }
  if (nearest <= traits_.agreement) return;
  EXPECT_TRUE(decided_by_the_time_origin().contains(pair_.name())) << "deviation " << nearest;
  expect_solution(problem_, std::make_shared<test::DelayedTrajectory>(solution.trajectory, -steps, grid));
}

INSTANTIATE_TEST_SUITE_P(Conformance, Identity, testing::ValuesIn(test::all_cases()), test::CaseName());

}  // namespace
}  // namespace signorini
