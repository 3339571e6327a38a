#include "harness/extend/plugins/command_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

namespace signorini {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostOutput = std::size_t{1} << 30U;  // bytes
constexpr std::size_t kLastWords = 400;                     // bytes

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// A file descriptor that is closed with it.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { reset(); }
  void reset() {
    if (number_ >= 0) close(std::exchange(number_, -1));
  }
  [[nodiscard]] int number() const { return number_; }  ///< -1: closed

 private:
  int number_;
};

struct Pipe {
  Descriptor read, write;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// A command that stops reading is no reason for this process to die.
class BrokenPipesIgnored {
 public:
  BrokenPipesIgnored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~BrokenPipesIgnored() { std::signal(SIGPIPE, before_); }
  BrokenPipesIgnored(const BrokenPipesIgnored&) = delete;
  BrokenPipesIgnored& operator=(const BrokenPipesIgnored&) = delete;

 private:
  void (*before_)(int);
};

[[noreturn]] void become(const std::vector<std::string>& words, pid_t parent, const Pipe& in, const Pipe& out,
                         const Pipe& err) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGXFSZ}) std::signal(signal, SIG_DFL);
  dup2(in.read.number(), STDIN_FILENO);
  dup2(out.write.number(), STDOUT_FILENO);
  dup2(err.write.number(), STDERR_FILENO);
  close_range(STDERR_FILENO + 1, ~0U, 0);
  rlimit files{};  // the limit on the talk of the process of a run is none on what its command writes
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
  const std::string reason = std::string(words[0]) + ": " + std::strerror(errno) + "\n";
  static_cast<void>(!write(STDERR_FILENO, reason.data(), reason.size()));
  _exit(127);
}

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  const std::size_t begin = text.find_last_of('\n');
  return begin == std::string::npos ? text : text.substr(begin + 1);
}

/// A started command: feeds it, listens to it, ends it.
class Session {
 public:
  Session(const std::vector<std::string>& words, std::string_view input) : input_(input) {
    Pipe in = make_pipe(), out = make_pipe(), err = make_pipe();
    const pid_t parent = getpid();
    child_ = fork();
    if (child_ < 0) fail("fork");
    if (child_ == 0) become(words, parent, in, out, err);
    setpgid(child_, child_);  // in both processes: whoever comes first
    in_ = std::move(in.write);
    out_ = std::move(out.read);
    err_ = std::move(err.read);
    for (const Descriptor* end : {&in_, &out_, &err_}) fcntl(end->number(), F_SETFL, O_NONBLOCK);
    ended_ = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, child_, 0)));  // not in every glibc
  }
  ~Session() {
    if (child_ > 0) reap();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  CommandEnd run(Clock::time_point deadline) {
    while (!over_ && end_.output.size() <= kMostOutput) {
      if (Clock::now() >= deadline) {
        end_.expired = true;
        break;
      }
      wait(deadline);
      feed();
      listen(out_, end_.output);
      listen(err_, talk_);
      if (talk_.size() > 2 * kLastWords) talk_.erase(0, talk_.size() - kLastWords);
    }
    const bool too_much = end_.output.size() > kMostOutput;
    const int status = reap();
    listen(out_, end_.output);  // what was printed last
    listen(err_, talk_);
    if (!end_.expired) take_status(status);
    if (too_much) end_.failure = fmt::format("the command printed more than {} bytes", kMostOutput);
    end_.last_words = last_line(talk_.size() > kLastWords ? talk_.substr(talk_.size() - kLastWords) : talk_);
    return std::move(end_);
  }

 private:
  /// Until something can be read or written, the command has ended, or it must be looked at anyway.
  void wait(Clock::time_point deadline) {
    const auto look = std::chrono::milliseconds(ended_.number() >= 0 ? 1000 : 5);
    std::array<pollfd, 4> places{{{.fd = in_.number(), .events = POLLOUT, .revents = 0},
                                  {.fd = out_.number(), .events = POLLIN, .revents = 0},
                                  {.fd = err_.number(), .events = POLLIN, .revents = 0},
                                  {.fd = ended_.number(), .events = POLLIN, .revents = 0}}};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(
        std::min<Clock::duration>(deadline - Clock::now(), look));
    poll(places.data(), places.size(), static_cast<int>(std::max<long>(left.count(), 0)));
    siginfo_t info{};
    over_ = waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            info.si_pid == child_;
  }

  void feed() {
    while (in_.number() >= 0) {
      if (input_.empty()) return in_.reset();
      const ssize_t written = write(in_.number(), input_.data(), input_.size());
      if (written < 0 && (errno == EAGAIN || errno == EINTR)) return;
      if (written < 0) return in_.reset();  // it reads no more
      input_.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  static void listen(Descriptor& from, std::string& text) {
    std::array<char, 1U << 16U> buffer{};
    while (from.number() >= 0 && text.size() <= kMostOutput) {
      const ssize_t got = read(from.number(), buffer.data(), buffer.size());
      if (got < 0) return;
      if (got == 0) return from.reset();
      text.append(buffer.data(), static_cast<std::size_t>(got));
    }
  }

  /// Ends the whole group; the command is not reaped before, so the group's number is still its own.
  int reap() {
    kill(-child_, SIGKILL);
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return status;
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
  pid_t child_ = -1;
  Descriptor in_, out_, err_, ended_;
  std::string talk_;
  bool over_ = false;
  CommandEnd end_;
};

}  // namespace

CommandEnd run_command(const std::vector<std::string>& words, std::string_view input,
                       Clock::time_point deadline) {
  const BrokenPipesIgnored quiet;
  return Session(words, input).run(deadline);
}

}  // namespace signorini
