#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <limits>

#include "harness/extend/plugins/command_method.hpp"

namespace signorini {
namespace {

constexpr double kLong = 20.0;  // [s]

CommandEnd run_shell(const std::string& script, std::string_view input = "", double seconds = kLong) {
  return run_command({"sh", "-c", script}, input, deadline_after(seconds));
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
  const CommandEnd end = run_command({"/no/such/program"}, "", deadline_after(kLong));
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

TEST(RunCommand, KeepsOnlyTheEndOfEndlessErrors) {
  const CommandEnd end = run_shell("head -c 3000000 /dev/zero | tr '\\0' 'x' >&2; echo >&2; echo last >&2");
  EXPECT_EQ(end.last_words, "last");
}

TEST(RunCommand, TellsLibrariesToUseOneThread) {
  EXPECT_EQ(run_shell("echo $OMP_NUM_THREADS $OPENBLAS_NUM_THREADS $MKL_NUM_THREADS").output, "1 1 1\n");
}

}  // namespace
}  // namespace signorini
