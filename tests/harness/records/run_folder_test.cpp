#include "harness/records/run_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "harness/failure.hpp"
#include "harness/records/merge.hpp"
#include "harness/records/record_json.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
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

}  // namespace
}  // namespace signorini
