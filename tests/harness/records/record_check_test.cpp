#include "harness/records/record_check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "harness/records/record_json.hpp"
#include "tests/harness/responses/sample_responses.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::record_check_test {
namespace {

using Json = nlohmann::ordered_json;

std::string complaint(const std::function<void(Json&)>& edit) {
  Json json = to_json(test::good_record("sdof-stop", "hat-lcp", "samples=64", 0.1, 0.1));
  edit(json);
  try {
    checked_record(json);
    return "";
  } catch (const BadRecord& error) {
    return error.what();
  }
}

TEST(RecordCheck, TakesWhatRunWrites) {
  EXPECT_EQ(complaint([](Json&) {}), "");
  EXPECT_EQ(complaint([](Json& json) { json["scene"] = "grazing-e08@1e-4"; }), "");
  EXPECT_EQ(complaint([](Json& json) { json["message"] = "‖x‖ = 3 µm; it's \"so\" & <b>"; }), "");
}

TEST(RecordCheck, RefusesBranchesThatCannotBeDrawn) {
  Record record = test::exact_response("s");
  record.scene_sha256 = "h";
  EXPECT_NO_THROW(checked_record(to_json(record)));
  record.response->branches[0].stable.pop_back();
  EXPECT_THROW(checked_record(to_json(record)), BadRecord);
}

TEST(RecordCheck, RefusesNamesThatLeadElsewhere) {
  for (const char* scene :
       {"../../etc/x", "a'.system('touch x').'", "a b", "", "A", "a@", "a@../x", "-a", "a\nb"})
    EXPECT_NE(complaint([&](Json& json) { json["scene"] = scene; }), "") << scene;
  for (const char* method : {"../m", "m'", "", "m\tn"})
    EXPECT_NE(complaint([&](Json& json) { json["method"] = method; }), "") << method;
}

TEST(RecordCheck, RefusesControlCharactersAndEndlessTextsWhereverTheyStand) {
  EXPECT_EQ(complaint([](Json& json) { json["message"] = "a\x1b[31m"; }),
            "text = a\\x1b[31m (must be at most 4000 bytes without control characters)");
  EXPECT_NE(complaint([](Json& json) { json["options"]["word"] = "x\ny"; }), "");
  EXPECT_NE(complaint([](Json& json) { json["settings"]["a\nb"] = "1"; }), "");
  EXPECT_NE(complaint([](Json& json) { json["case"] = std::string(5000, 'x'); }), "");
  EXPECT_NE(complaint([](Json& json) { json["certificate"]["reason"] = "\x7f"; }), "");
}

TEST(RecordCheck, RefusesWhatNestsWithoutEnd) {
  constexpr int kLevels = 200000;
  Json deep = "x";
  for (int i = 0; i < kLevels; ++i) deep = Json::array({std::move(deep)});
  EXPECT_EQ(complaint([&](Json& json) { json["unknown"] = std::move(deep); }),
            "value = nested (must be at most 32 levels deep)");
}

TEST(RecordCheck, RefusesNumbersThatNoRunGives) {
  EXPECT_EQ(complaint([](Json& json) { json["errors"]["x_l2"] = -0.1; }),
            "errors.x_l2 = -0.1 (must be 0 or more)");
  EXPECT_EQ(complaint([](Json& json) { json["work"]["pivots"] = -3; }),
            "work.pivots = -3 (must be 0 or more)");
  EXPECT_NE(complaint([](Json& json) { json["period"] = 0.0; }), "");
}

TEST(Message, IsOneLineOfSomeThousandBytes) {
  EXPECT_EQ(as_message("a\nb\x1b"), "a\\nb\\x1b");
  EXPECT_EQ(as_message(std::string(5U << 20U, 'x')), std::string(1000, 'x') + "...");
  EXPECT_EQ(as_message(as_message(std::string(5000, 'x'))), as_message(std::string(5000, 'x')));
}

}  // namespace
}  // namespace signorini::record_check_test
