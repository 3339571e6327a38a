// A method's curve consists of its solves, on every scene of the catalogue.

#include "methods/curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/conformance/method_case.hpp"
#include "tests/support/expected_failure.hpp"

namespace signorini::curve_test {
namespace {

using test::MethodCase;

std::vector<MethodCase> cases_with_curves() {
  std::vector<MethodCase> cases = test::all_cases();
  std::erase_if(cases,
                [](const MethodCase& pair) { return find_method(pair.method).make({})->curve() == nullptr; });
  return cases;
}

class Curve : public testing::TestWithParam<MethodCase> {};

TEST_P(Curve, PassesThroughTheAnswersOfSolves) {
  CheckSettings settings = test::check_settings(GetParam().method);
  settings.timeout = 10.0;  // of a curve: one that takes longer is remarked upon
  const CheckedMethod checked(find_method(GetParam().method), test::checked_method(GetParam()).problem(),
                              settings);
  const CheckResult result = check_curve(checked);
  if (result.outcome == CheckOutcome::passed) return;
  EXPECT_NE(result.outcome, CheckOutcome::failed) << result.why;
  EXPECT_NE(result.why, "") << "nothing to look at, and no reason";
}

INSTANTIATE_TEST_SUITE_P(Conformance, Curve, testing::ValuesIn(cases_with_curves()), test::CaseName());

}  // namespace
}  // namespace signorini::curve_test
