// What every answer must look like, and how solves end, on every scene of the catalogue.

#include <gtest/gtest.h>

#include "tests/conformance/method_case.hpp"
#include "tests/support/expected_failure.hpp"

namespace signorini::trajectory_test {
namespace {

using test::MethodCase;

class Answer : public testing::TestWithParam<MethodCase> {
 protected:
  const CheckedMethod& checked_ = test::checked_method(GetParam());

  static void expect(const CheckResult& result) {
    if (result.outcome == CheckOutcome::passed) return;
    EXPECT_EQ(result.outcome, CheckOutcome::not_applicable) << result.why;
    EXPECT_NE(result.why, "") << "nothing to look at, and no reason";
  }
};

TEST_P(Answer, IsASoundTrajectoryHoweverItIsSampled) { expect(check_trajectory(checked_)); }

TEST_P(Answer, IsRefusedOnlyWithAReason) { expect(check_applicability(checked_)); }

// A budget that is spent before the start: the answer may be there, a hang or an exception may not.
TEST_P(Answer, ComesEvenWhenTheTimeIsUp) { expect(check_time_budget(checked_)); }

// Scenes on which a method does not converge at the cheap resolution of this suite.
const test::KnownFailures& known_not_to_converge() {
  static const char* const kRay =
      "a path of pivots ends on a ray: damping ratio below 0.002 with few samples";
  static const char* const kLasts = "contact that lasts is not closed below restitution 1";
  static const char* const kBorn = "contacts of a rattling motion are born and lost as the penalty rises";
  static const test::KnownFailures known{
      {"HatLcp_sdof_penalty_stiff",
       "a path of pivots ends on a ray: the stop's spring has a period shorter than a step"},
      {"HatLcp_sdof_very_light_damping", kRay},
      {"FourierLipschitz_sdof_very_light_damping", kRay},
      {"FourierLipschitz_sdof_very_light_damping_e08", kRay},
      {"PenaltyHbm_sdof_very_light_damping", kRay},
      {"PenaltyHbm_sdof_very_light_damping_e08", kRay},
      {"AftHbm_sdof_very_light_damping", kRay},
      {"AftHbm_sdof_very_light_damping_e08", kRay},
      {"ClosedHbm_chain2_stick", kLasts},
      {"ClosedHbm_sdof_chatter", kLasts},
      {"ClosedHbm_sdof_preload_rest", kLasts},
      {"ClosedHbm_sdof_stick", kLasts},
      {"AugmentedLagrangian_sdof_chatter", kBorn},
      {"AugmentedLagrangian_sdof_stick", kBorn}};
  return known;
}

TEST_P(Answer, Converges) {
  if (!checked_.support().ok) return expect(check_applicability(checked_));
  const Solution& answer = checked_.answer();
  test::expect_pass_unless_known(GetParam().name(), answer.verdict == Verdict::converged, answer.message,
                                 known_not_to_converge());
}

INSTANTIATE_TEST_SUITE_P(Conformance, Answer, testing::ValuesIn(test::all_cases()), test::CaseName());

}  // namespace
}  // namespace signorini::trajectory_test
