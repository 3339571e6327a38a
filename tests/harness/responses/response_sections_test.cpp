#include "harness/responses/response_sections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "tests/harness/responses/sample_responses.hpp"

namespace signorini {
namespace {

const Section& section(const std::vector<Section>& sections, const std::string& id) {
  return *std::ranges::find_if(sections, [&](const Section& one) { return one.id == id; });
}

TEST(ResponseSections, SumByLengthAndNotByResponse) {
  const std::vector<ResponseRecord> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0),
                                            test::exact_response("b"), test::response_of("b", "m", 0.5, 3.0)};
  const std::vector<Section> sections = response_sections(records);
  const std::vector<Cell>& row = section(sections, "responses").table.rows.at(0);
  EXPECT_EQ(row[0].text, "m");
  EXPECT_EQ(row[1].text, "2 of 2");
  EXPECT_EQ(row[2].text, "62.5 %");  // (1 + 1.5) / 4
  EXPECT_EQ(row[3].text, "25.0 %");
  EXPECT_EQ(row[4].text, "2 of 4");
  EXPECT_EQ(row[5].text, "2.0e-01");
  EXPECT_EQ(row[7].text, "1 s");
}

TEST(ResponseSections, GiveEachLocatedPointWithItsErrorOrADash) {
  const std::vector<ResponseRecord> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0)};
  const std::vector<Section> sections = response_sections(records);
  const Table& table = section(sections, "located").table;
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][1].text, "fold");
  EXPECT_EQ(table.rows[0][4].text, "2.0e-01");
  EXPECT_EQ(table.rows[1][4].text, "-");
}

TEST(ResponseSections, SayWhereAMethodDoesNotApplyOrTheTruthIsOpen) {
  ResponseRecord other = test::response_of("a", "n", 0.0, 1.0);
  other.status = Status::not_applicable;
  other.message = "no such law";
  other.comparison.reset();
  ResponseRecord exact = test::exact_response("a");
  exact.open_ends = {"limit of 60 branches"};
  const std::vector<ResponseRecord> records{exact, other};
  const std::vector<Section> sections = response_sections(records);
  EXPECT_EQ(section(sections, "response-cases").table.rows.at(0).back().text, "no such law");
  EXPECT_EQ(section(sections, "responses").table.rows.at(0)[1].text, "0 of 0");
  EXPECT_EQ(section(sections, "open-ends").table.rows.at(0).back().text, "limit of 60 branches");
  EXPECT_TRUE(response_sections({}).front().table.rows.empty());
}

/// A method that finds a share of the exact branches of two scenes at a cost, with a share of false ones.
void add_method(std::vector<ResponseRecord>& records, const std::string& method, double covered, double wrong,
                double seconds) {
  for (const char* scene : {"a", "b"}) {
    ResponseRecord record = test::response_of(scene, method, covered, 1.0);
    record.comparison->wide.false_share = wrong;
    record.seconds = seconds;
    records.push_back(record);
  }
}

TEST(ResponseStandings, RecommendTheCheapestOfThoseThatFindNearlyAsMuchAndInventLittle) {
  std::vector<ResponseRecord> records{test::exact_response("a"), test::exact_response("b")};
  add_method(records, "exact-orbit", 1.0, 0.0, 9.0);
  add_method(records, "most", 0.92, 0.04, 8.0);
  add_method(records, "nearly", 0.88, 0.05, 4.0);
  add_method(records, "cheap", 0.5, 0.0, 1.0);
  add_method(records, "inventive", 1.0, 0.06, 0.1);
  const std::vector<ResponseStanding> standings = response_standings(records);
  ASSERT_EQ(standings.size(), 5U);
  for (const ResponseStanding& one : standings) {
    EXPECT_EQ(one.recommended, one.label == "exact-orbit") << one.label;
    EXPECT_EQ(one.recommended_otherwise, one.label == "nearly") << one.label;
  }
  EXPECT_DOUBLE_EQ(standings[2].covered, 0.88);
  EXPECT_DOUBLE_EQ(standings[2].cost.value(), 4.0 / 1.5);
  const std::string verdict = response_verdict(records);
  EXPECT_EQ(
      verdict.rfind("Take `exact-orbit` (100.0 % of the exact branches, 0.0 % false, 6 s per length).", 0),
      0U)
      << verdict;
  EXPECT_NE(verdict.find("the best of the others is `nearly` (88.0 %"), std::string::npos) << verdict;
}

TEST(ResponseStandings, CountAResponseThatAMethodDoesNotApplyToAsNotFound) {
  std::vector<ResponseRecord> records{test::exact_response("a"), test::exact_response("b")};
  add_method(records, "half", 1.0, 0.0, 1.0);
  records.back().status = Status::not_applicable;
  records.back().comparison.reset();
  add_method(records, "all", 0.7, 0.0, 9.0);
  const std::vector<ResponseStanding> standings = response_standings(records);
  EXPECT_DOUBLE_EQ(standings[0].covered, 0.5);
  EXPECT_TRUE(standings[1].recommended);
}

TEST(ResponseScreen, HasALinePerMethodWithin80Columns) {
  std::vector<ResponseRecord> records{test::exact_response("a"), test::exact_response("b")};
  add_method(records, "exact-orbit[samples=64]", 1.0, 0.0, 9.0);
  add_method(records, "a-method-of-a-long-name[with=many,settings=indeed]", 0.5, 0.0, 8.0);
  std::istringstream screen(response_screen(records));
  int starred = 0, lines = 0;
  for (std::string line; std::getline(screen, line); ++lines) {
    EXPECT_LE(line.size(), 80U) << line;
    if (line.starts_with("* ")) ++starred;
  }
  EXPECT_EQ(starred, 2);
  EXPECT_LT(lines, 20);
  EXPECT_NE(
      screen.str().find("* exact-orbit[samples=64]                   100.0 %    0.0 %     2/4         6 s\n"),
      std::string::npos)
      << screen.str();
}

TEST(ResponseVerdict, SaysSoWhereNoMethodQualifies) {
  std::vector<ResponseRecord> records{test::exact_response("a"), test::exact_response("b")};
  add_method(records, "inventive", 1.0, 0.5, 0.1);
  EXPECT_EQ(response_verdict(records),
            "No method finds any of the exact branches with at most 5 % false ones.");
}

}  // namespace
}  // namespace signorini
