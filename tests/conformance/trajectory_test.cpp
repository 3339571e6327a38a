// What every answer must look like, and how solves end, on every scene of the catalogue.

#include <gtest/gtest.h>

#include "tests/conformance/method_case.hpp"
#include "tests/support/expected_failure.hpp"

namespace signorini {
namespace {

using test::MethodCase;

class Answer : public testing::TestWithParam<MethodCase> {
 protected:
  const CheckedMethod& checked_ = test::checked_method(GetParam());

  static void expect(const CheckResult& result) {
    if (result.outcome == CheckOutcome::not_applicable) GTEST_SKIP() << result.why;
    EXPECT_EQ(result.outcome, CheckOutcome::passed) << result.why;
  }
};

TEST_P(Answer, IsASoundTrajectoryHoweverItIsSampled) { expect(check_trajectory(checked_)); }

TEST_P(Answer, IsRefusedOnlyWithAReason) { expect(check_applicability(checked_)); }

// A budget that is spent before the start: the answer may be there, a hang or an exception may not.
TEST_P(Answer, ComesEvenWhenTheTimeIsUp) { expect(check_time_budget(checked_)); }

// At the suite's cheap resolutions.
TEST_P(Answer, Converges) {
  static const test::KnownFailures known{};
  if (!checked_.support().ok) GTEST_SKIP() << checked_.support().reason;
  const Solution& answer = checked_.answer();
  test::expect_pass_unless_known(GetParam().name(), answer.verdict == Verdict::converged, answer.message,
                                 known);
}

INSTANTIATE_TEST_SUITE_P(Conformance, Answer, testing::ValuesIn(test::all_cases()), test::CaseName());

}  // namespace
}  // namespace signorini
