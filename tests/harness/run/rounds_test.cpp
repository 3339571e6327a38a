#include "harness/run/rounds.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "harness/build_info.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

constexpr Limits kLimits{.timeout = 2.0,
                         .memory_mb = 1024,
                         .repetitions = 3,
                         .certificate_timeout = 5.0,
                         .reference_timeout = 5.0};

/// What became of cases "behaviour=good,level=k" for k = 1..count on the scene of one mass.
class Rounds : public testing::Test, public RoundObserver {
 protected:
  void SetUp() override {
    if (!build_may_be_timed()) GTEST_SKIP() << "nothing is timed in this build";
  }

  void add(const std::string& behaviour, const std::string& level) {
    cases_.push_back(make_case(
        scene_, 0, {&test::fake_catalogue().front(), {{"behaviour", behaviour}, {"level", level}}}));
  }

  void run(const Schedule& schedule, std::vector<std::optional<Record>> begun = {}) {
    Runner runner(kLimits, test::free_orbits(), [](std::string_view) { return std::string("v"); });
    const std::vector<Job> jobs = runner.make_jobs(scene_, cases_);
    runner.compute_references(scene_, jobs);
    begun.resize(cases_.size());
    EXPECT_TRUE(run_rounds(runner, scene_, jobs, begun, schedule, *this));
  }

  void begins(const std::string& what) override { begun_.push_back(what); }
  void round_done(std::size_t index, const Record& record) override { unfinished_[index].push_back(record); }
  void case_done(std::size_t index, const Record& record) override {
    EXPECT_FALSE(complete_.contains(index)) << "told twice";
    complete_[index] = record;
  }

  Scene scene_ = test::one_mass_scene();
  std::vector<Case> cases_;
  std::vector<std::string> begun_;
  std::map<std::size_t, std::vector<Record>> unfinished_;
  std::map<std::size_t, Record> complete_;
};

TEST_F(Rounds, ComeRoundByRoundAndNotCaseByCase) {
  for (const char* level : {"1", "2", "3", "4"}) add("good", level);
  run({});
  ASSERT_EQ(begun_.size(), 12U);
  for (std::size_t round = 0; round < 3; ++round) {
    const auto first = begun_.begin() + static_cast<std::ptrdiff_t>(4 * round);
    EXPECT_EQ(std::set(first, first + 4).size(), 4U) << "round " << round;
  }
  EXPECT_NE(std::vector(begun_.begin(), begun_.begin() + 4),
            std::vector(begun_.begin() + 4, begun_.begin() + 8));
  ASSERT_EQ(complete_.size(), 4U);
  for (const auto& [index, record] : complete_) {
    EXPECT_EQ(record.case_id, cases_[index].id);
    EXPECT_EQ(record.status, Status::converged) << record.message;
    ASSERT_TRUE(record.seconds.has_value());
    EXPECT_EQ(record.seconds->rounds.size(), 3U);
    EXPECT_TRUE(record.seconds->unstable.has_value());
    EXPECT_FALSE(record.seconds->jobs.has_value());
    EXPECT_GT(record.elapsed.value(), 0.0);
    EXPECT_EQ(record.certificate.status, CertificateStatus::certified);
    EXPECT_EQ(unfinished_[index].size(), 2U);
  }
}

TEST_F(Rounds, AreOverAtOnceForACaseThatFails) {
  add("give_up", "1");
  add("good", "1");
  add("segfault", "1");
  run({});
  EXPECT_EQ(complete_.at(0).status, Status::not_converged);
  EXPECT_EQ(complete_.at(1).seconds.value().rounds.size(), 3U);
  EXPECT_EQ(complete_.at(2).status, Status::crashed);
  EXPECT_EQ(begun_.size(), 5U);
}

TEST_F(Rounds, ContinueWhereAnInterruptedRunLeftOff) {
  add("good", "1");
  add("good", "2");
  run({});
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
    EXPECT_EQ(complete_.at(i).seconds.value().jobs, 2);
    EXPECT_EQ(complete_.at(i).seconds->rounds.size(), 3U);
  }
  EXPECT_EQ(complete_.at(3).status, Status::not_applicable);
}

}  // namespace
}  // namespace signorini
