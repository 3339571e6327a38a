#include "harness/run_folder/run_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/build_info.hpp"
#include "harness/failure.hpp"
#include "harness/records/record_json.hpp"
#include "harness/run_folder/merge.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::run_folder_test {

namespace {

TEST(ReadRun, RefusesWhatNoRunWrote) {
  const auto folder = test::fresh_folder("no-run");
  EXPECT_THROW(read_run(folder), UsageError);
  std::ofstream(folder / "records.jsonl") << "";
  std::ofstream(folder / "manifest.json") << "{ nonsense";
  EXPECT_THROW(read_run(folder), UsageError);
  std::ofstream(folder / "manifest.json") << "{}";
  EXPECT_NO_THROW(read_run(folder));
  std::ofstream(folder / "plan.txt") << "nonsense\n";
  EXPECT_THROW(read_run(folder), UsageError);
}

/// A folder with a record of older code and one of newer of n=1, and one of n=2.
std::filesystem::path resumed_folder() {
  const auto folder = test::fresh_folder("resumed");
  std::ofstream(folder / "manifest.json") << "{}";
  std::ofstream records(folder / "records.jsonl");
  for (const auto& [resolution, key] : {std::pair{"n=1", "old"}, {"n=2", "other"}, {"n=1", "new"}}) {
    Record record = test::good_record("s", "m", resolution, 0.1, 0.1);
    record.key = key;
    records << to_json(record).dump() << "\n";
  }
  return folder;
}

TEST(ReadRun, CountsTheLastRecordOfACaseWhereThereIsNoPlan) {
  const RunFolder run = read_run(resumed_folder());
  ASSERT_EQ(run.records.size(), 2U);
  EXPECT_EQ(run.records[0].key, "other");
  EXPECT_EQ(run.records[1].key, "new");
  ASSERT_EQ(run.stale.size(), 1U);
  EXPECT_EQ(run.stale[0].key, "old");
  EXPECT_NO_THROW(merge_runs(std::vector{run}));
}

TEST(ReadRun, CountsOnlyRecordsOfThePlan) {
  const auto folder = resumed_folder();
  write_plan(folder, {{.key = "new", .case_id = "s/m[n=1]", .method = "m"}});
  EXPECT_EQ(read_run(folder).stale.size(), 2U);
  const std::vector<Record> records = read_current_records(folder);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].key, "new");
}

TEST(WritePlan, IsReadAgain) {
  const auto folder = test::fresh_folder("plan");
  std::ofstream(folder / "records.jsonl") << "";
  std::ofstream(folder / "manifest.json") << "{}";
  write_plan(folder, {{.key = "k1", .case_id = "s/m[n=1]", .method = "m"},
                      {.key = "k2", .case_id = "s/m[n=2]", .method = "m"}});
  const RunFolder run = read_run(folder);
  ASSERT_EQ(run.plan.size(), 2U);
  EXPECT_EQ(run.plan[1].key, "k2");
  EXPECT_EQ(run.plan[1].case_id, "s/m[n=2]");
  EXPECT_EQ(run.plan[1].method, "m");
}

TEST(Manifest, SaysWhatTheRecordsComeFrom) {
  const Limits limits{.timeout = 2.5, .memory_mb = 64, .repetitions = 7};
  const auto manifest = make_manifest({.name = "quick"}, limits, {.seed = 42}, {"signorini", "run"});
  EXPECT_EQ(manifest.at("schema"), 1);
  EXPECT_EQ(manifest.at("suite"), "quick");
  EXPECT_EQ(manifest.at("seed"), 42);
  EXPECT_EQ(manifest.at("command_line"), (std::vector<std::string>{"signorini", "run"}));
  EXPECT_EQ(manifest.at("limits").at("timeout_s"), 2.5);
  EXPECT_EQ(manifest.at("limits").at("memory_mb"), 64);
  EXPECT_EQ(manifest.at("limits").at("repetitions"), 7);
  EXPECT_EQ(manifest.at("build").at("version"), build_info().version);
  EXPECT_EQ(manifest.at("build").at("sources").size(), build_info().sources.size());
  EXPECT_TRUE(manifest.at("build").at("sources").contains("common"));
  EXPECT_GE(manifest.at("machine").at("processors").get<int>(), 1);
  // "2026-11-22T15:00:00Z"
  const auto date = manifest.at("date").get<std::string>();
  EXPECT_EQ(date.size(), 20U);
  EXPECT_EQ(date.back(), 'Z');
}

TEST(Manifest, ComparesNoTimesOfCasesThatRanSideBySide) {
  const auto comparable = [](const Schedule& schedule) {
    return make_manifest({}, {}, schedule, {}).at("times_comparable").get<bool>();
  };
  EXPECT_TRUE(build_may_be_timed() || !comparable({}));
  EXPECT_FALSE(comparable({.parallel = 2}));
  EXPECT_FALSE(comparable({.beside = 2}));
  EXPECT_EQ(make_manifest({}, {}, {.parallel = 3, .beside = 2}, {}).at("jobs"), 6);
}

TEST(ClockGovernor, IsThatOfTheFirstProcessorOrEmpty) {
  const auto root = test::fresh_folder("governor");
  EXPECT_EQ(clock_governor(root), "");
  const auto folder = root / "sys/devices/system/cpu/cpu0/cpufreq";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scaling_governor") << "powersave\n";
  EXPECT_EQ(clock_governor(root), "powersave");
}

}  // namespace

}  // namespace signorini::run_folder_test
