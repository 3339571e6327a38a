#include "harness/isolation/isolation.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <set>
#include <string>
#include <thread>

#include "methods/deadline.hpp"
#include "methods/plugin/sanitizer.hpp"
#include "methods/solvers/dense_products.hpp"

namespace signorini::isolation_test {

namespace {

using Kind = ChildEnd::Kind;

constexpr IsolationLimits quick() { return {.stage_seconds = {5.0}, .grace = 0.1}; }

TEST(RunIsolated, HandsOverEveryLineWhole) {
  const std::string large(3'000'000, 'x');
  const ChildEnd end = run_isolated(
      [&](const LineSender& send) {
        send("first");
        send(large);
        send("");
      },
      quick());
  EXPECT_EQ(end.kind, Kind::finished);
  ASSERT_EQ(end.lines.size(), 3U);
  EXPECT_EQ(end.lines[0], "first");
  EXPECT_EQ(end.lines[1], large);
  EXPECT_EQ(end.lines[2], "");
}

TEST(RunIsolated, KeepsWhatWasSentBeforeACrash) {
  const ChildEnd end = run_isolated(
      [](const LineSender& send) {
        send("one");
        std::abort();
      },
      quick());
  EXPECT_EQ(end.kind, Kind::signalled);
  EXPECT_EQ(end.code, SIGABRT);
  EXPECT_EQ(end.lines, (std::vector<std::string>{"one"}));
}

TEST(RunIsolated, ReportsTheLastWordsOfACrash) {
  const ChildEnd end = run_isolated(
      [](const LineSender&) {
        const std::string words = "something\nassertion failed: x > 0\n";
        if (write(STDERR_FILENO, words.data(), words.size()) < 0) _exit(9);
        std::raise(SIGSEGV);
      },
      quick());
  EXPECT_EQ(end.last_words, "assertion failed: x > 0");
  EXPECT_NE(describe(end).find("signal 11"), std::string::npos);
}

TEST(RunIsolated, GivesEachStageItsOwnTime) {
  const auto work = [](const LineSender& send) {
    for (int i = 0; i < 4; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(120));
      send("stage");
    }
  };
  const ChildEnd end = run_isolated(work, {.stage_seconds = {2.0, 2.0, 0.001}, .grace = 0.1});
  EXPECT_EQ(end.kind, Kind::timed_out);
  EXPECT_EQ(end.lines.size(), 2U);
  EXPECT_EQ(run_isolated(work, {.stage_seconds = {2.0}, .grace = 0.1}).kind, Kind::finished);
}

TEST(RunIsolated, CountsSleepAsTimeUsed) {
  constexpr double kLimit = 0.2;
  const ChildEnd end =
      run_isolated([](const LineSender&) { std::this_thread::sleep_for(std::chrono::seconds(60)); },
                   {.stage_seconds = {kLimit}});
  EXPECT_EQ(end.kind, ChildEnd::Kind::timed_out);
  // Long before the ceiling of wall time, which is for what other work keeps from a processor.
  EXPECT_LT(end.seconds, 0.5 * Deadline::kWallPerProcessor * kLimit);
}

TEST(RunIsolated, LeavesNoProcessBehind) {
  const ChildEnd end = run_isolated(
      [](const LineSender& send) {
        const pid_t grandchild = fork();
        if (grandchild == 0) {
          std::signal(SIGTERM, SIG_IGN);
          for (;;) pause();
        }
        send(std::to_string(grandchild));
      },
      quick());
  ASSERT_EQ(end.lines.size(), 1U);
  const pid_t grandchild = std::stoi(end.lines[0]);
  EXPECT_EQ(kill(grandchild, 0), -1);
  EXPECT_EQ(errno, ESRCH);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(RunIsolated, EndsAGrandchildThatLeftTheProcessGroup) {
  const ChildEnd end = run_isolated(
      [](const LineSender& send) {
        std::array<int, 2> ready{};
        if (pipe(ready.data()) != 0) std::abort();
        const pid_t grandchild = fork();
        if (grandchild == 0) {
          std::signal(SIGTERM, SIG_IGN);
          setsid();
          close(ready[1]);
          for (;;) pause();
        }
        close(ready[1]);
        char nothing = 0;
        if (read(ready[0], &nothing, 1) == 0) send(std::to_string(grandchild));
      },
      quick());
  ASSERT_EQ(end.lines.size(), 1U);
  EXPECT_EQ(kill(std::stoi(end.lines[0]), 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

TEST(RunIsolated, AllowsEachStageTheProcessorTimeOfOneThread) {
  const auto limit = [] {
    rlimit processor{};
    getrlimit(RLIMIT_CPU, &processor);
    return processor.rlim_cur;
  };
  const ChildEnd end = run_isolated(
      [&](const LineSender& send) {
        send(std::to_string(limit()));
        while (limit() <= 4) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        send(std::to_string(limit()));
      },
      {.stage_seconds = {2.5, 5.0}, .grace = 0.1});
  EXPECT_EQ(end.lines, (std::vector<std::string>{"4", "9"}));
}

TEST(RunIsolated, TellsWhoUsedUpTheProcessorTime) {
  const ChildEnd end = run_isolated([](const LineSender&) { std::raise(SIGXCPU); }, quick());
  EXPECT_EQ(end.kind, Kind::out_of_processor_time);
  EXPECT_NE(describe(end).find("processor time"), std::string::npos);
}

TEST(RunIsolated, ClosesTheFilesOfTheParent) {
  const int file = dup(STDERR_FILENO);
  ASSERT_GE(file, 0);
  const ChildEnd end = run_isolated(
      [file](const LineSender& send) { send(write(file, "x", 1) < 0 && errno == EBADF ? "closed" : "open"); },
      quick());
  close(file);
  EXPECT_EQ(end.lines, (std::vector<std::string>{"closed"}));
}

TEST(RunIsolated, DoesNotWaitForAGrandchildThatHoldsThePipe) {
  const ChildEnd end = run_isolated(
      [](const LineSender& send) {
        if (fork() == 0) {
          for (;;) pause();
        }
        send("done");
      },
      {.stage_seconds = {60.0}, .grace = 0.1});
  EXPECT_EQ(end.kind, Kind::finished);
}

TEST(RunIsolated, SurvivesAChildThatTalksWithoutEnd) {
  const ChildEnd end = run_isolated(
      [](const LineSender& send) {
        const std::string chatter(1U << 16U, 'y');
        for (int i = 0; i < 100; ++i) {
          if (write(STDOUT_FILENO, chatter.data(), chatter.size()) < 0) break;  // cut off, not killed
        }
        send("done");
      },
      quick());
  EXPECT_EQ(end.kind, Kind::finished);
  EXPECT_EQ(end.lines.size(), 1U);
}

TEST(RunIsolated, StopsAChildWhoseLineHasNoEnd) {
  const ChildEnd end = run_isolated(
      [](const LineSender&) {
        // Straight into the harness's pipe, as a method may that looks for open descriptors.
        const std::string block(1U << 20U, 'x');
        for (int number = STDERR_FILENO + 1; number < 64; ++number) {
          while (write(number, block.data(), block.size()) > 0) continue;
        }
      },
      {.stage_seconds = {20.0}, .grace = 0.1});
  EXPECT_EQ(end.kind, Kind::flooded);
  EXPECT_LT(end.seconds, 10.0);
}

TEST(RunIsolatedTogether, KeepsTheOrderOfTheWork) {
  std::vector<IsolatedWork> work;
  for (int i = 0; i < 7; ++i) {
    work.push_back([i](const LineSender& send) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10 * (7 - i)));
      if (i == 3) std::abort();
      send(std::to_string(i));
    });
  }
  std::vector<std::size_t> told;
  const std::vector<ChildEnd> ends = run_isolated_together(
      work, quick(), 3, [&](std::size_t index, const ChildEnd&) { told.push_back(index); });
  ASSERT_EQ(ends.size(), 7U);
  std::sort(told.begin(), told.end());
  EXPECT_EQ(told, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6}));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i == 3) {
      EXPECT_EQ(ends[i].kind, Kind::signalled);
    } else {
      EXPECT_EQ(ends[i].lines, (std::vector<std::string>{std::to_string(i)}));
    }
  }
}

using Kind = ChildEnd::Kind;

TEST(RunIsolatedTogether, HandsOverEachLineWhenItArrives) {
  std::vector<std::string> told;
  bool ended = false;
  const auto work = [](const LineSender& send) {
    send("first");
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    send("second");
  };
  run_isolated_together(
      {work}, {}, 1,
      [&](std::size_t, const ChildEnd& end) {
        ended = true;
        EXPECT_EQ(end.lines, (std::vector<std::string>{"", ""}));  // they were taken
      },
      [&](std::size_t index, std::string line) {
        EXPECT_FALSE(ended);
        EXPECT_EQ(index, 0U);
        told.push_back(std::move(line));
      });
  EXPECT_EQ(told, (std::vector<std::string>{"first", "second"}));
}

// Work that fits is done, and what does not is told: it waits for nothing. A limit in a process that has
// mapped more than that before would refuse both.
TEST(RunIsolated, LimitsWhatTheWorkTakesBeyondTheProgram) {
  if (kAddressSanitizer) GTEST_SKIP() << "there is no limit of address space under the address sanitizer";
  IsolationLimits limits = quick();
  limits.memory_mb = 64;
  const auto product = [](Eigen::Index size) {
    return [size](const LineSender& send) {
      const Eigen::MatrixXd A = Eigen::MatrixXd::Constant(size, size, 1.0);
      send(std::to_string(dense_product(A, A).minCoeff()));
    };
  };
  const ChildEnd small = run_isolated(product(300), limits);
  EXPECT_EQ(small.kind, Kind::finished) << describe(small);
  EXPECT_EQ(small.lines, (std::vector<std::string>{std::to_string(300.0)}));
  EXPECT_EQ(run_isolated(product(3000), limits).kind, Kind::out_of_memory);
}

TEST(DescribeChildEnd, QuotesTheLastWordsWhereTheProcessDied) {
  EXPECT_EQ(describe({.kind = Kind::signalled, .code = 11, .last_words = "x > 0 failed"}),
            "signal 11 (Segmentation fault): x > 0 failed");
  EXPECT_EQ(describe({.kind = Kind::exited, .code = 3}), "the process ended with code 3 before an answer");
  EXPECT_EQ(describe({.kind = Kind::exited, .code = 3, .last_words = "no licence"}),
            "the process ended with code 3 before an answer: no licence");
}

TEST(DescribeChildEnd, HasAPhraseOfItsOwnForEachKind) {
  std::set<std::string> phrases;
  for (const Kind kind : {Kind::finished, Kind::threw, Kind::out_of_memory, Kind::exited, Kind::signalled,
                          Kind::timed_out, Kind::out_of_processor_time, Kind::interrupted}) {
    const std::string phrase = describe({.kind = kind, .code = 6, .detail = "text"});
    EXPECT_NE(phrase, "");
    EXPECT_TRUE(phrases.insert(phrase).second) << phrase;
  }
  EXPECT_TRUE(phrases.contains("exception: text"));
}

}  // namespace

}  // namespace signorini::isolation_test
