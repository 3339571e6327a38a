#include "harness/run/round_messages.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "harness/isolation/isolation.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::round_messages_test {
namespace {

/// What a record is before its first round.
Record blank_record() {
  Record record;
  record.case_id = "s/m[n=1]";
  record.scene = "s";
  record.method = "m";
  record.certificate.reason = "there is no answer to certify";
  return record;
}

Record received(const ChildEnd& end) { return received_first_round(blank_record(), end.lines, end); }

/// A child that fills in a record stage by stage, and then does `last`.
template <class Last>
ChildEnd send_stages(const Record& blank, const Last& last, int stages = 4) {
  return run_isolated(
      [&](const LineSender& send) {
        FirstRoundSender stage_done(send, blank);
        Record record = blank;
        for (int stage = 0; stage < stages; ++stage) {
          if (stage == 0) {
            record.status = Status::converged;
            record.message = "solved";
            record.trajectory = TrajectorySamples{
                .t = {0.0, 0.5}, .x = {{1.0, 2.0}}, .velocity = {{0.0, 0.0}}, .force = {{0.0, 0.0}}};
          }
          if (stage == 1) record.not_timed = "not asked for";
          if (stage == 2) record.physics.penetration = 0.0;
          if (stage == 3) record.certificate.reason = "not looked for";
          stage_done(record);
        }
        last();
      },
      {.stage_seconds = {5.0}});
}

TEST(FirstRound, IsInvalidOutputWhereItsLinesAreNoRecord) {
  for (const char* line : {"a library's own words", "3", R"({"schema":2})", R"({"elapsed":"late"})"}) {
    const ChildEnd end =
        run_isolated([line](const LineSender& send) { send(line); }, {.stage_seconds = {5.0}});
    const Record record = received(end);
    EXPECT_EQ(record.status, Status::invalid_output) << line;
    EXPECT_TRUE(record.message.starts_with("its process sent no record: ")) << record.message;
  }
}

TEST(FirstRound, ArrivesWholeThoughEachStageSendsOnlyWhatItAdds) {
  const Record blank = blank_record();
  const ChildEnd end = send_stages(blank, [] {});
  ASSERT_EQ(end.lines.size(), 4U);
  const auto keys = [&](std::size_t stage) {
    std::vector<std::string> names;
    const auto json = nlohmann::ordered_json::parse(end.lines[stage]);
    for (const auto& [key, value] : json.items()) names.push_back(key);
    return names;
  };
  EXPECT_EQ(keys(0), (std::vector<std::string>{"status", "message", "trajectory"}));
  EXPECT_EQ(keys(1), (std::vector<std::string>{"not_timed"}));
  EXPECT_EQ(keys(2), (std::vector<std::string>{"physics"}));
  EXPECT_EQ(keys(3), (std::vector<std::string>{"certificate"}));
  const Record record = received_first_round(blank, end.lines, end);
  EXPECT_EQ(record.case_id, blank.case_id);
  EXPECT_EQ(record.message, "solved");
  EXPECT_EQ(record.trajectory.value().x[0][1], 2.0);
  EXPECT_EQ(record.not_timed, "not asked for");
  EXPECT_EQ(record.physics.penetration, 0.0);
  EXPECT_EQ(record.certificate.reason, "not looked for");
  EXPECT_GT(record.elapsed.value(), 0.0);
}

TEST(FirstRound, OfAChildThatDiesBeforeItsAnswerIsAFailure) {
  const Record record = received(send_stages(
      blank_record(), [] { _exit(3); }, 0));
  EXPECT_EQ(record.status, Status::crashed);
  EXPECT_NE(record.message.find("code 3"), std::string::npos) << record.message;
}

TEST(FirstRound, BlamesTheMethodForADeathWhileItIsTimedOrCleanedUp) {
  const Record timed = received(send_stages(
      blank_record(), [] { _exit(3); }, 1));
  EXPECT_EQ(timed.status, Status::crashed);
  EXPECT_TRUE(timed.message.starts_with("in a repeated solve: ")) << timed.message;
  const Record cleaned = received(send_stages(
      blank_record(), [] { _exit(3); }, 4));
  EXPECT_EQ(cleaned.status, Status::crashed);
  EXPECT_TRUE(cleaned.message.starts_with("in its clean-up: ")) << cleaned.message;
}

TEST(FirstRound, LeavesNoClaimStandingWhoseCheckHasDied) {
  const Record record = received(send_stages(
      blank_record(), [] { _exit(3); }, 2));
  EXPECT_EQ(record.status, Status::crashed);
  EXPECT_EQ(claim_of(record), std::nullopt);
  EXPECT_TRUE(record.message.starts_with("in the harness's check of its answer: ")) << record.message;
  EXPECT_EQ(record.certificate.status, CertificateStatus::uncertified);
  EXPECT_TRUE(record.certificate.reason.starts_with("the harness's own check ended by "))
      << record.certificate.reason;
}

TEST(FirstRound, LeavesAClaimUnprovenOnlyWhereItsPhysicsWereMeasuredInTime) {
  const auto late_after = [](int stages) {
    ChildEnd end = send_stages(
        blank_record(), [] { _exit(3); }, stages);
    end.kind = ChildEnd::Kind::timed_out;
    return received(end);
  };
  const Record measured = late_after(3);
  EXPECT_EQ(claim_of(measured), Claim::unproven);
  EXPECT_TRUE(measured.certificate.reason.starts_with("the harness's own check ended by "));
  const Record unmeasured = late_after(2);
  EXPECT_EQ(unmeasured.status, Status::timeout);
  EXPECT_EQ(claim_of(unmeasured), std::nullopt);
  EXPECT_TRUE(unmeasured.message.starts_with("in the harness's check of its answer: ")) << unmeasured.message;
}

TEST(LaterRound, IsAddedToTheRecordWithItsTimesAndItsAnswer) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.1);
  record.seconds->rounds = {{0.01, 0.09}};
  record.answer = "0123";
  const auto round_with = [](const std::string& answer) {
    return run_isolated(
        [&](const LineSender& send) {
          send_later_round({.times = TimedRound{.setup = 0.03, .solve = 0.07}, .answer = answer}, send);
        },
        {.stage_seconds = {5.0}});
  };
  take_later_round(round_with("0123"), record);
  take_later_round(round_with("another"), record);
  ASSERT_EQ(record.seconds.value().rounds.size(), 3U);
  EXPECT_EQ(record.seconds->rounds[1].setup, 0.03);
  EXPECT_EQ(record.repeats.value().solves, 2);
  EXPECT_EQ(record.repeats->identical, 1);
}

TEST(TakeLaterRound, CountsTheFailureOfALaterRoundAgainstTheCase) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.1);
  record.seconds->rounds = {{0.01, 0.09}};
  const Record begun = record;
  take_later_round({.kind = ChildEnd::Kind::signalled, .code = 6}, record);
  EXPECT_EQ(record.status, Status::crashed);
  EXPECT_EQ(record.signal, 6);
  EXPECT_EQ(record.message.rfind("in a repeated solve: ", 0), 0U) << record.message;
  EXPECT_FALSE(record.seconds.has_value());

  record = begun;
  take_later_round({.lines = {R"({"message": "stalled", "status": "timeout"})"}}, record);
  EXPECT_EQ(record.status, Status::timeout);
  take_later_round({.lines = {R"({"message": "stalled", "status": "not-converged"})"}}, record);
  EXPECT_EQ(record.status, Status::not_converged);
  EXPECT_EQ(record.message, "in a repeated solve: stalled");

  record = begun;
  record.elapsed = 1.0;
  take_later_round({.lines = {R"({"times": [0.03, 0.07], "answer": "0123"})"}, .seconds = 0.5}, record);
  EXPECT_EQ(record.status, Status::converged);
  EXPECT_EQ(record.seconds.value().repetitions, 2);
  EXPECT_EQ(record.seconds->setup, 0.02);
  EXPECT_EQ(record.elapsed, 1.5);
}

}  // namespace
}  // namespace signorini::round_messages_test
