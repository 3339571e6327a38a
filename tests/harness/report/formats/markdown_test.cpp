#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "harness/failure.hpp"
#include "harness/report/formats/formats.hpp"

namespace signorini::markdown_test {
namespace {

TEST(WithTables, ReplacesWhatStandsBetweenTheMarkersOfItsRun) {
  const std::vector<Section> sections{{.id = "one",
                                       .title = {},
                                       .text = {},
                                       .table = {{"a", "b"}, {{"x", "1"}, {"y", "2"}}},
                                       .note = {},
                                       .figures = {}}};
  const std::string document =
      "head\n<!-- table run/one y -->\nold\n<!-- /table -->\nmiddle\n<!-- table other/one -->\nold\n<!-- "
      "/table "
      "-->\ntail\n";
  const std::string expected =
      "head\n<!-- table run/one y -->\n\n| a | b |\n|---|---|\n| y | 2 |\n\n<!-- /table -->\nmiddle\n<!-- "
      "table "
      "other/one -->\nold\n<!-- /table -->\ntail\n";
  EXPECT_EQ(with_tables(document, "run", sections), expected);
  EXPECT_EQ(with_tables(expected, "run", sections), expected);
}

TEST(WithTables, RefusesWhatItCannotFillIn) {
  const std::vector<Section> none;
  EXPECT_THROW(with_tables("<!-- table run/one -->\n<!-- /table -->", "run", none), UsageError);
  EXPECT_THROW(with_tables("<!-- table run/one -->\n", "run", none), UsageError);
  try {
    with_tables("<!-- table run/one -->\ntext\n", "run", none);
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "<!-- table run/one --> (must be closed by a line <!-- /table -->)");
  }
}

TEST(WithTables, FindsNothingToDoWhereNoMarkerOrNoRowIsMeant) {
  Section section;
  section.id = "one";
  section.table = {{"a", "b"}, {{"x", "1"}}};
  const std::vector<Section> sections{section};
  const std::string document = "<!-- table run/one y -->\n<!-- /table -->\n";
  EXPECT_THROW(with_tables(document, "run", sections), NothingMatched);
  EXPECT_THROW(with_tables(document, "other", sections), NothingMatched);
}

TEST(MarkdownReport, EndsLongTablesAndSaysHowManyRowsThereAre) {
  Section section{.id = "one", .title = "One", .table = {.header = {"a"}}};
  for (int i = 0; i < 100; ++i) section.table.rows.push_back({std::to_string(i)});
  const std::vector<Section> sections{section};
  const std::string whole = markdown_report(sections);
  EXPECT_NE(whole.find("| 99"), std::string::npos);
  EXPECT_EQ(markdown_report(sections, whole.size()), whole);
  const std::string part = markdown_report(sections, whole.size() / 4);
  EXPECT_LT(part.size(), whole.size() / 2);
  EXPECT_NE(part.find("| 0 "), std::string::npos);
  EXPECT_EQ(part.find("| 99"), std::string::npos);
  EXPECT_NE(part.find(" of 100 rows"), std::string::npos) << part;
  EXPECT_NE(markdown_report(sections, 1).find("1 of 100 rows"), std::string::npos);
}

TEST(MarkdownReport, HasTitleTextTableAndNoteOfEverySection) {
  Section section;
  section.id = "one";
  section.title = "One";
  section.text = "Before.";
  section.table = {{"a"}, {{"1"}}};
  section.note = "After.";
  Section words;
  words.title = "Two";
  words.text = "No table.";
  EXPECT_EQ(markdown_report(std::vector{section, words}),
            "## One\n\nBefore.\n\n| a   |\n|-----|\n| 1   |\n\nAfter.\n\n## Two\n\nNo table.\n\n");
}

TEST(MarkdownReport, BreaksLinesOfMoreThanAHundredAndTenCharactersAtBlanks) {
  Section section;
  section.title = "One";
  for (int i = 0; i < 60; ++i) section.text += "word ";
  std::istringstream lines(markdown_report(std::vector{section}));
  std::size_t longest = 0, words = 0;
  for (std::string line; std::getline(lines, line);) {
    longest = std::max(longest, line.size());
    for (std::size_t at = line.find("word"); at != std::string::npos; at = line.find("word", at + 1)) ++words;
  }
  EXPECT_EQ(words, 60U);
  EXPECT_EQ(longest, 109U);  // 22 words of four letters and their blanks
}

}  // namespace
}  // namespace signorini::markdown_test
