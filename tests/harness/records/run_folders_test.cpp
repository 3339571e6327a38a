#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/records/merge.hpp"
#include "harness/records/record_store.hpp"
#include "harness/records/resume.hpp"
#include "harness/records/status.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

RunFolder part(const std::string& path, const std::vector<std::string>& resolutions) {
  RunFolder run{.path = path};
  run.manifest = {{"suite", "quick"},
                  {"date", path},
                  {"limits", {{"timeout_s", 1.0}}},
                  {"jobs", 1},
                  {"build", {{"commit", "abc"}, {"sources", {{"common", "1"}}}}},
                  {"machine", {{"cpu", "x"}, {"processors", 2}, {"load", {0.0}}}}};
  for (const std::string& resolution : resolutions) {
    run.records.push_back(test::good_record("s", "m", resolution, 0.1, 0.1));
    run.plan.push_back({run.records.back().key, run.records.back().case_id});
  }
  return run;
}

TEST(MergeRuns, HoldsEachCaseOnceInNaturalOrder) {
  const std::vector<RunFolder> parts{part("a", {"n=2", "n=10"}), part("b", {"n=1", "n=10"})};
  const RunFolder merged = merge_runs(parts);
  ASSERT_EQ(merged.records.size(), 3U);
  EXPECT_EQ(merged.records[0].case_id, "s/m[n=1]");
  EXPECT_EQ(merged.records[1].case_id, "s/m[n=2]");
  EXPECT_EQ(merged.records[2].case_id, "s/m[n=10]");
  EXPECT_EQ(merged.plan.size(), 3U);
  EXPECT_EQ(merged.manifest["shards"].size(), 2U);
  EXPECT_EQ(merged.manifest["shards"][1]["date"], "b");
}

TEST(MergeRuns, DoesNotDependOnTheOrderOfTheParts) {
  const std::vector<RunFolder> parts{part("a", {"n=2"}), part("b", {"n=1"})};
  const std::vector<RunFolder> reversed{parts[1], parts[0]};
  const auto ids = [](const RunFolder& run) {
    std::vector<std::string> found;
    for (const Record& record : run.records) found.push_back(record.case_id);
    return found;
  };
  EXPECT_EQ(ids(merge_runs(parts)), ids(merge_runs(reversed)));
}

TEST(MergeRuns, RefusesMixedMachinesLimitsAndBuilds) {
  const RunFolder first = part("a", {"n=1"});
  for (const char* place : {"/machine/cpu", "/machine/processors", "/limits/timeout_s", "/build/commit",
                            "/build/sources/common", "/suite", "/jobs"}) {
    RunFolder second = part("b", {"n=2"});
    second.manifest[nlohmann::ordered_json::json_pointer(place)] = "another";
    const std::vector<RunFolder> parts{first, second};
    try {
      merge_runs(parts);
      ADD_FAILURE() << place << " must be refused";
    } catch (const UsageError& error) {
      const std::string field = std::string(place).substr(std::string(place).rfind('/') + 1);
      EXPECT_NE(std::string(error.what()).find(field + " = \"another\" (must be"), std::string::npos)
          << error.what();
    }
  }
  RunFolder busy = part("b", {"n=2"});
  busy.manifest["machine"]["load"] = {9.0};
  const std::vector<RunFolder> parts{first, busy};
  EXPECT_NO_THROW(merge_runs(parts));
}

TEST(MergeRuns, RefusesTwoBuildsOfOnePluginAndJoinsTheOthers) {
  std::vector<RunFolder> parts{part("a", {"n=1"}), part("b", {"n=2"}), part("c", {"n=3"})};
  parts[1].manifest["plugins"] = {{"mine", "1"}};
  parts[2].manifest["plugins"] = {{"mine", "1"}, {"yours", "2"}};
  EXPECT_EQ(merge_runs(parts).manifest["plugins"].dump(), R"({"mine":"1","yours":"2"})");
  EXPECT_FALSE(merge_runs(std::vector{parts[0]}).manifest.contains("plugins"));
  parts[2].manifest["plugins"]["mine"] = "3";
  try {
    merge_runs(std::vector{parts[1], parts[2]});
    ADD_FAILURE() << "must be refused";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("plugins.mine = \"3\" (must be \"1\" as in b)"),
              std::string::npos)
        << error.what();
  }
}

TEST(MergeRuns, RefusesOneCaseOfTwoVersions) {
  RunFolder second = part("b", {"n=1"});
  second.records[0].key = "another";
  const std::vector<RunFolder> parts{part("a", {"n=1"}), second};
  EXPECT_THROW(merge_runs(parts), UsageError);
}

TEST(MergeRuns, RefusesAnIncompleteOrMixedSetOfShards) {
  std::vector<RunFolder> parts{part("a", {"n=1"}), part("b", {"n=2"})};
  parts[0].manifest["shard"] = "1/3";
  parts[1].manifest["shard"] = "2/3";
  try {
    merge_runs(parts);
    ADD_FAILURE() << "must be refused";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("without shard 3/3 (must"), std::string::npos) << error.what();
  }
  parts.push_back(part("c", {}));
  parts[2].manifest["shard"] = "3/4";
  EXPECT_THROW(merge_runs(parts), UsageError);
  parts[2].manifest["shard"] = "3/3";
  const RunFolder merged = merge_runs(parts);
  EXPECT_EQ(merged.records.size(), 2U);
  EXPECT_NO_THROW(merge_runs(std::vector{merged}));
}

TEST(JoinedPlan, KeepsTheCasesThatANarrowerRunLeavesOut) {
  const RunFolder before = part("a", {"n=1", "n=2"});
  RunFolder now = part("a", {"n=2"});
  ASSERT_EQ(joined_plan(before, now).size(), 2U);
  EXPECT_EQ(joined_plan(before, now)[1].case_id, "s/m[n=1]");
  now.plan[0].key = "of a changed scene";
  ASSERT_EQ(joined_plan(before, now).size(), 2U);
  EXPECT_EQ(joined_plan(before, now)[0].key, "of a changed scene");
  now.manifest["limits"]["timeout_s"] = 2.0;
  EXPECT_EQ(joined_plan(before, now).size(), 1U);
}

TEST(JoinedPlan, ForgetsCasesOfAPluginThatWasBuiltAnew) {
  RunFolder before = part("a", {"n=1", "n=2"});
  RunFolder now = part("a", {"n=2"});
  before.manifest["plugins"] = {{"mine", "1"}};
  EXPECT_EQ(joined_plan(before, now).size(), 2U);
  now.manifest["plugins"] = {{"yours", "2"}};
  EXPECT_EQ(joined_plan(before, now).size(), 2U);
  now.manifest["plugins"]["mine"] = "3";
  EXPECT_EQ(joined_plan(before, now).size(), 1U);
}

TEST(RequireSameMachine, RefusesAnotherOne) {
  const RunFolder before = part("a", {"n=1"});
  RunFolder now = before;
  now.manifest["limits"]["timeout_s"] = 2.0;
  EXPECT_NO_THROW(require_same_machine(before, now));
  now.manifest["machine"]["cpu"] = "y";
  EXPECT_THROW(require_same_machine(before, now), UsageError);
}

TEST(StatusOf, CountsWhatIsDoneFailedPendingAndStale) {
  RunFolder run = part("no-such-folder", {"n=1", "n=2", "n=3", "n=4"});
  run.records[0].elapsed = 2.0;
  run.records[1].elapsed = 4.0;
  run.records[1].status = Status::crashed;
  run.records.pop_back();
  run.records[2].key = "of older code";
  set_stale_aside(run);
  const RunStatus status = status_of(run);
  EXPECT_EQ(status.planned, 4U);
  EXPECT_EQ(status.converged, 1U);
  EXPECT_EQ(status.failed, 1U);
  ASSERT_EQ(status.failures.size(), 1U);
  EXPECT_EQ(status.failures[0].case_id, "s/m[n=2]");
  EXPECT_EQ(status.failures[0].status, Status::crashed);
  EXPECT_EQ(status.pending, 2U);
  EXPECT_EQ(status.stale, 1U);
  EXPECT_FALSE(status.running);
  EXPECT_NEAR(status.remaining_seconds.value(), 6.0, 1e-12);
}

TEST(StatusOf, KnowsThatARunIsUnderWay) {
  RunFolder run = part(test::fresh_folder("status").string(), {"n=1"});
  {
    const RecordStore store(run.path, true);
    EXPECT_TRUE(status_of(run).running);
  }
  EXPECT_FALSE(status_of(run).running);
}

TEST(Together, AddsCountsAndWaitsForTheSlowest) {
  RunStatus a{.planned = 3, .converged = 1, .pending = 2, .remaining_seconds = 5.0};
  RunStatus b{.planned = 2, .failed = 1, .pending = 1, .running = true, .remaining_seconds = 9.0};
  const RunStatus all = together({a, b});
  EXPECT_EQ(all.planned, 5U);
  EXPECT_EQ(all.pending, 3U);
  EXPECT_TRUE(all.running);
  EXPECT_EQ(all.remaining_seconds, 9.0);
}

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
  write_plan(folder, {{.key = "new", .case_id = "s/m[n=1]"}});
  EXPECT_EQ(read_run(folder).stale.size(), 2U);
  const std::vector<Record> records = read_current_records(folder);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].key, "new");
}

TEST(WritePlan, IsReadAgain) {
  const auto folder = test::fresh_folder("plan");
  std::ofstream(folder / "records.jsonl") << "";
  std::ofstream(folder / "manifest.json") << "{}";
  write_plan(folder, {{.key = "k1", .case_id = "s/m[n=1]"}, {.key = "k2", .case_id = "s/m[n=2]"}});
  const RunFolder run = read_run(folder);
  ASSERT_EQ(run.plan.size(), 2U);
  EXPECT_EQ(run.plan[1].key, "k2");
  EXPECT_EQ(run.plan[1].case_id, "s/m[n=2]");
}

}  // namespace
}  // namespace signorini
