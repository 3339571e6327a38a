// Words in one text and apart: empty ones, separators at the ends, replacements that hold what is replaced.

#include "harness/text/words.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace signorini::words_test {
namespace {

using Words = std::vector<std::string>;

TEST(Words, AreJoined) {
  EXPECT_EQ(joined(Words{}, ", "), "");
  EXPECT_EQ(joined(Words{"a"}, ", "), "a");
  EXPECT_EQ(joined(Words{"a", "", "b"}, ", "), "a, , b");
  EXPECT_EQ(joined(std::vector<double>{1.0, 0.25}, "{:.1f}", " "), "1.0 0.2");
}

TEST(Words, AreSplitAtEverySeparator) {
  EXPECT_EQ(split("", ':'), (Words{""}));
  EXPECT_EQ(split("a", ':'), (Words{"a"}));
  EXPECT_EQ(split(":a::b:", ':'), (Words{"", "a", "", "b", ""}));
}

TEST(Words, AreReplacedOnceFromTheLeft) {
  EXPECT_EQ(replaced("a-b-", "-", "\\-"), "a\\-b\\-");
  EXPECT_EQ(replaced("aaa", "aa", "b"), "ba");
  EXPECT_EQ(replaced("abc", "x", "y"), "abc");
  EXPECT_EQ(replaced("", "x", "y"), "");
}

TEST(Words, AreBrokenIntoLinesAtBlanks) {
  EXPECT_EQ(wrapped_lines("one two  three\nfour", 9), (Words{"one two", "three", "four"}));
  EXPECT_EQ(wrapped_lines("one two three", 13), (Words{"one two three"}));
  EXPECT_EQ(wrapped_lines("a longestword b", 5), (Words{"a", "longestword", "b"}));
  EXPECT_EQ(wrapped_lines("", 5), (Words{""}));
}

TEST(Numbers, AreRoundedToTheDigitsThatAreShownWhateverTheirSize) {
  EXPECT_EQ(rounded(1.23456, 3), 1.23);
  EXPECT_EQ(rounded(-0.0098765, 2), -0.0099);
  EXPECT_EQ(rounded(5e-324, 5), 5e-324);  // text of it is read, though it is no normal number
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(rounded(most, 4), most);  // 1.798e308 is none
}

}  // namespace
}  // namespace signorini::words_test
