#include "harness/records/record_json.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "harness/files.hpp"
#include "harness/records/record_check.hpp"
#include "tests/harness/responses/sample_responses.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::record_json_test {
namespace {

using Json = nlohmann::ordered_json;
using Keys = std::set<std::string>;

Keys keys(const Json& json) {
  Keys found;
  for (const auto& [key, value] : json.items()) found.insert(key);
  return found;
}

TEST(RecordJson, HasExactlyTheKeysOfTheContract) {
  const Json json = to_json(test::full_record());
  EXPECT_EQ(keys(json), (Keys{"schema",       "case",
                              "key",          "scene",
                              "scene_sha256", "method",
                              "plugin",       "settings",
                              "options",      "same_equations_as",
                              "status",       "message",
                              "signal",       "law",
                              "scene_law",    "law_matches_scene",
                              "coordinates",  "contacts",
                              "problem",      "period",
                              "residual",     "condition",
                              "work",         "seconds",
                              "not_timed",    "answer",
                              "repeats",      "elapsed",
                              "processor",    "certificate",
                              "errors",       "physics",
                              "trajectory",   "waveforms",
                              "motion"}));
  EXPECT_EQ(keys(json["work"]), (Keys{"unknowns", "iterations", "pivots", "rhs_evaluations", "factorisations",
                                      "points", "peak_memory_bytes"}));
  EXPECT_EQ(keys(json["seconds"]), (Keys{"median", "min", "mad", "repetitions", "setup", "solve", "first",
                                         "unstable", "rounds", "jobs", "unsteady", "load", "exchange"}));
  EXPECT_EQ(keys(json["certificate"]),
            (Keys{"status", "rule", "reason", "source", "orbit", "order", "error_bar", "residual", "distance",
                  "reference", "reference_reason", "same_orbit", "events", "floquet", "stable"}));
  EXPECT_EQ(keys(json["processor"]), (Keys{"solve", "timing", "measures", "certificate"}));
  EXPECT_EQ(keys(json["certificate"]["events"][0]), (Keys{"time", "contact", "kind", "value"}));
  EXPECT_EQ(keys(json["errors"]), (Keys{"x_l2", "x_max", "u_l2", "velocity_l2", "impulse", "force_l2",
                                        "x_l2_scene", "x_worst", "force"}));
  EXPECT_EQ(keys(json["physics"]), (Keys{"penetration", "complementarity", "energy_defect", "energy_reason",
                                         "effective_restitution", "contact_ratio"}));
  EXPECT_EQ(keys(json["trajectory"]),
            (Keys{"t", "x", "velocity", "force", "impulses", "bandwidth", "events", "dofs", "u"}));
  EXPECT_EQ(keys(json["trajectory"]["events"][0]), (Keys{"kind", "contact", "time", "impulse"}));
  EXPECT_EQ(keys(json["motion"]), (Keys{"x", "u", "no_u", "impacts", "contact_phases"}));
  EXPECT_EQ(keys(json["motion"]["u"][0]), (Keys{"dof", "mean", "min", "max", "amplitude", "harmonics"}));
  EXPECT_EQ(keys(json["motion"]["u"][0]["harmonics"][0]), (Keys{"frequency", "amplitude", "phase"}));
  EXPECT_EQ(keys(json["motion"]["impacts"][0]),
            (Keys{"contact", "time", "speed_before", "speed_after", "impulse"}));
  EXPECT_EQ(keys(json["motion"]["contact_phases"][0]), (Keys{"contact", "begin", "end", "impulse"}));
  EXPECT_EQ(keys(json["waveforms"]), (Keys{"contacts", "answer", "orbit"}));
  EXPECT_EQ(keys(json["waveforms"]["answer"]), (Keys{"t", "x", "velocity", "force", "impulse"}));
  EXPECT_EQ(keys(json["waveforms"]["orbit"]), (Keys{"t", "x", "velocity", "force", "impulse"}));
  EXPECT_EQ(keys(json["trajectory"]["impulses"][0]), (Keys{"contact", "time", "value"}));
}

Record response_record() {
  Record record = test::response_of("s", "m", 0.5, 1.0);
  record.scene_sha256 = "h";
  RecordedResponse& response = *record.response;
  response.comparison->close.covered_stable = 0.75;
  response.comparison->invented = {{SpecialKind::neimark_sacker, 1.75, 1}};
  response.open_ends = {"the time is up"};
  return record;
}

TEST(RecordJson, HasTheOrdersOfSimultaneousImpacts) {
  Record record = test::full_record();
  record.certificate.stable.reset();
  record.certificate.stability = "undefined";
  record.certificate.undefined = "depends";
  record.certificate.orders = {{.contacts = {{0, 1}, {2, 0}}, .largest = 0.5}};
  const Json json = to_json(record);
  EXPECT_EQ(json["certificate"]["stability"], "undefined");
  EXPECT_EQ(json["certificate"]["stability_reason"], "depends");
  EXPECT_FALSE(json["certificate"].contains("stable"));
  EXPECT_EQ(json["certificate"]["orders"][0]["contacts"][1][0], 2);
  EXPECT_EQ(to_json(record_from_json(Json::parse(json_line(json)))), json);
}

TEST(RecordJson, OfAResponseHasExactlyTheKeysOfTheContract) {
  const Json response = to_json(response_record())["response"];
  EXPECT_EQ(keys(response), (Keys{"way", "from", "to", "orders", "points", "comparison", "located",
                                  "open_ends", "branches"}));
  EXPECT_EQ(keys(response["comparison"]), (Keys{"within_0.02", "within_0.05", "exact_length", "length",
                                                "right_length", "points", "invented"}));
  EXPECT_EQ(keys(response["comparison"]["within_0.02"]), (Keys{"covered", "covered_stable", "false"}));
  EXPECT_EQ(keys(response["branches"][0]), (Keys{"omega", "amplitude", "stable"}));
  EXPECT_EQ(keys(response["located"][0]), (Keys{"kind", "omega", "order", "amplitude"}));
}

TEST(RecordJson, OfAResponseComesBackAsItWent) {
  const Json json = to_json(response_record());
  const Record back = checked_record(json);
  EXPECT_EQ(to_json(back), json);
  EXPECT_EQ(back.response->comparison->invented[0].kind, SpecialKind::neimark_sacker);
  EXPECT_FALSE(back.response->comparison->invented[0].amplitude.has_value());
  EXPECT_FALSE(record_from_json(to_json(test::full_record())).response.has_value());
  Json wrong = json;
  wrong["response"]["way"] = "by magic";
  EXPECT_THROW(checked_record(wrong), BadRecord);
}

TEST(RecordJson, ComesBackAsItWent) {
  const Json json = to_json(test::full_record());
  EXPECT_EQ(to_json(record_from_json(json)), json);
  EXPECT_EQ(to_json(record_from_json(Json::parse(json.dump()))), json);
}

TEST(RecordJson, ComesBackAsItWentForEveryStatusAndLaw) {
  for (const Record& record : test::records_of_every_status()) {
    const Json json = to_json(record);
    EXPECT_EQ(to_json(record_from_json(Json::parse(json.dump()))), json) << json.dump();
  }
  for (const RepresentedLaw& law : std::vector<RepresentedLaw>{
           Restitution{0.25}, Penalty{{1.0, 2.0}}, Massless{}, Undetermined{}, std::monostate{},
           MixedLaws{{Restitution{0.5}, Spring{2.0}, Massless{}}}}) {
    EXPECT_EQ(JsonForm<RepresentedLaw>::read(JsonForm<RepresentedLaw>::write(law)).index(), law.index());
  }
  EXPECT_EQ(JsonForm<RepresentedLaw>::write(Restitution{0.8}).dump(), R"({"restitution":0.8})");
  EXPECT_EQ(JsonForm<RepresentedLaw>::write(Penalty{{1.5}}).dump(), R"({"penalty":[1.5]})");
  EXPECT_EQ(JsonForm<RepresentedLaw>::write(Massless{}).dump(), R"({"massless":true})");
  const RepresentedLaw mixed = MixedLaws{{Restitution{0.5}, Spring{2.0}, Massless{}}};
  const Json written = JsonForm<RepresentedLaw>::write(mixed);
  EXPECT_EQ(written.dump(), R"({"mixed":[{"restitution":0.5},{"penalty":2.0},{"massless":true}]})");
  EXPECT_EQ(std::get<MixedLaws>(JsonForm<RepresentedLaw>::read(written)).laws,
            std::get<MixedLaws>(mixed).laws);
}

TEST(RecordJson, LeavesOutWhatDoesNotExist) {
  Record record;
  record.scene = "s";
  record.method = "m";
  record.errors.x_l2 = std::numeric_limits<double>::quiet_NaN();
  record.period = std::numeric_limits<double>::infinity();
  const Json json = to_json(record);
  EXPECT_EQ(keys(json),
            (Keys{"schema", "scene", "scene_sha256", "method", "options", "status", "certificate"}));
  EXPECT_EQ(json.dump().find("null"), std::string::npos);
}

TEST(RecordJson, KeepsTheKindOfAnOption) {
  Record record;
  record.options = {{"a", true}, {"b", 3L}, {"c", 3.0}, {"d", std::string("x")}, {"e", std::monostate{}}};
  const Record back = record_from_json(Json::parse(to_json(record).dump()));
  EXPECT_EQ(back.options, record.options);
}

TEST(RecordJson, CompletesTheSettingsOfEarlierVersionsFromTheName) {
  Json json = to_json(test::full_record());
  EXPECT_EQ(json["settings"].dump(), R"({"n":"1"})");
  json.erase("settings");
  EXPECT_EQ(record_from_json(json).settings, (Settings{{"n", "1"}}));
  json["case"] = "scene-a/method-a";
  EXPECT_TRUE(record_from_json(json).settings.empty());
  json["case"] = "scene-a/method-a[n=2]";
  json["settings"] = {{"n", "3"}};
  EXPECT_EQ(record_from_json(json).settings, (Settings{{"n", "3"}})) << "the field, not the name";
}

TEST(RecordJson, ReadsAndWritesTheCommittedRecordsByteByByte) {
  const std::filesystem::path results = test::data_folder() / "../../results";
  std::size_t records = 0;
  for (const auto& folder : std::filesystem::directory_iterator(results)) {
    const std::filesystem::path file = folder.path() / "records.jsonl";
    if (!std::filesystem::exists(file)) continue;
    std::istringstream lines(read_file(file));
    for (std::string line; std::getline(lines, line); ++records) {
      const Record record = record_from_json(Json::parse(line));
      Json json = to_json(record);
      // A setting that an older program did not write is added; nothing else may change.
      if (!Json::parse(line).contains("settings")) json.erase("settings");
      ASSERT_EQ(json.dump(), line) << file << ", record " << records + 1;
      const std::string way = !record.response                                      ? ""
                              : record.response->question.way == ResponseWay::steps ? " by steps"
                                                                                    : " by arc length";
      const bool exact = record.response && record.response->question.way == ResponseWay::exact;
      ASSERT_EQ(record.scene + "/" + (exact ? "exact response" : resolution_of(record) + way),
                record.case_id);
    }
  }
  EXPECT_GT(records, 1000U);
}

TEST(RecordJson, RefusesWhatIsNoRecord) {
  EXPECT_THROW(record_from_json(Json::parse("{}")), BadRecord);
  Json json = to_json(test::full_record());
  json["schema"] = 99;
  EXPECT_THROW(record_from_json(json), BadRecord);
  json = to_json(test::full_record());
  json["status"] = "splendid";
  EXPECT_THROW(record_from_json(json), BadRecord);
}

}  // namespace
}  // namespace signorini::record_json_test
