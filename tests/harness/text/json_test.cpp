// JSON from text and to text: what is no JSON, bytes that are no text, indentation.

#include "harness/text/json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace signorini::json_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(Json, KeepsTheOrderOfKeysThroughItsText) {
  const std::string text = R"({"b":[1,2.5,"c"],"a":null})";
  EXPECT_EQ(json_text(parse_json(text)), text);
  EXPECT_EQ(json_line(parse_json(text)), text);
  EXPECT_EQ(json_text(Json{{"b", 1}}, 2), "{\n  \"b\": 1\n}");
}

TEST(Json, RefusesWhatIsNone) {
  for (const char* text : {"", "{", "{} {}", "nul"}) {
    EXPECT_THROW(parse_json(text), Json::parse_error) << text;
    EXPECT_TRUE(try_parse_json(text).is_discarded()) << text;
  }
}

TEST(Json, WritesBytesThatAreNoTextOnlyInALine) {
  const Json json = "a\xff";
  EXPECT_THROW(json_text(json), Json::type_error);
  EXPECT_EQ(json_line(json), "\"a\xef\xbf\xbd\"");
}

}  // namespace
}  // namespace signorini::json_test
