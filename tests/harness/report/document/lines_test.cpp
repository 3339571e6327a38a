#include "harness/report/document/lines.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace {

using Lines = std::vector<std::string>;

TEST(WrappedLines, BreakAtBlanksAndFillEachLine) {
  EXPECT_EQ(wrapped_lines("one two  three\nfour", 9), (Lines{"one two", "three", "four"}));
  EXPECT_EQ(wrapped_lines("one two three", 13), (Lines{"one two three"}));
  EXPECT_EQ(wrapped_lines("a longestword b", 5), (Lines{"a", "longestword", "b"}));
  EXPECT_EQ(wrapped_lines("", 5), (Lines{""}));
}

TEST(Clipped, KeepsWhatFitsAndCutsNoCharacterInHalf) {
  EXPECT_EQ(clipped("abcdef", 6), "abcdef");
  EXPECT_EQ(clipped("abcdefg", 6), "abc...");
  EXPECT_EQ(clipped("ab\u00e9defg", 6), "ab...");  // the third character has two bytes
}

}  // namespace
}  // namespace signorini
