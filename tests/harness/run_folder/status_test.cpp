#include "harness/run_folder/status.hpp"

#include <gtest/gtest.h>

#include "harness/run_folder/record_store.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::status_test {
namespace {

TEST(StatusOf, CountsWhatIsDoneFailedPendingAndStale) {
  RunFolder run = test::part_of_a_run("no-such-folder", {"n=1", "n=2", "n=3", "n=4"});
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
  RunFolder run = test::part_of_a_run(test::fresh_folder("status").string(), {"n=1"});
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

}  // namespace
}  // namespace signorini::status_test
