#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/isolation/child_process.hpp"

namespace signorini {

namespace {

constexpr std::size_t kMostOutput = std::size_t{1} << 30U;  // bytes
constexpr std::size_t kLastWords = 400;                     // bytes

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

/// Replaces this process by the command.
[[noreturn]] void execute(const std::vector<std::string>& words) {
  rlimit files{};  // the process of a run may write little, its command what it wants
  if (getrlimit(RLIMIT_FSIZE, &files) == 0) {
    files.rlim_cur = files.rlim_max;
    setrlimit(RLIMIT_FSIZE, &files);
  }
  for (const char* variable : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"})
    setenv(variable, "1", 1);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  const std::string reason = words[0] + ": " + std::strerror(errno) + "\n";
  static_cast<void>(!::write(STDERR_FILENO, reason.data(), reason.size()));
  constexpr int kNotExecuted = 127;  // as a shell says
  _exit(kNotExecuted);
}

/// A started command with its three pipes.
class RunningCommand {
 public:
  RunningCommand(const std::vector<std::string>& words, std::string_view input)
      : input_(input),
        process_({.in = in_.read.number(), .out = out_.write.number(), .err = err_.write.number()}, -1,
                 [&words] { execute(words); }) {
    in_.read.reset();
    out_.write.reset();
    err_.write.reset();
    for (const Descriptor* end : {&in_.write, &out_.read, &err_.read}) set_non_blocking(*end);
  }

  CommandEnd run(Deadline deadline) {
    while (!process_.has_ended() && end_.output.size() <= kMostOutput) {
      if (std::chrono::steady_clock::now() >= deadline) {
        end_.expired = true;
        break;
      }
      wait(deadline);
      write_input();
      read_output();
    }
    const bool too_much = end_.output.size() > kMostOutput;
    const int status = process_.reap();
    read_output();  // what was printed since the last look
    if (!end_.expired) take_status(status);
    if (too_much) end_.failure = fmt::format("the command printed more than {} bytes", kMostOutput);
    end_.last_words =
        last_line(errors_.size() > kLastWords ? errors_.substr(errors_.size() - kLastWords) : errors_);
    return std::move(end_);
  }

 private:
  /// Until something can be read or written, the command has ended, or the deadline has passed.
  void wait(Deadline deadline) {
    // Without a descriptor for its end, only looking often tells that the command has ended.
    const auto look = std::chrono::milliseconds(process_.end_descriptor() >= 0 ? 1000 : 5);
    std::array<pollfd, 4> places{{{.fd = in_.write.number(), .events = POLLOUT, .revents = 0},
                                  {.fd = out_.read.number(), .events = POLLIN, .revents = 0},
                                  {.fd = err_.read.number(), .events = POLLIN, .revents = 0},
                                  {.fd = process_.end_descriptor(), .events = POLLIN, .revents = 0}}};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(
        std::min<Deadline::duration>(deadline - std::chrono::steady_clock::now(), look));
    poll(places.data(), places.size(), static_cast<int>(std::max<long>(left.count(), 0)));
  }

  void write_input() {
    while (in_.write.is_open()) {
      if (input_.empty()) return in_.write.reset();
      const ssize_t written = ::write(in_.write.number(), input_.data(), input_.size());
      if (written < 0 && (errno == EAGAIN || errno == EINTR)) return;
      if (written < 0) return in_.write.reset();  // it reads no more
      input_.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void read_output() {
    read_available(out_.read, end_.output, kMostOutput);
    read_available(err_.read, errors_, kMostOutput);
    if (errors_.size() > 2 * kLastWords) errors_.erase(0, errors_.size() - kLastWords);
  }

  void take_status(int status) {
    if (WIFSIGNALED(status)) {
      end_.signal = WTERMSIG(status);
      end_.failure =
          fmt::format("the command was ended by signal {} ({})", *end_.signal, strsignal(*end_.signal));
    } else if (WEXITSTATUS(status) != EXIT_SUCCESS) {
      end_.failure = fmt::format("the command ended with exit code {}", WEXITSTATUS(status));
    }
  }

  std::string_view input_;
  Pipe in_ = make_pipe(), out_ = make_pipe(), err_ = make_pipe();
  ChildProcess process_;
  std::string errors_;
  CommandEnd end_;
};

}  // namespace

CommandEnd run_command(const std::vector<std::string>& words, std::string_view input, Deadline deadline) {
  const BrokenPipesIgnored ignored;
  return RunningCommand(words, input).run(deadline);
}

}  // namespace signorini
