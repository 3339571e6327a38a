#include "tests/support/expected_failure.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace signorini::test::expected_failure_test {
namespace {

TEST(ExpectFailure, PassesWhileAnExpectationOfItsBodyFails) {
  expect_failure("one is not two", [] { EXPECT_EQ(1, 2); });
  expect_failure("one is not two, and nothing follows", [] {
    ASSERT_EQ(1, 2);
    throw std::logic_error("not reached");
  });
}

TEST(ExpectFailure, FailsWithItsReasonOnceTheBodyPasses) {
  EXPECT_NONFATAL_FAILURE(expect_failure("rain", [] { EXPECT_EQ(1, 1); }), "passes now: rain");
}

TEST(ExpectFailure, LetsExceptionsThrough) {
  EXPECT_THROW(expect_failure("rain", [] { throw std::logic_error("not an expectation"); }),
               std::logic_error);
}

TEST(KnownFailures, MustFailAndAllOtherCasesMustPass) {
  const KnownFailures known{{"late", "rain"}};
  expect_pass_unless_known("late", false, "too late", known);
  expect_pass_unless_known("early", true, "", known);
  EXPECT_NONFATAL_FAILURE(expect_pass_unless_known("late", true, "", known), "passes now: rain");
  EXPECT_NONFATAL_FAILURE(expect_pass_unless_known("early", false, "too late", known), "early: too late");
}

}  // namespace
}  // namespace signorini::test::expected_failure_test
