// The sections of frequency responses.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "harness/report/evaluation/scene_groups.hpp"
#include "harness/report/sections/sections.hpp"
#include "tests/harness/responses/sample_responses.hpp"

namespace signorini::response_sections_test {
namespace {

const Section& section(const std::vector<Section>& sections, const std::string& id) {
  return *std::ranges::find_if(sections, [&](const Section& one) { return one.id == id; });
}

TEST(ResponseSections, SumByLengthAndNotByResponse) {
  const std::vector<Record> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0),
                                    test::exact_response("b"), test::response_of("b", "m", 0.5, 3.0)};
  const std::vector<Section> sections = response_sections(Evaluation(records));
  const std::vector<Cell>& row = section(sections, "responses").table.rows.at(0);
  EXPECT_EQ(row[0].text, "Rigid stop (e = 1)");
  EXPECT_EQ(row[1].text, "m");
  EXPECT_EQ(row[2].text, "2 of 2");
  EXPECT_EQ(row[3].text, "62.5 %");  // (1 + 1.5) / 4
  EXPECT_EQ(row[4].text, "25.0 %");
  EXPECT_EQ(row[5].text, "2 of 4");
  EXPECT_EQ(row[6].text, "2.0e-01");
  EXPECT_EQ(row[8].text, "1 s");
}

TEST(ResponseSections, NameTheLawOfAMethodThatRepresentsAnother) {
  const Record other = test::of_another_law(test::response_of("a", "m", 0.1, 1.0));
  const std::vector<Section> sections =
      response_sections(Evaluation(std::vector{test::exact_response("a"), other}));
  EXPECT_EQ(section(sections, "response-cases").table.rows.at(0)[2].text, "e = 1");
  EXPECT_EQ(section(sections, "located").table.rows.at(0)[4].text, "2.0e-01 (e = 1)");
  EXPECT_TRUE(section(sections, "responses").table.rows.empty());
  EXPECT_EQ(section(sections, "response-verdict").table.rows.at(0)[1].text, kTooFewScenes);
}

TEST(ResponseSections, RecommendForEachKindOfScenes) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "exact-orbit", 1.0, 0.0, 9.0);
  test::add_method(records, "m", 0.9, 0.0, 3.0);
  for (Record record : std::vector<Record>(records)) {
    if (record.scene != "b") continue;
    record.scene = "k";
    record.case_id += " k";
    record.scene_law = Penalty{{10.0}};
    records.push_back(record);
  }
  const Section verdict = section(response_sections(Evaluation(records)), "response-verdict");
  ASSERT_EQ(verdict.table.rows.size(), 2U);
  EXPECT_EQ(verdict.table.rows[0][0].text, "Rigid stop (e = 1), 3 responses");
  EXPECT_EQ(verdict.table.rows[0][1].text, "m");
  EXPECT_EQ(verdict.table.rows[0][2].text, "90.0 %");
  EXPECT_EQ(verdict.table.rows[0][5].text, "exact-orbit");
  EXPECT_EQ(verdict.table.rows[1][0].text, "Spring, 1 response");
  EXPECT_EQ(verdict.table.rows[1][1].text, kTooFewScenes);
  EXPECT_EQ(verdict.table.rows[1].size(), verdict.table.header.size());
}

TEST(ResponseSections, GiveEachLocatedPointWithItsErrorOrADash) {
  const std::vector<Record> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0)};
  const std::vector<Section> sections = response_sections(Evaluation(records));
  const Table& table = section(sections, "located").table;
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][1].text, "fold");
  EXPECT_EQ(table.rows[0][4].text, "2.0e-01");
  EXPECT_EQ(table.rows[1][4].text, "-");
}

TEST(ResponseSections, SayWhereAMethodDoesNotApplyOrTheTruthIsOpen) {
  Record other = test::response_of("a", "n", 0.0, 1.0);
  other.status = Status::not_applicable;
  other.message = "no such law";
  other.response->comparison.reset();
  Record exact = test::exact_response("a");
  exact.response->open_ends = {"limit of 60 branches"};
  const std::vector<Record> records{exact, other};
  const std::vector<Section> sections = response_sections(Evaluation(records));
  EXPECT_EQ(section(sections, "response-cases").table.rows.at(0).back().text, "no such law");
  EXPECT_TRUE(section(sections, "responses").table.rows.empty());
  EXPECT_EQ(section(sections, "open-ends").table.rows.at(0).back().text, "limit of 60 branches");
  EXPECT_TRUE(response_sections(Evaluation(std::vector<Record>())).empty());
}

TEST(ResponseSections, RecommendNothingWhereNoMethodQualifies) {
  std::vector<Record> records{test::exact_response("a"), test::exact_response("b"),
                              test::exact_response("c")};
  test::add_method(records, "inventive", 1.0, 1.0, 0.1);
  const std::vector<Cell> row =
      section(response_sections(Evaluation(records)), "response-verdict").table.rows.at(0);
  for (std::size_t i = 1; i < row.size(); ++i) EXPECT_EQ(row[i].text, "-") << i;
}

}  // namespace
}  // namespace signorini::response_sections_test
