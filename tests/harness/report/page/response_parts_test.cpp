#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/report/page/page.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/report/sections/sections.hpp"
#include "tests/harness/responses/sample_responses.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::response_parts_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(ResponseData, HoldsTheExactBranchesAndThoseOfEveryMethod) {
  const std::vector<Record> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0),
                                    test::exact_response("b"), test::response_of("b", "n", 1.0, 1.0)};
  const Json data = response_data(Evaluation(records), "b");
  EXPECT_EQ(data["exact"]["record"], 2);
  EXPECT_EQ(data["exact"]["branches"][0]["w"], Json({1.0, 1.5, 2.0}));
  EXPECT_EQ(data["exact"]["branches"][0]["s"], Json({1, 0, 1}));
  EXPECT_EQ(data["exact"]["points"], Json::array({{"fold", 1.5, 0.2, 1, 1}}));
  ASSERT_EQ(data["methods"].size(), 1U);
  EXPECT_EQ(data["methods"][0]["c"], 1);  // the second of all methods
  EXPECT_EQ(data["methods"][0]["record"], 3);
  EXPECT_EQ(data["methods"][0]["steps"], false);
}

TEST(ResponseData, TellsInventedPointsAndLeavesOutThoseOfUnknownAmplitude) {
  std::vector<Record> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0)};
  records[1].response->located = {
      {.kind = SpecialKind::fold, .frequency = 1.25, .order = 1, .amplitude = 0.3},
      {.kind = SpecialKind::fold, .frequency = 1.75, .order = 1, .amplitude = 0.4},
      {.kind = SpecialKind::grazing, .frequency = 1.8, .order = 1}};
  records[1].response->comparison->invented = {{SpecialKind::fold, 1.75, 1}};
  const Json points = response_data(Evaluation(records), "a")["methods"][0]["points"];
  EXPECT_EQ(points, Json::array({{"fold", 1.25, 0.3, 1, 1}, {"fold", 1.75, 0.4, 1, 0}}));
}

TEST(ResponseData, NameTheLawWhereItIsNotTheScenes) {
  const std::vector<Record> records{test::exact_response("a"),
                                    test::of_another_law(test::response_of("a", "m", 1.0, 1.0))};
  EXPECT_EQ(response_data(Evaluation(records), "a")["methods"][0]["label"], "m, e = 1");
}

TEST(ResponseData, IsNullWithoutAnExactResponse) {
  const std::vector<Record> records{test::response_of("a", "m", 1.0, 1.0)};
  EXPECT_TRUE(response_data(Evaluation(records), "a").is_null());
  EXPECT_TRUE(response_data(Evaluation(std::vector<Record>()), "a").is_null());
}

std::string page_of(const std::vector<Record>& records) {
  const Evaluation evaluation(records);
  return html_page("t", {}, evaluation, sections_of(evaluation));
}

void expect_in_order(const std::string& page, std::initializer_list<const char*> parts) {
  std::size_t last = 0;
  for (const char* part : parts) {
    const std::size_t place = page.find(part);
    ASSERT_NE(place, std::string::npos) << part;
    EXPECT_GT(place, last) << part;
    last = place;
  }
}

TEST(PageOfResponses, ShowsTheVerdictThenTheScenesThenTheTablesThenWhereItComesFrom) {
  const std::string page = page_of({test::exact_response("a"), test::response_of("a", "m<b>", 0.5, 1.0)});
  expect_in_order(page, {"<h1>t</h1>", "1 scene, 2 cases, 2 followed", "<section id=\"response-verdict\"",
                         "id=\"scene-a\"", "data-kind=\"response\"", "Methods on a</caption>",
                         "Special points of a</caption>", "<section id=\"cases\"",
                         "<section id=\"open-ends\"", "<section id=\"about\""});
  EXPECT_EQ(page.find("<section id=\"side-by-side\""), std::string::npos);
  EXPECT_EQ(page.find("m<b>"), std::string::npos);
  EXPECT_NE(page.find("href=\"#record-2\""), std::string::npos);
}

TEST(PageOfResponses, StandBesideMotionsOfTheSameScene) {
  std::vector<Record> records{test::exact_response("s"), test::response_of("s", "m", 0.5, 1.0),
                              test::good_record("s", "n", "n=1", 1e-3, 1.0)};
  const Evaluation evaluation(records);
  EXPECT_EQ(response_data(evaluation, "s")["methods"][0]["c"], 1);  // after those of motions
  EXPECT_EQ(response_data(evaluation, "s")["methods"][0]["record"], 2);
  expect_in_order(page_of(records), {"<section id=\"verdict\"", "id=\"scene-s\"", "id=\"response-s\"",
                                     "<section id=\"cases\"", "<section id=\"about\""});
}

TEST(PageOfResponses, SaysWhyThereIsNoExactResponse) {
  Record failed = test::exact_response("a");
  failed.response->branches.clear();
  failed.message = "a & b";
  EXPECT_NE(page_of({failed}).find("left open: a &amp; b"), std::string::npos);
}

}  // namespace
}  // namespace signorini::response_parts_test
