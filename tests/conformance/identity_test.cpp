// Identities that need no oracle: equivalent problems must get equivalent answers, on every scene of the
// catalogue.

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/conformance/method_case.hpp"

namespace signorini {
namespace {

using test::MethodCase;

// Pairs whose answer to an equivalent problem may be another solution, or none: pair -> reason. Where one is
// found, the check has seen that it solves the scene. Take a pair off when its reason is gone.
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

class Identity : public testing::TestWithParam<MethodCase> {
 protected:
  const Subject& subject_ = test::subject_of(GetParam());

  void expect(const CheckResult& result, const Ledger& others) const {
    if (result.outcome == CheckOutcome::not_applicable) GTEST_SKIP() << result.why;
    if (result.outcome == CheckOutcome::passed) return;
    const std::string pair = GetParam().name();
    if (decided_by_rounding().contains(pair) &&
        result.why.starts_with("the equivalent problem is not solved"))
      return;
    EXPECT_EQ(result.outcome, CheckOutcome::remarked) << result.why;
    EXPECT_TRUE(others.contains(pair)) << result.why;
  }
};

TEST_P(Identity, AnswerScalesWithLoadAndGap) { expect(check_load_scaling(subject_), decided_by_rounding()); }

TEST_P(Identity, ForceAloneScalesWithTheStructure) {
  expect(check_structure_scaling(subject_), decided_by_rounding());
}

TEST_P(Identity, AnswerIsTheSameInOtherUnitsOfTime) {
  expect(check_time_scaling(subject_), decided_by_rounding());
}

TEST_P(Identity, NumberingOfCoordinatesDoesNotMatter) {
  expect(check_numbering(subject_), decided_by_rounding());
}

TEST_P(Identity, AnswerComesLaterWithTheLoad) {
  expect(check_time_shift(subject_), decided_by_the_time_origin());
}

TEST_P(Identity, TwoSolvesGiveTheSameBits) { expect(check_determinism(subject_), {}); }

TEST_P(Identity, AnswerIsTheLinearResponseWhereNoStopIsInReach) { expect(check_contact_free(subject_), {}); }

INSTANTIATE_TEST_SUITE_P(Conformance, Identity, testing::ValuesIn(test::all_cases()), test::CaseName());

}  // namespace
}  // namespace signorini
