#include "harness/run_folder/merge.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::merge_test {

namespace {

TEST(MergeRuns, HoldsEachCaseOnceInNaturalOrder) {
  const std::vector<RunFolder> parts{test::part_of_a_run("a", {"n=2", "n=10"}),
                                     test::part_of_a_run("b", {"n=1", "n=10"})};
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
  const std::vector<RunFolder> parts{test::part_of_a_run("a", {"n=2"}), test::part_of_a_run("b", {"n=1"})};
  const std::vector<RunFolder> reversed{parts[1], parts[0]};
  const auto ids = [](const RunFolder& run) {
    std::vector<std::string> found;
    for (const RecordEntry& record : run.records) found.push_back(record.case_id);
    return found;
  };
  EXPECT_EQ(ids(merge_runs(parts)), ids(merge_runs(reversed)));
}

TEST(MergeRuns, RefusesMixedMachinesLimitsAndBuilds) {
  const RunFolder first = test::part_of_a_run("a", {"n=1"});
  for (const char* place : {"/machine/cpu", "/machine/processors", "/limits/timeout_s", "/build/commit",
                            "/build/sources/common", "/suite", "/jobs"}) {
    RunFolder second = test::part_of_a_run("b", {"n=2"});
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
  RunFolder busy = test::part_of_a_run("b", {"n=2"});
  busy.manifest["machine"]["load"] = {9.0};
  const std::vector<RunFolder> parts{first, busy};
  EXPECT_NO_THROW(merge_runs(parts));
}

TEST(MergeRuns, KeepsTheWorstLoadOfItsParts) {
  std::vector<RunFolder> parts{test::part_of_a_run("a", {"n=1"}), test::part_of_a_run("b", {"n=2"})};
  EXPECT_EQ(merge_runs(parts).manifest["times_comparable"], true);
  parts[1].manifest["machine"]["load_end"] = {5.0, 1.0, 1.0};
  const nlohmann::ordered_json merged = merge_runs(parts).manifest;
  EXPECT_EQ(merged["times_comparable"], false);
  EXPECT_EQ(merged["times_not_comparable"],
            "the load average was 5 at the end, on 2 processors with 1 case at a time");
  EXPECT_EQ(merged["shards"][1]["load_end"][0], 5.0);
  EXPECT_FALSE(merged["machine"].contains("load_end"));
}

TEST(MergeRuns, RefusesTwoBuildsOfOnePluginAndJoinsTheOthers) {
  std::vector<RunFolder> parts{test::part_of_a_run("a", {"n=1"}), test::part_of_a_run("b", {"n=2"}),
                               test::part_of_a_run("c", {"n=3"})};
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
  RunFolder second = test::part_of_a_run("b", {"n=1"});
  second.records[0].key = "another";
  const std::vector<RunFolder> parts{test::part_of_a_run("a", {"n=1"}), second};
  EXPECT_THROW(merge_runs(parts), UsageError);
}

TEST(MergeRuns, RefusesAnIncompleteOrMixedSetOfShards) {
  std::vector<RunFolder> parts{test::part_of_a_run("a", {"n=1"}), test::part_of_a_run("b", {"n=2"})};
  parts[0].manifest["shard"] = "1/3";
  parts[1].manifest["shard"] = "2/3";
  try {
    merge_runs(parts);
    ADD_FAILURE() << "must be refused";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("without shard 3/3 (must"), std::string::npos) << error.what();
  }
  parts.push_back(test::part_of_a_run("c", {}));
  parts[2].manifest["shard"] = "3/4";
  EXPECT_THROW(merge_runs(parts), UsageError);
  parts[2].manifest["shard"] = "3/3";
  const RunFolder merged = merge_runs(parts);
  EXPECT_EQ(merged.records.size(), 2U);
  EXPECT_NO_THROW(merge_runs(std::vector{merged}));
}

TEST(JoinedPlan, KeepsTheCasesThatANarrowerRunLeavesOut) {
  const RunFolder before = test::part_of_a_run("a", {"n=1", "n=2"});
  RunFolder now = test::part_of_a_run("a", {"n=2"});
  ASSERT_EQ(joined_plan(before, now).size(), 2U);
  EXPECT_EQ(joined_plan(before, now)[1].case_id, "s/m[n=1]");
  now.plan[0].key = "of a changed scene";
  ASSERT_EQ(joined_plan(before, now).size(), 2U);
  EXPECT_EQ(joined_plan(before, now)[0].key, "of a changed scene");
  now.manifest["limits"]["timeout_s"] = 2.0;
  EXPECT_EQ(joined_plan(before, now).size(), 1U);
}

TEST(JoinedPlan, ForgetsCasesOfAPluginThatWasBuiltAnew) {
  RunFolder before = test::part_of_a_run("a", {"n=1", "n=2"});
  RunFolder now = test::part_of_a_run("a", {"n=2"});
  before.manifest["plugins"] = {{"mine", "1"}};
  EXPECT_EQ(joined_plan(before, now).size(), 2U);
  now.manifest["plugins"] = {{"yours", "2"}};
  EXPECT_EQ(joined_plan(before, now).size(), 2U);
  now.manifest["plugins"]["mine"] = "3";
  EXPECT_EQ(joined_plan(before, now).size(), 1U);
}

TEST(RequireSameMachine, RefusesAnotherOne) {
  const RunFolder before = test::part_of_a_run("a", {"n=1"});
  RunFolder now = before;
  now.manifest["limits"]["timeout_s"] = 2.0;
  EXPECT_NO_THROW(require_same_machine(before, now));
  now.manifest["machine"]["cpu"] = "y";
  EXPECT_THROW(require_same_machine(before, now), UsageError);
}

}  // namespace

}  // namespace signorini::merge_test
