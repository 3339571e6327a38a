#include "harness/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <string>

#include "harness/isolation/child_process.hpp"

namespace signorini::progress_test {
namespace {

TEST(ProgressLine, EstimatesTheRestFromWhatIsDone) {
  EXPECT_EQ(progress_line(0.0, 4, 0.0, "x"), "[0/4] 0 % x");
  EXPECT_EQ(progress_line(1.0, 4, 30.0, "x"), "[1/4] 25 % ETA 1:30 x");
  EXPECT_EQ(progress_line(0.5, 4, 10.0, "x"), "[0/4] 12 % ETA 1:10 x");
  EXPECT_EQ(progress_line(4.0 - 1e-12, 4, 10.0, "x"), "[4/4] 100 % ETA 0:00 x");
}

TEST(WaitingLine, EndsWithTheTimePassedAndFitsATerminal) {
  using std::chrono::seconds;
  EXPECT_EQ(waiting_line("solving", seconds(5)), "solving 0:05");
  EXPECT_EQ(waiting_line("solving", seconds(725)), "solving 12:05");
  const std::string longest = waiting_line(std::string(200, 'x'), seconds(60));
  EXPECT_EQ(longest.size(), 79U);
  EXPECT_TRUE(longest.ends_with("x 1:00"));
  EXPECT_EQ(waiting_line("solving by hand", seconds(5), 12), "solving 0:05");
  EXPECT_EQ(waiting_line("solving", seconds(5), 2), " 0:05") << "the time in any case";
}

/// stderr on a pseudo-terminal (pty(7)), or on what it was before.
class StderrOnATerminal {
 public:
  StderrOnATerminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)), before_(dup(STDERR_FILENO)) {
    if (grantpt(master_.number()) != 0 || unlockpt(master_.number()) != 0) return;
    const Descriptor end(open(ptsname(master_.number()), O_RDWR | O_NOCTTY));
    dup2(end.number(), STDERR_FILENO);
  }
  ~StderrOnATerminal() { dup2(before_.number(), STDERR_FILENO); }
  StderrOnATerminal(const StderrOnATerminal&) = delete;
  StderrOnATerminal& operator=(const StderrOnATerminal&) = delete;

  /// What has arrived, once it holds `text`; all that arrives within ten seconds where it does not.
  std::string shown_until(const std::string& text) {
    constexpr int kLongest = 10000;  // [ms]
    pollfd readable{.fd = master_.number(), .events = POLLIN, .revents = 0};
    while (shown_.find(text) == std::string::npos && poll(&readable, 1, kLongest) == 1) {
      std::array<char, 256> bytes{};
      const ssize_t count = read(master_.number(), bytes.data(), bytes.size());
      if (count <= 0) break;
      shown_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return shown_;
  }

 private:
  Descriptor master_, before_;
  std::string shown_;
};

TEST(Waiting, IsShownOnATerminalAndClearedAtTheEnd) {
  StderrOnATerminal terminal;
  {
    const Waiting waiting("solving by hand");
    EXPECT_NE(terminal.shown_until("solving by hand 0:00").find("solving by hand 0:00"), std::string::npos);
  }
  const std::string all = terminal.shown_until("0:00\r\033[K");
  EXPECT_TRUE(all.ends_with("\r\033[K")) << all;
}

TEST(Waiting, IsSilentElsewhere) {
  const Pipe pipe = make_pipe();
  const Descriptor before(dup(STDERR_FILENO));
  dup2(pipe.write.number(), STDERR_FILENO);
  { const Waiting waiting("solving by hand"); }
  dup2(before.number(), STDERR_FILENO);
  pollfd readable{.fd = pipe.read.number(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(poll(&readable, 1, 0), 0);
}

}  // namespace
}  // namespace signorini::progress_test
