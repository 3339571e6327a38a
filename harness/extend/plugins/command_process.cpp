#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/isolation/child_process.hpp"

namespace signorini {

namespace {

constexpr std::size_t kMostOutput = std::size_t{1} << 30U;  // bytes
constexpr std::size_t kSlice = std::size_t{1} << 20U;       // bytes read at once, at least what a pipe holds
constexpr const char* kBlanks = " \t\r\n";
constexpr std::size_t kLastWords = 400;  // bytes
// Between two looks at a command: before its time may be up, from then on, and for its end [s].
constexpr double kLook = 1.0, kLookLate = 0.02, kLookForEnd = 0.005;

/// While it lives, writing to a command that has stopped reading is an error and no signal.
class BrokenPipesIgnored {
 public:
  BrokenPipesIgnored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~BrokenPipesIgnored() { std::signal(SIGPIPE, before_); }
  BrokenPipesIgnored(const BrokenPipesIgnored&) = delete;
  BrokenPipesIgnored& operator=(const BrokenPipesIgnored&) = delete;

 private:
  void (*before_)(int);
};

void lift_limit(__rlimit_resource resource) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(resource, &limit);
}

/// Replaces this process by the command.
[[noreturn]] void execute(const std::vector<std::string>& words) {
  lift_limit(RLIMIT_FSIZE);  // the process of a run may write little, its command what it wants
  lift_limit(RLIMIT_CPU);    // it has the deadline of each solve
  for (const char* variable : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"})
    setenv(variable, "1", 1);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  const std::string reason = words[0] + ": " + std::strerror(errno) + "\n";
  static_cast<void>(!::write(STDERR_FILENO, reason.data(), reason.size()));
  _exit(ProgramEnd::kMissing);
}

}  // namespace

/// A started command with its three pipes.
class RunningCommand {
 public:
  /// \param stays  it is asked more than once, and answers with a line
  RunningCommand(const std::vector<std::string>& words, bool stays)
      : stays_(stays),
        process_({.in = in_.read.number(), .out = out_.write.number(), .err = err_.write.number()}, -1,
                 [&words] { execute(words); }) {
    in_.read.reset();
    out_.write.reset();
    err_.write.reset();
    for (const Descriptor* end : {&in_.write, &out_.read, &err_.read}) set_non_blocking(*end);
  }

  [[nodiscard]] bool has_ended() const { return ended_; }

  /// Hands over the input. Returns when the command has printed a line, if it stays; else, and without one,
  /// when it has ended.
  CommandEnd run(std::string_view input, const Deadline& deadline) {
    input_ = input;
    end_ = {};
    line_end_ = std::string::npos;
    if (stays_) read_output();
    end_.unasked = !end_.output.empty();
    if (!end_.unasked) {
      exchange(deadline);
      end_.unasked = has_answered() && end_.output.find_first_not_of(kBlanks, line_end_) != std::string::npos;
    }
    if (has_answered() && !end_.unasked) return std::move(end_);
    ended_ = true;
    const bool too_much = end_.output.size() > kMostOutput;
    const int status = process_.reap();
    if (!end_.unasked) read_output();  // what was printed since the last look
    if (!end_.expired && !end_.unasked) take_status(status);
    if (too_much) end_.failure = fmt::format("the command printed more than {} bytes", kMostOutput);
    end_.last_words =
        last_line(errors_.size() > kLastWords ? errors_.substr(errors_.size() - kLastWords) : errors_);
    return std::move(end_);
  }

 private:
  [[nodiscard]] bool has_answered() const { return stays_ && line_end_ != std::string::npos; }

  /// Writes and reads until the command has answered or ended, the deadline has passed, also by what the
  /// command itself has taken, or it prints too much.
  void exchange(const Deadline& deadline) {
    const ChildAllowance allowance(process_, std::max(0.0, deadline.left()));
    while (!has_answered() && end_.output.size() <= kMostOutput) {
      const bool gone = process_.has_ended();  // then all that it printed is there to be read
      if (!gone && (deadline.passed() || allowance.used(process_))) {
        end_.expired = true;
        return;
      }
      if (!gone) wait(std::clamp(allowance.least_wait(), kLookLate, kLook));
      write_input();
      read_output();
      if (gone) return;
    }
  }

  /// Until something can be read or written, the command has ended, or `seconds` have passed.
  void wait(double seconds) {
    // Without a descriptor for its end, only looking often tells that the command has ended.
    if (process_.end_descriptor() < 0) seconds = std::min(seconds, kLookForEnd);
    const int in = stays_ && input_.empty() ? -1 : in_.write.number();
    std::array<pollfd, 4> places{{{.fd = in, .events = POLLOUT, .revents = 0},
                                  {.fd = out_.read.number(), .events = POLLIN, .revents = 0},
                                  {.fd = err_.read.number(), .events = POLLIN, .revents = 0},
                                  {.fd = process_.end_descriptor(), .events = POLLIN, .revents = 0}}};
    poll(places.data(), places.size(), static_cast<int>(std::ceil(1e3 * std::max(0.0, seconds))));
  }

  void write_input() {
    while (in_.write.is_open()) {
      if (input_.empty() && stays_) return;
      if (input_.empty()) return in_.write.reset();
      const ssize_t written = ::write(in_.write.number(), input_.data(), input_.size());
      if (written < 0 && (errno == EAGAIN || errno == EINTR)) return;
      if (written < 0) return in_.write.reset();  // it reads no more
      input_.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void read_output() {
    const std::size_t before = end_.output.size();
    read_available(out_.read, end_.output, before + kSlice);
    if (stays_ && before == 0) end_.output.erase(0, end_.output.find_first_not_of(kBlanks));  // empty lines
    if (line_end_ == std::string::npos) line_end_ = end_.output.find('\n', before);
    read_available(err_.read, errors_, errors_.size() + kSlice);
    if (errors_.size() > 2 * kLastWords) errors_.erase(0, errors_.size() - kLastWords);
  }

  void take_status(int status) {
    if (WIFSIGNALED(status)) {
      end_.signal = WTERMSIG(status);
      end_.failure =
          fmt::format("the command was ended by signal {} ({})", *end_.signal, strsignal(*end_.signal));
    } else if (WEXITSTATUS(status) != EXIT_SUCCESS) {
      end_.failure = fmt::format("the command ended with exit code {}", WEXITSTATUS(status));
    } else if (stays_) {
      end_.failure = "the command ended before its answer";
    }
  }

  bool stays_;
  bool ended_ = false;
  std::size_t line_end_ = std::string::npos;  ///< of the first line since the last request
  std::string_view input_;
  Pipe in_ = make_pipe(), out_ = make_pipe(), err_ = make_pipe();
  ChildProcess process_;
  std::string errors_;
  CommandEnd end_;
};

CommandEnd run_command(const std::vector<std::string>& words, std::string_view input, Deadline deadline) {
  const BrokenPipesIgnored ignored;
  return RunningCommand(words, false).run(input, deadline);
}

CommandSession::CommandSession(std::vector<std::string> words) : words_(std::move(words)) {}

CommandSession::~CommandSession() = default;

CommandEnd CommandSession::ask(std::string_view line, Deadline deadline) {
  const BrokenPipesIgnored ignored;
  if (!running_) running_ = std::make_unique<RunningCommand>(words_, true);
  CommandEnd end = running_->run(line, deadline);
  if (running_->has_ended()) running_.reset();
  return end;
}

}  // namespace signorini
