#include "harness/responses/response_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/harness/responses/sample_responses.hpp"

namespace signorini::response_page_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(ResponseData, HoldsTheExactBranchesAndThoseOfEveryMethod) {
  const std::vector<ResponseRecord> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0),
                                            test::exact_response("b"), test::response_of("b", "n", 1.0, 1.0)};
  const Json data = response_data(records, "b");
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
  std::vector<ResponseRecord> records{test::exact_response("a"), test::response_of("a", "m", 1.0, 1.0)};
  records[1].located = {{.kind = SpecialKind::fold, .frequency = 1.25, .order = 1, .amplitude = 0.3},
                        {.kind = SpecialKind::fold, .frequency = 1.75, .order = 1, .amplitude = 0.4},
                        {.kind = SpecialKind::grazing, .frequency = 1.8, .order = 1}};
  records[1].comparison->invented = {{SpecialKind::fold, 1.75, 1}};
  const Json points = response_data(records, "a")["methods"][0]["points"];
  EXPECT_EQ(points, Json::array({{"fold", 1.25, 0.3, 1, 1}, {"fold", 1.75, 0.4, 1, 0}}));
}

TEST(ResponseData, IsNullWithoutAnExactResponse) {
  EXPECT_TRUE(response_data(std::vector{test::response_of("a", "m", 1.0, 1.0)}, "a").is_null());
  EXPECT_TRUE(response_data({}, "a").is_null());
}

TEST(ResponsePage, ShowsTheVerdictThenTheScenesThenTheTablesThenWhereItComesFrom) {
  const std::vector<ResponseRecord> records{test::exact_response("a"),
                                            test::response_of("a", "m<b>", 0.5, 1.0)};
  const std::string page = response_page("t", {}, records);
  std::size_t last = 0;
  for (const char* part :
       {"<h1>t</h1>", "Frequency responses: 1 method of 1 scene", "id=\"verdict\"", "id=\"scene-a\"",
        "data-kind=\"response\"", "Methods on a</caption>", "Special points of a</caption>", "id=\"cases\"",
        "id=\"open-ends\"", "id=\"about\""}) {
    const std::size_t place = page.find(part);
    ASSERT_NE(place, std::string::npos) << part;
    EXPECT_GT(place, last) << part;
    last = place;
  }
  EXPECT_EQ(page.find("m<b>"), std::string::npos);
  EXPECT_NE(page.find("href=\"#record-2\""), std::string::npos);
}

TEST(ResponsePage, IsWholeWhereNothingIsKnown) {
  const std::string page = response_page("t", {}, {});
  EXPECT_NE(page.find("No method was compared with an exact response."), std::string::npos);
  ResponseRecord failed = test::exact_response("a");
  failed.branches.clear();
  failed.message = "a & b";
  EXPECT_NE(response_page("t", {}, std::vector{failed}).find("left open: a &amp; b"), std::string::npos);
}

}  // namespace
}  // namespace signorini::response_page_test
