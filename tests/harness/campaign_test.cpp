#include "harness/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/progress.hpp"
#include "harness/sha256.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

Plan plan_of(const std::vector<std::string>& behaviours) {
  Plan plan;
  plan.scenes.push_back(test::one_mass_scene());
  for (const std::string& behaviour : behaviours)
    plan.cases.push_back(test::fake_case(plan.scenes[0], behaviour));
  return plan;
}

Runner runner_of(const std::string& version = "v") {
  return Runner({.timeout = 0.3, .memory_mb = 1024, .repetitions = 1}, test::free_orbits(),
                [version](std::string_view) { return version; });
}

TEST(RunCampaign, LeavesOneRightRecordPerCaseWhateverTheOthersDo) {
  const Plan plan =
      plan_of({"segfault", "good", "spin", "throw_error", "lie", "not_a_number", "unsupported"});
  const auto folder = test::fresh_folder("campaign");
  Runner runner = runner_of();
  RecordStore store(folder, false);
  const CampaignResult result = run_campaign(plan, runner, store);
  EXPECT_EQ(result.ran, 7U);
  EXPECT_FALSE(result.interrupted);
  std::vector<Status> statuses;
  for (const Record& record : read_records(store.file())) statuses.push_back(record.status);
  EXPECT_EQ(statuses,
            (std::vector<Status>{Status::crashed, Status::converged, Status::timeout, Status::exception,
                                 Status::inaccurate, Status::invalid_output, Status::not_applicable}));
}

TEST(RunCampaign, ResumesExactlyWhatIsMissing) {
  const auto folder = test::fresh_folder("resume");
  Runner runner = runner_of();
  {
    RecordStore store(folder, false);
    EXPECT_EQ(run_campaign(plan_of({"good", "give_up"}), runner, store).ran, 2U);
  }
  const std::string before = read_file(folder / "records.jsonl");
  {
    RecordStore store(folder, true);
    const CampaignResult again = run_campaign(plan_of({"good", "give_up"}), runner, store);
    EXPECT_EQ(again.ran, 0U);
    EXPECT_EQ(again.present, 2U);
  }
  EXPECT_EQ(read_file(folder / "records.jsonl"), before);
  RecordStore store(folder, true);
  EXPECT_EQ(run_campaign(plan_of({"good", "throw_error", "give_up"}), runner, store).ran, 1U);
  EXPECT_EQ(read_records(store.file()).size(), 3U);
}

TEST(RunCampaign, RunsAgainWhatAnotherVersionOfTheCodeDid) {
  const auto folder = test::fresh_folder("stale");
  Runner old = runner_of("old");
  Runner fresh = runner_of("new");
  RecordStore store(folder, false);
  EXPECT_EQ(run_campaign(plan_of({"give_up"}), old, store).ran, 1U);
  EXPECT_EQ(run_campaign(plan_of({"give_up"}), fresh, store).ran, 1U);
}

TEST(RunCampaign, RunsACaseSpeltTwoWaysOnce) {
  Plan plan = plan_of({"good"});
  plan.cases.push_back(make_case(plan.scenes[0], 0, {&test::fake_catalogue().front(), {}}));
  RecordStore store(test::fresh_folder("twice"), false);
  Runner runner = runner_of();
  EXPECT_EQ(run_campaign(plan, runner, store).ran, 1U);
}

TEST(UnexpectedFailures, LeaveOutWhatIsExpectedAndWhatDoesNotApply) {
  const std::vector<Record> records = test::records_of_every_status();
  const Suite none;
  EXPECT_EQ(unexpected_failures(records, none).size(), 7U);
  Suite suite;
  suite.expected_failures = {{.case_glob = "scene-a/*[timeout]", .reason = "known"}};
  const std::vector<std::string> rest = unexpected_failures(records, suite);
  EXPECT_EQ(rest.size(), 6U);
  EXPECT_EQ(std::count(rest.begin(), rest.end(), "scene-a/method-a[timeout]"), 0);
}

TEST(ProgressLine, EstimatesTheRestFromWhatIsDone) {
  EXPECT_EQ(progress_line(0, 4, 0.0, "x"), "[0/4] 0 % x");
  EXPECT_EQ(progress_line(1, 4, 30.0, "x"), "[1/4] 25 % ETA 1:30 x");
}

}  // namespace
}  // namespace signorini
