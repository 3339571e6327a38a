#include <gtest/gtest.h>

#include "harness/compare/comparison.hpp"
#include "tests/harness/responses/sample_responses.hpp"

namespace signorini::response_change_test {
namespace {

RecordedResponse response(double covered = 0.8, double wrong = 0.25) {
  RecordedResponse one = *test::response_of("s", "m", covered, 1.0).response;
  one.comparison->wide.false_share = wrong;
  return one;
}

TEST(ResponseChange, IsNoneWithinAPercentOfLength) {
  EXPECT_FALSE(response_change(response(), response()).has_value());
  EXPECT_FALSE(response_change(response(0.8), response(0.795)).has_value());
}

TEST(ResponseChange, TellsWhatIsFoundBeforeWhatIsFalse) {
  const ResponseChange less = response_change(response(0.8), response(0.6, 0.1)).value();
  EXPECT_TRUE(less.worse);
  EXPECT_EQ(less.detail, "found 80.0 % became 60.0 %");
  EXPECT_FALSE(response_change(response(0.6), response(0.8)).value().worse);
  const ResponseChange invents = response_change(response(0.8, 0.1), response(0.8, 0.2)).value();
  EXPECT_TRUE(invents.worse);
  EXPECT_EQ(invents.detail, "false 10.0 % became 20.0 %");
}

TEST(ResponseChange, CountsTheSpecialPointsThatWereLocated) {
  RecordedResponse fewer = response();
  fewer.comparison->points[0].frequency.reset();
  EXPECT_EQ(response_change(response(), fewer).value().detail, "special points located 1 became 0");
  RecordedResponse exact = *test::exact_response("s").response, other = exact;
  other.located.clear();
  EXPECT_TRUE(response_change(exact, other).value().worse);
}

TEST(ResponseChange, TellsAComparisonThatIsGone) {
  RecordedResponse alone = response();
  alone.comparison.reset();
  EXPECT_TRUE(response_change(response(), alone).value().worse);
  EXPECT_FALSE(response_change(alone, response()).value().worse);
}

}  // namespace
}  // namespace signorini::response_change_test
