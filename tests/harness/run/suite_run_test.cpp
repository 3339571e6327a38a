#include "harness/run/suite_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "harness/build_info.hpp"
#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "methods/plugin/sanitizer.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::suite_run_test {

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

std::map<std::string, Record> records_by_case(const RecordStore& store) {
  std::map<std::string, Record> records;
  for (const Record& record : read_records(store.file())) {
    EXPECT_FALSE(records.contains(record.case_id)) << "twice: " << record.case_id;
    records[record.case_id] = record;
  }
  return records;
}

/// What does not depend on the clock or on memory.
std::string timeless(Record record) {
  record.seconds.reset();
  record.elapsed.reset();
  record.processor = {};
  record.work.peak_memory_bytes.reset();
  return to_json(record).dump();
}

TEST(RunPlan, LeavesOneRightRecordPerCaseWhateverTheOthersDo) {
  const std::map<std::string, Status> expected{{"segfault", Status::crashed},
                                               {"spin", Status::timeout},
                                               {"allocate", Status::out_of_memory},
                                               {"throw_error", Status::exception},
                                               {"lie", Status::inaccurate},
                                               {"not_a_number", Status::invalid_output},
                                               {"unsupported", Status::not_applicable}};
  Plan plan;
  plan.scenes.push_back(test::one_mass_scene());
  Plan healthy = plan;
  int level = 0;
  for (const auto& [behaviour, status] : expected) {
    plan.cases.push_back(test::fake_case(plan.scenes[0], behaviour));
    const Case good = make_case(
        plan.scenes[0], 0,
        {&test::fake_catalogue().front(), {{"behaviour", "good"}, {"level", std::to_string(++level)}}});
    plan.cases.push_back(good);
    healthy.cases.push_back(good);
  }
  // Long enough to touch 256 MiB on a slow machine, which takes a second.
  Runner runner({.timeout = 5.0, .memory_mb = 256, .repetitions = 2}, test::free_orbits());
  RecordStore store(test::fresh_folder("suite-run"), false);
  const Schedule planned_rounds{.more_rounds = 0};
  const SuiteRunResult result = run_plan(plan, runner, store, planned_rounds);
  EXPECT_EQ(result.ran, 14U);
  EXPECT_FALSE(result.interrupted);
  RecordStore quiet(test::fresh_folder("suite-run-healthy"), false);
  run_plan(healthy, runner, quiet, planned_rounds);

  const auto records = records_by_case(store);
  ASSERT_EQ(records.size(), 14U);
  for (const auto& [behaviour, status] : expected) {
    if (kAddressSanitizer && behaviour == "allocate") continue;  // it needs the address space itself
    const Record& record = records.at("one-mass/fake-method[behaviour=" + behaviour + "]");
    EXPECT_EQ(status_name(record.status), status_name(status)) << behaviour << ": " << record.message;
  }
  for (const auto& [id, record] : records_by_case(quiet)) {
    EXPECT_EQ(record.status, Status::converged);
    EXPECT_EQ(timeless(records.at(id)), timeless(record)) << "touched by the others";
  }
}

TEST(RunPlan, KeepsNothingUnfinishedOnceAllIsComplete) {
  const auto folder = test::fresh_folder("finished");
  Runner runner({.timeout = 1.0, .memory_mb = 1024, .repetitions = 3}, test::free_orbits());
  {
    RecordStore store(folder, false);
    EXPECT_EQ(run_plan(plan_of({"good", "give_up"}), runner, store).ran, 2U);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "unfinished.jsonl"));
}

TEST(RunPlan, ResumesExactlyWhatIsMissing) {
  const auto folder = test::fresh_folder("resume");
  Runner runner = runner_of();
  {
    RecordStore store(folder, false);
    EXPECT_EQ(run_plan(plan_of({"good", "give_up"}), runner, store).ran, 2U);
  }
  const std::string before = read_file(folder / "records.jsonl");
  {
    RecordStore store(folder, true);
    const SuiteRunResult again = run_plan(plan_of({"good", "give_up"}), runner, store);
    EXPECT_EQ(again.ran, 0U);
    EXPECT_EQ(again.present, 2U);
  }
  EXPECT_EQ(read_file(folder / "records.jsonl"), before);
  RecordStore store(folder, true);
  EXPECT_EQ(run_plan(plan_of({"good", "throw_error", "give_up"}), runner, store).ran, 1U);
  EXPECT_EQ(read_records(store.file()).size(), 3U);
}

TEST(RunPlan, TakesACaseForDoneWhoseRoundsWereAllKept) {
  const auto folder = test::fresh_folder("suite-run-kept");
  const Plan plan = plan_of({"good", "lie"});
  Runner runner = runner_of();
  {
    RecordStore store(folder, false);
    run_plan(plan, runner, store);
  }
  std::filesystem::rename(folder / "records.jsonl", folder / "unfinished.jsonl");
  RecordStore store(folder, true);
  run_plan(plan, runner, store);
  EXPECT_EQ(records_by_case(store).size(), 2U);
}

TEST(RunPlan, RunsAgainWhatAnotherVersionOfTheCodeDid) {
  const auto folder = test::fresh_folder("stale");
  Runner old = runner_of("old");
  Runner fresh = runner_of("new");
  RecordStore store(folder, false);
  EXPECT_EQ(run_plan(plan_of({"give_up"}), old, store).ran, 1U);
  EXPECT_EQ(run_plan(plan_of({"give_up"}), fresh, store).ran, 1U);
}

TEST(RunPlan, HandsOverTheRecordsOfASceneInTheOrderOfThePlan) {
  const Plan plan = plan_of({"good", "give_up", "throw_error"});
  RecordStore store(test::fresh_folder("told"), false);
  Runner runner = runner_of();
  std::vector<std::string> told;
  run_plan(plan, runner, store, {}, [&](const std::vector<Record>& records) {
    for (const Record& record : records) told.push_back(record.case_id);
  });
  std::vector<std::string> planned;
  for (const Case& planned_case : plan.cases) planned.push_back(planned_case.id);
  EXPECT_EQ(told, planned);
}

TEST(RunPlan, RunsACaseSpeltTwoWaysOnce) {
  Plan plan = plan_of({"good"});
  plan.cases.push_back(make_case(plan.scenes[0], 0, {&test::fake_catalogue().front(), {}}));
  RecordStore store(test::fresh_folder("twice"), false);
  Runner runner = runner_of();
  EXPECT_EQ(run_plan(plan, runner, store).ran, 1U);
}

TEST(IsUnexpected, LeavesOutWhatIsExpectedAndWhatDoesNotApply) {
  const std::vector<Record> records = test::records_of_every_status();
  const auto unexpected = [&](const Suite& suite) {
    return std::ranges::count_if(
        records, [&](const Record& record) { return is_unexpected(record.case_id, record.status, suite); });
  };
  EXPECT_EQ(unexpected({}), 7);
  Suite suite;
  suite.expected_failures = {{.case_glob = "scene-a/*[ends=timeout]", .reason = "known"}};
  EXPECT_EQ(unexpected(suite), 6);
  EXPECT_FALSE(is_unexpected("scene-a/method-a[ends=timeout]", Status::timeout, suite));
}

constexpr Limits kThreeRounds{.timeout = 2.0,
                              .memory_mb = 1024,
                              .repetitions = 3,
                              .certificate_timeout = 5.0,
                              .reference_timeout = 5.0};

/// What became of cases "behaviour=good,level=k" for k = 1..count on the scene of one mass.
class Rounds : public testing::Test {
 protected:
  void add(const std::string& behaviour, const std::string& level) {
    cases_.push_back(make_case(
        scene_, 0, {&test::fake_catalogue().front(), {{"behaviour", behaviour}, {"level", level}}}));
  }

  /// With the rounds planned alone, whatever times come out, unless `more` are allowed.
  void run(Schedule schedule, std::vector<std::optional<Record>> begun = {}, int more = 0) {
    schedule.more_rounds = more;
    Runner runner(limits_, test::free_orbits(), [](std::string_view) { return std::string("v"); });
    const std::vector<Job> jobs = runner.make_jobs(scene_, cases_);
    runner.compute_references(scene_, jobs);
    begun.resize(cases_.size());
    const RoundObserver observer{
        .begins = [&](const std::string& what) { begun_.push_back(what); },
        .round_done = [&](std::size_t i, const Record& record) { unfinished_[i].push_back(record); },
        .case_done =
            [&](std::size_t i, const Record& record) {
              EXPECT_FALSE(complete_.contains(i)) << "told twice";
              complete_[i] = record;
            }};
    const auto records = run_rounds(runner, scene_, jobs, begun, schedule, observer);
    ASSERT_EQ(records.size(), complete_.size());
    for (const auto& [index, record] : complete_) EXPECT_EQ(records[index].value().case_id, record.case_id);
  }

  Limits limits_ = kThreeRounds;
  /// Where nothing is timed, the first round of a case is the only one.
  const bool timed_ = build_may_be_timed();
  const std::size_t rounds_ = timed_ ? 3 : 1;
  Scene scene_ = test::one_mass_scene();
  std::vector<Case> cases_;
  std::vector<std::string> begun_;
  std::map<std::size_t, std::vector<Record>> unfinished_;
  std::map<std::size_t, Record> complete_;
};

TEST_F(Rounds, ComeRoundByRoundAndNotCaseByCase) {
  for (const char* level : {"1", "2", "3", "4"}) add("good", level);
  run({});
  ASSERT_EQ(begun_.size(), 4 * rounds_);
  for (std::size_t round = 0; round < rounds_; ++round) {
    const auto first = begun_.begin() + static_cast<std::ptrdiff_t>(4 * round);
    EXPECT_EQ(std::set(first, first + 4).size(), 4U) << "round " << round;
  }
  if (timed_) {
    EXPECT_NE(std::vector(begun_.begin(), begun_.begin() + 4),
              std::vector(begun_.begin() + 4, begun_.begin() + 8));
  }
  ASSERT_EQ(complete_.size(), 4U);
  for (const auto& [index, record] : complete_) {
    EXPECT_EQ(record.case_id, cases_[index].id);
    EXPECT_EQ(record.status, Status::converged) << record.message;
    EXPECT_GT(record.elapsed.value(), 0.0);
    EXPECT_EQ(record.certificate.status, CertificateStatus::certified);
    EXPECT_EQ(unfinished_[index].size(), rounds_ - 1);
    ASSERT_EQ(record.seconds.has_value(), timed_);
    if (!timed_) continue;
    EXPECT_EQ(record.seconds->rounds.size(), 3U);
    EXPECT_TRUE(record.seconds->unstable.has_value());
    EXPECT_FALSE(record.seconds->jobs.has_value());
  }
}

TEST_F(Rounds, AreOverAtOnceForACaseThatFails) {
  add("give_up", "1");
  add("good", "1");
  add("segfault", "1");
  run({});
  EXPECT_EQ(complete_.at(0).status, Status::not_converged);
  EXPECT_EQ(complete_.at(1).seconds.value_or(Seconds{}).rounds.size(), timed_ ? 3U : 0U);
  EXPECT_EQ(complete_.at(2).status, Status::crashed);
  EXPECT_EQ(begun_.size(), 2 + rounds_);
}

TEST_F(Rounds, ContinueWhereAnInterruptedRunLeftOff) {
  add("good", "1");
  add("good", "2");
  run({});
  EXPECT_EQ(unfinished_.empty(), !timed_);
  if (!timed_) return;
  const Record one_round = unfinished_.at(0).front();
  const Record two_rounds = unfinished_.at(1).back();
  begun_.clear();
  complete_.clear();
  run({}, {one_round, two_rounds});
  EXPECT_EQ(begun_.size(), 3U);
  EXPECT_EQ(complete_.at(0).seconds.value().rounds.size(), 3U);
  EXPECT_EQ(complete_.at(0).seconds->rounds[0].solve, one_round.seconds.value().rounds[0].solve);
  EXPECT_EQ(complete_.at(1).seconds.value().rounds.size(), 3U);
  EXPECT_EQ(complete_.at(1).seconds->rounds[1].solve, two_rounds.seconds.value().rounds[1].solve);
}

TEST_F(Rounds, AreTakenAgainWhereEqualSolvesDiffer) {
  if (!timed_) return;
  limits_.repetitions = 1;
  add("good", "1");
  add("good", "2");
  run({});
  const auto with_time = [&](std::size_t i, double seconds) {
    Record record = complete_.at(i);
    record.seconds = summarise({{.solve = seconds}});
    return record;
  };
  ASSERT_EQ(complete_.at(0).answer, complete_.at(1).answer);
  const std::vector<std::optional<Record>> near{with_time(0, 2.0), with_time(1, 2.4)},
      far{with_time(0, 2.0), with_time(1, 3.1)};
  complete_.clear();
  begun_.clear();
  run({}, near, kMoreRounds);
  EXPECT_TRUE(begun_.empty());
  EXPECT_EQ(complete_.at(1).seconds.value().rounds.size(), 1U);
  complete_.clear();
  run({}, far, kMoreRounds);
  EXPECT_GE(begun_.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    // The second round takes some microseconds: a third one at least has to say which time is right.
    const Seconds seconds = complete_.at(i).seconds.value();
    EXPECT_GE(seconds.rounds.size(), 3U);
    EXPECT_LE(seconds.rounds.size(), 2U + kMoreRounds);
    EXPECT_TRUE(seconds.unsteady.has_value());
    EXPECT_TRUE(seconds.load.has_value());
  }
}

TEST_F(Rounds, TakeTheOrderOfTheSeed) {
  for (const char* level : {"1", "2", "3", "4", "5", "6"}) add("good", level);
  run({.seed = 7});
  const std::vector<std::string> first = begun_;
  begun_.clear();
  complete_.clear();
  run({.seed = 7});
  EXPECT_EQ(begun_, first);
  begun_.clear();
  complete_.clear();
  run({.seed = 8});
  EXPECT_NE(begun_, first);
}

TEST_F(Rounds, SayWhereOthersRanAtTheSameTime) {
  for (const char* level : {"1", "2", "3"}) add("good", level);
  add("unsupported", "1");
  run({.seed = 1, .parallel = 2});
  ASSERT_EQ(complete_.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Seconds seconds = complete_.at(i).seconds.value_or(Seconds{});
    EXPECT_EQ(seconds.jobs, timed_ ? std::optional(2) : std::nullopt);
    EXPECT_EQ(seconds.rounds.size(), timed_ ? 3U : 0U);
  }
  EXPECT_EQ(complete_.at(3).status, Status::not_applicable);
}

}  // namespace

}  // namespace signorini::suite_run_test
