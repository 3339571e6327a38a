#include "harness/isolation/child_process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <thread>

#include "harness/failure.hpp"

namespace signorini::child_process_test {
namespace {

/// Until the child ends; fails the test after ten seconds.
void wait_for_end(const ChildProcess& child) {
  constexpr int kTenSeconds = 10'000;
  pollfd place{.fd = child.end_descriptor(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(poll(&place, 1, kTenSeconds), 1);
}

void say(int descriptor, std::string_view text) {
  if (write(descriptor, text.data(), text.size()) < 0) _exit(9);
}

TEST(LastLine, LeavesOutWhatFollowsTheText) {
  EXPECT_EQ(last_line("first\nsecond \n\n"), "second");
  EXPECT_EQ(last_line("alone"), "alone");
  EXPECT_EQ(last_line("\n \n"), "");
  EXPECT_EQ(last_line(""), "");
}

TEST(MachineFull, IsToldWhereNoDescriptorIsLeft) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{.rlim_cur = 0, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  EXPECT_THROW(static_cast<void>(make_pipe()), MachineFull);
  EXPECT_THROW(static_cast<void>(make_memory_file()), MachineFull);
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
}

TEST(ReadAvailable, TakesWhatIsThereWithoutWaitingForMore) {
  Pipe pipe = make_pipe();
  set_non_blocking(pipe.read);
  std::string text;
  read_available(pipe.read, text);
  EXPECT_EQ(text, "");
  EXPECT_TRUE(pipe.read.is_open());
  say(pipe.write.number(), "some");
  read_available(pipe.read, text);
  EXPECT_EQ(text, "some");
  pipe.write.reset();
  read_available(pipe.read, text);
  EXPECT_EQ(text, "some");
  EXPECT_FALSE(pipe.read.is_open());
}

// Commands do their work below the process that is asked.
TEST(ChildProcess, KnowsTheProcessorTimeOfItsDescendants) {
  const auto work = [] {
    constexpr double kSeconds = 0.1;
    while (static_cast<double>(std::clock()) / CLOCKS_PER_SEC < kSeconds) {
    }
  };
  Pipe done = make_pipe();
  const ChildProcess child({}, done.write.number(), [&] {
    if (fork() == 0) {
      work();
      say(done.write.number(), "x");
      for (;;) pause();
    }
    for (;;) pause();
  });
  pollfd place{.fd = done.read.number(), .events = POLLIN, .revents = 0};
  ASSERT_EQ(poll(&place, 1, 60'000), 1);
  EXPECT_GE(child.times().processor, 0.05);
  EXPECT_LE(child.times().processor, 1.0);
}

TEST(ReadAvailable, StopsBeyondTheMostItMayTake) {
  Pipe pipe = make_pipe();
  set_non_blocking(pipe.read);
  std::string text = "12345";
  say(pipe.write.number(), "678");
  read_available(pipe.read, text, 4);
  EXPECT_EQ(text, "12345");
  read_available(pipe.read, text, 5);
  EXPECT_EQ(text, "12345678");
}

TEST(ChildProcess, ReturnsTheStatusOfItsEnd) {
  ChildProcess returns({}, -1, [] {});
  wait_for_end(returns);
  EXPECT_TRUE(returns.has_ended());
  int status = returns.reap();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  ChildProcess exits({}, -1, [] { _exit(3); });
  wait_for_end(exits);
  status = exits.reap();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 3) << status;
  ChildProcess aborts({}, -1, [] { std::raise(SIGTERM); });
  wait_for_end(aborts);
  status = aborts.reap();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
}

TEST(ChildProcess, RunsUntilItIsKilled) {
  ChildProcess child({}, -1, [] {
    for (;;) pause();
  });
  EXPECT_FALSE(child.has_ended());
  const int status = child.reap();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
}

TEST(ChildProcess, SpeaksAndListensThroughItsStreams) {
  Pipe in = make_pipe(), out = make_pipe(), err = make_pipe();
  ChildProcess child({.in = in.read.number(), .out = out.write.number(), .err = err.write.number()}, -1, [] {
    char letter = 0;
    if (read(STDIN_FILENO, &letter, 1) == 1) say(STDOUT_FILENO, std::string(3, letter));
    say(STDERR_FILENO, "done");
  });
  say(in.write.number(), "x");
  wait_for_end(child);
  child.reap();
  std::string output, errors;
  set_non_blocking(out.read);
  set_non_blocking(err.read);
  read_available(out.read, output);
  read_available(err.read, errors);
  EXPECT_EQ(output, "xxx");
  EXPECT_EQ(errors, "done");
}

TEST(ChildProcess, HasNoFilesOfItsParentButTheOneThatIsKept) {
  const Pipe kept = make_pipe(), other = make_pipe();
  const int low = other.write.number(), high = dup(other.write.number());
  ChildProcess child({}, kept.write.number(), [&] {
    const auto is_open = [](int number) { return fcntl(number, F_GETFD) >= 0; };
    _exit((is_open(kept.write.number()) ? 1 : 0) + (is_open(low) ? 2 : 0) + (is_open(high) ? 4 : 0) +
          (is_open(kept.read.number()) ? 8 : 0));
  });
  wait_for_end(child);
  EXPECT_EQ(WEXITSTATUS(child.reap()), 1);
  close(high);
}

TEST(ChildProcess, HasTheDefaultSignalHandlers) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  ChildProcess child({}, -1, [] { _exit(std::signal(SIGPIPE, SIG_DFL) == SIG_DFL ? 0 : 1); });
  std::signal(SIGPIPE, before);
  wait_for_end(child);
  EXPECT_EQ(WEXITSTATUS(child.reap()), 0);
}

TEST(ChildProcess, IsKilledWithWhatItStarted) {
  Pipe number = make_pipe();
  pid_t grandchild = 0;
  {
    ChildProcess child({}, number.write.number(), [&] {
      const pid_t started = fork();
      if (started == 0) {
        for (;;) pause();
      }
      if (write(number.write.number(), &started, sizeof started) < 0) _exit(9);
      for (;;) pause();
    });
    ASSERT_EQ(read(number.read.number(), &grandchild, sizeof grandchild),
              static_cast<ssize_t>(sizeof grandchild));
    EXPECT_EQ(kill(grandchild, 0), 0);
  }
  // Its new parent, which this test does not know, may take a moment to wait for it.
  constexpr int kMostLooks = 1000;
  int looks = 0;
  while (kill(grandchild, 0) == 0 && ++looks < kMostLooks)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_LT(looks, kMostLooks);
}

TEST(ChildProcess, LeavesNoZombie) {
  {
    const ChildProcess child({}, -1, [] {});
  }
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace signorini::child_process_test
