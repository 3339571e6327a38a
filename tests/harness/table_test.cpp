#include "harness/table.hpp"

#include <gtest/gtest.h>

namespace signorini::table_test {
namespace {

TEST(ToCsv, QuotesWhatNeedsIt) {
  EXPECT_EQ(to_csv({{"a", "b"}, {{"1,2", "say \"x\""}}}), "a,b\n\"1,2\",\"say \"\"x\"\"\"\n");
}

TEST(ToMarkdown, EscapesPipes) {
  EXPECT_NE(to_markdown({{"a"}, {{"x|y"}}}).find("x\\|y"), std::string::npos);
}

TEST(NaturalLess, ComparesRunsOfDigitsAsNumbers) {
  EXPECT_TRUE(natural_less("n=9", "n=10"));
  EXPECT_FALSE(natural_less("n=10", "n=9"));
  EXPECT_TRUE(natural_less("a2b10", "a2b11"));
  EXPECT_TRUE(natural_less("a", "a1"));
  EXPECT_FALSE(natural_less("a", "a"));
}

}  // namespace
}  // namespace signorini::table_test
