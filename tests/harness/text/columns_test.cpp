// Tables on a terminal: alignment, and lines that are no longer than it is wide.

#include "harness/text/columns.hpp"

#include <gtest/gtest.h>

namespace signorini::columns_test {
namespace {

TEST(ToColumns, AlignsWordsLeftAndNumbersRight) {
  const Table table{.header = {"name", "n"},
                    .rows = {{"\u00b5", Cell("10", 10.0)}, {"longer", Cell("9", 9.0)}}};
  EXPECT_EQ(to_columns(table), "name     n\n\u00b5       10\nlonger   9\n");
  EXPECT_EQ(to_columns({.header = {"a", "b"}, .rows = {{"x", ""}}}), "a  b\nx\n");
  EXPECT_EQ(to_columns({}), "");
}

TEST(ToColumns, KeepsWhatFitsAsItIsInCharactersNotBytes) {
  EXPECT_EQ(to_columns({.header = {"time", "b"}, .rows = {{"59.4 \u00b5s", "x  y"}}}),
            "time     b\n59.4 \u00b5s  x  y\n");
}

TEST(ToColumns, BreaksTheWidestWordsWhereALineIsTooLong) {
  const Table table{.header = {"what", "n", "why it is so"},
                    .rows = {{"load", Cell("2.5 s", 2.5), "other processes are at work; stop them"},
                             {"turbo", Cell("-", 0.0), "no"}}};
  EXPECT_EQ(to_columns(table, 30),
            "what       n  why it is so\n"
            "load   2.5 s  other processes\n"
            "              are at work;\n"
            "              stop them\n"
            "turbo      -  no\n");
}

TEST(ToColumns, LeavesLongWordsAndNumbersWhole) {
  const Table table{.header = {"n", "path"},
                    .rows = {{Cell("1 000 000", 1e6), "a/long/path/without/blanks of it"}}};
  EXPECT_EQ(to_columns(table, 10),
            "        n  path\n1 000 000  a/long/path/without/blanks\n           of it\n");
}

}  // namespace
}  // namespace signorini::columns_test
