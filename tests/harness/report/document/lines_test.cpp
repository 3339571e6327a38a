#include "harness/report/document/lines.hpp"

#include <gtest/gtest.h>

namespace signorini::lines_test {
namespace {

using Lines = std::vector<std::string>;

TEST(Plural, IsOfAllCountsButOne) {
  EXPECT_EQ(plural(0, "case"), "0 cases");
  EXPECT_EQ(plural(1, "case"), "1 case");
  EXPECT_EQ(plural(2, "case"), "2 cases");
}

TEST(WithUnitSigns, SpellsMicrosecondsAndNothingElse) {
  EXPECT_EQ(with_unit_signs("59.4 us, 17 of 17"), "59.4 \u00b5s, 17 of 17");
  EXPECT_EQ(with_unit_signs("17 of 17, 1 us"), "17 of 17, 1 \u00b5s");
  EXPECT_EQ(with_unit_signs("3 ms; as of us, 2 users"), "3 ms; as of us, 2 users");
}

TEST(NamedLines, BeginBelowEachOtherBesideTheName) {
  EXPECT_EQ(named_lines("law", 5, "one two three", 12), "law  one two\n     three\n");
  EXPECT_EQ(named_lines("none", 6, "", 12), "none  \n");
}

TEST(Clipped, KeepsWhatFitsAndCutsNoCharacterInHalf) {
  EXPECT_EQ(clipped("abcdef", 6), "abcdef");
  EXPECT_EQ(clipped("abcdefg", 6), "abc...");
  EXPECT_EQ(clipped("ab\u00e9defg", 6), "ab...");  // the third character has two bytes
}

}  // namespace
}  // namespace signorini::lines_test
