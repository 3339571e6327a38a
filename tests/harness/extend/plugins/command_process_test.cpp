#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <limits>

#include "harness/extend/plugins/command_method.hpp"

namespace signorini::command_process_test {
namespace {

constexpr double kLong = 20.0;  // [s]

CommandEnd run_shell(const std::string& script, std::string_view input = "", double seconds = kLong) {
  return run_command({"sh", "-c", script}, input, Deadline::after(seconds));
}

TEST(RunCommand, HandsOverItsInputAndReturnsItsOutput) {
  const CommandEnd end = run_shell("tr a-z A-Z", "some text");
  EXPECT_EQ(end.output, "SOME TEXT");
  EXPECT_EQ(end.failure, "");
  EXPECT_FALSE(end.expired);
}

// Each side may fill its pipe before the other reads.
TEST(RunCommand, PassesMoreThanAPipeHoldsBothWays) {
  const std::string text(3'000'000, 'x');
  const CommandEnd end = run_shell("cat", text);
  EXPECT_EQ(end.output, text);
  EXPECT_EQ(run_shell("head -c 200000 /dev/zero; cat >&2", text).output.size(), 200'000U);
}

TEST(RunCommand, DoesNotMindACommandThatReadsNothing) {
  const CommandEnd end = run_shell("exec <&-; echo done", std::string(3'000'000, 'x'));
  EXPECT_EQ(end.output, "done\n");
  EXPECT_EQ(end.failure, "");
}

TEST(RunCommand, NamesTheExitCodeAndTheLastLineOfStderr) {
  const CommandEnd end = run_shell("echo first >&2; echo second >&2; exit 3");
  EXPECT_EQ(end.failure, "the command ended with exit code 3");
  EXPECT_EQ(end.last_words, "second");
  EXPECT_FALSE(end.signal.has_value());
}

TEST(RunCommand, NamesTheSignal) {
  const CommandEnd end = run_shell("kill -ABRT $$");
  EXPECT_EQ(end.signal, SIGABRT);
  EXPECT_NE(end.failure.find("signal 6"), std::string::npos) << end.failure;
}

TEST(RunCommand, ThatIsNoProgramSaysSo) {
  const CommandEnd end = run_command({"/no/such/program"}, "", Deadline::after(kLong));
  EXPECT_EQ(end.failure, "the command ended with exit code 127");
  EXPECT_EQ(end.last_words, "/no/such/program: No such file or directory");
}

TEST(RunCommand, EndsAtTheDeadline) {
  const auto begin = std::chrono::steady_clock::now();
  const CommandEnd end = run_shell("echo early; sleep 30", "", 0.2);
  EXPECT_TRUE(end.expired);
  EXPECT_EQ(end.output, "early\n");
  EXPECT_EQ(end.failure, "");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(15));
}

// Whoever does the work.
TEST(RunCommand, EndsAtTheLimitOfProcessorTime) {
  for (const char* busy : {"while :; do :; done", "sh -c 'while :; do :; done'; true"}) {
    const CommandEnd end = run_shell(busy, "", 0.3);
    EXPECT_TRUE(end.expired) << busy << ": " << end.failure;
  }
}

TEST(RunCommand, KeepsOnlyTheEndOfEndlessErrors) {
  const CommandEnd end = run_shell("head -c 3000000 /dev/zero | tr '\\0' 'x' >&2; echo >&2; echo last >&2");
  EXPECT_EQ(end.last_words, "last");
}

TEST(RunCommand, TellsLibrariesToUseOneThread) {
  EXPECT_EQ(run_shell("echo $OMP_NUM_THREADS $OPENBLAS_NUM_THREADS $MKL_NUM_THREADS").output, "1 1 1\n");
}

CommandEnd ask(CommandSession& session, const std::string& line, double seconds = kLong) {
  return session.ask(line + "\n", Deadline::after(seconds));
}

TEST(CommandSession, IsOneProcessThatAnswersEachLineWithALine) {
  CommandSession session(
      {"sh", "-c", "n=0; while read -r line; do n=$((n + 1)); echo \"$line $n $$\"; done"});
  const std::string first = ask(session, "one").output, second = ask(session, "two").output;
  EXPECT_TRUE(first.starts_with("one 1 ")) << first;
  EXPECT_TRUE(second.starts_with("two 2 ")) << second;
  EXPECT_EQ(first.substr(6), second.substr(6));
}

TEST(CommandSession, PassesMoreThanAPipeHoldsBothWays) {
  CommandSession session({"cat"});
  for (const char letter : {'x', 'y'}) {
    const std::string text(3'000'000, letter);
    EXPECT_EQ(ask(session, text).output, text + "\n");
  }
}

TEST(CommandSession, BeginsAnewAfterADeadline) {
  CommandSession session({"sh", "-c", "read -r line; [ $line = quick ] || sleep 30; echo $line"});
  const CommandEnd slow = ask(session, "slow", 0.2);
  EXPECT_TRUE(slow.expired);
  EXPECT_EQ(slow.output, "");
  EXPECT_EQ(ask(session, "quick").output, "quick\n");
}

TEST(CommandSession, SaysHowACommandEndedThatDidNotAnswer) {
  CommandSession aborts({"sh", "-c", "read -r line; kill -ABRT $$"});
  EXPECT_EQ(ask(aborts, "line").signal, SIGABRT);
  CommandSession fails({"sh", "-c", "echo no licence >&2; exit 3"});
  const CommandEnd failed = ask(fails, "line");
  EXPECT_EQ(failed.failure, "the command ended with exit code 3");
  EXPECT_EQ(failed.last_words, "no licence");
  CommandSession leaves({"sh", "-c", "read -r line"});
  EXPECT_EQ(ask(leaves, "line").failure, "the command ended before its answer");
}

TEST(CommandSession, WhoseCommandEndsBetweenRequestsSaysSoAndBeginsAnew) {
  CommandSession session({"sh", "-c", "read -r line; echo $line"});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(ask(session, "line").output, "line\n");
    EXPECT_EQ(ask(session, "line").failure, "the command ended before its answer");
  }
}

/// Asks until an answer is refused, since what comes after an answer may take its time.
CommandEnd ask_until_unasked(CommandSession& session) {
  CommandEnd end;
  for (const auto begin = std::chrono::steady_clock::now();
       !end.unasked && std::chrono::steady_clock::now() - begin < std::chrono::seconds(15);)
    end = ask(session, "line");
  return end;
}

TEST(CommandSession, RefusesASecondAnswerAndBeginsAnew) {
  CommandSession session({"sh", "-c", "while read -r line; do echo $line; sleep 0.01; echo again; done"});
  EXPECT_EQ(ask(session, "line").output, "line\n");
  EXPECT_TRUE(ask_until_unasked(session).unasked);
  EXPECT_EQ(ask(session, "line").output, "line\n");
}

TEST(CommandSession, PassesOverEmptyLines) {
  CommandSession session({"sh", "-c", "while read -r line; do echo; echo $line; echo; done"});
  for (int i = 0; i < 20; ++i) {
    const CommandEnd end = ask(session, "line");
    EXPECT_FALSE(end.unasked);
    EXPECT_TRUE(end.output.starts_with("line\n")) << end.output;
  }
}

// A flood neither fills the memory nor keeps the next command from its answer.
TEST(CommandSession, SurvivesAFlood) {
  CommandSession answers({"sh", "-c", "yes | head -c 50000000; sleep 30"});
  const CommandEnd end = ask(answers, "line");
  EXPECT_TRUE(end.unasked);
  EXPECT_LT(end.output.size(), 3'000'000U);
  CommandSession errors({"sh", "-c", "read -r line; yes | head -c 5000000 >&2; echo $line"});
  EXPECT_EQ(ask(errors, "line").output, "line\n");
}

// A limit of processor time on the process that asks is one for a single solve.
TEST(CommandSession, HasNoLimitOfProcessorTime) {
  CommandSession session({"sh", "-c", "read -r line; ulimit -S -t"});
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_CPU, &before), 0);
  const rlimit low{.rlim_cur = 1000, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_CPU, &low), 0);
  const std::string limit = ask(session, "line").output;
  setrlimit(RLIMIT_CPU, &before);
  EXPECT_NE(limit, "1000\n");
}

}  // namespace
}  // namespace signorini::command_process_test
