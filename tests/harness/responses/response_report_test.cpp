#include "harness/responses/response_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/harness/responses/drawn_responses.hpp"

namespace signorini {
namespace {

ResponseRecord exact_of(const std::string& scene) {
  ResponseRecord record{
      .case_id = scene + "/", .scene = scene, .from = 1.0, .to = 2.0, .status = Status::converged};
  record.branches = {{.frequency = {1.0, 1.5, 2.0}, .amplitude = {0.1, 0.2, 0.3}, .stable = {1, 0, 1}}};
  return record;
}

ResponseRecord of_method(const std::string& scene, const std::string& method, double covered, double length) {
  ResponseRecord record = exact_of(scene);
  record.case_id = scene + "/" + method;
  record.method = method;
  record.seconds = 0.5;
  record.comparison = CurveComparison{.close = {.covered = covered, .false_share = 0.0},
                                      .wide = {.covered = covered, .false_share = 0.25},
                                      .exact_length = length,
                                      .length = 2.0,
                                      .right_length = 1.5};
  record.comparison->points = {{.exact = {SpecialKind::fold, 1.25, 1}, .frequency = 1.5},
                               {.exact = {SpecialKind::period_doubling, 1.75, 1}}};
  return record;
}

const Section& section(const std::vector<Section>& sections, const std::string& id) {
  return *std::ranges::find_if(sections, [&](const Section& one) { return one.id == id; });
}

TEST(ResponseSections, SumByLengthAndNotByResponse) {
  const std::vector<ResponseRecord> records{exact_of("a"), of_method("a", "m", 1.0, 1.0), exact_of("b"),
                                            of_method("b", "m", 0.5, 3.0)};
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
  const std::vector<ResponseRecord> records{exact_of("a"), of_method("a", "m", 1.0, 1.0)};
  const std::vector<Section> sections = response_sections(records);
  const Table& table = section(sections, "located").table;
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][1].text, "fold");
  EXPECT_EQ(table.rows[0][4].text, "2.0e-01");
  EXPECT_EQ(table.rows[1][4].text, "-");
}

TEST(ResponseSections, SayWhereAMethodDoesNotApplyOrTheTruthIsOpen) {
  ResponseRecord other = of_method("a", "n", 0.0, 1.0);
  other.status = Status::not_applicable;
  other.message = "no such law";
  other.comparison.reset();
  ResponseRecord exact = exact_of("a");
  exact.open_ends = {"limit of 60 branches"};
  const std::vector<ResponseRecord> records{exact, other};
  const std::vector<Section> sections = response_sections(records);
  EXPECT_EQ(section(sections, "response-cases").table.rows.at(0).back().text, "no such law");
  EXPECT_EQ(section(sections, "responses").table.rows.at(0)[1].text, "0 of 0");
  EXPECT_EQ(section(sections, "open-ends").table.rows.at(0).back().text, "limit of 60 branches");
  EXPECT_TRUE(response_sections({}).front().table.rows.empty());
}

TEST(ResponseFigures, DrawTheExactBranchesByStabilityUnderTheMethods) {
  const std::vector<ResponseRecord> records{exact_of("a"), of_method("a", "m'; system('x')", 1.0, 1.0)};
  const std::vector<Figure> figures = response_figures(records);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "a-response");
  EXPECT_NE(figures[0].script.find("set title 'm''; system(''x'')' noenhanced"), std::string::npos)
      << figures[0].script;
  EXPECT_EQ(figures[0].script.find("index 3"), std::string::npos);  // stable, unstable, the method's
  EXPECT_NE(figures[0].script.find("index 2 with lines"), std::string::npos);
  EXPECT_TRUE(response_figures({}).empty());
}

}  // namespace
}  // namespace signorini
