#include "harness/isolation/isolation.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/child_process.hpp"
#include "harness/plan/deadline.hpp"
#include "methods/plugin/sanitizer.hpp"
#include "methods/solvers/dense_products.hpp"

namespace signorini {

namespace {

// First character of every line in the pipe: a line that the work sends, or how the work ended.
constexpr char kLine = 'L';
constexpr char kFinished = 'F';
constexpr char kThrew = 'X';
constexpr char kOutOfMemory = 'M';

constexpr rlim_t kLogBytes = 1U << 20U;
constexpr off_t kLastWordsBytes = 400;

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(EXIT_FAILURE);  // the parent reads no longer
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_line(int descriptor, char tag, std::string_view text) {
  std::string line(1, tag);
  line += text;
  std::replace(line.begin() + 1, line.end(), '\n', ' ');
  line += '\n';
  write_all(descriptor, line);
}

void limit_soft(int resource, rlim_t value) {
  rlimit limit{};
  getrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
  limit.rlim_cur = std::min(value, limit.rlim_max);
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// Limit of processor time that the system keeps, in whole seconds: later than the parent ends a child.
rlim_t processor_seconds(double seconds) {
  constexpr double kForever = 1e12;
  return seconds < kForever ? static_cast<rlim_t>(std::ceil(seconds)) + 1 : RLIM_INFINITY;
}

/// Address space that this process has mapped [bytes].
rlim_t mapped_bytes() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// The program, its libraries and the work space of the BLAS are a quarter of a gigabyte, whatever the work.
void limit_memory(long megabytes) {
  map_work_space_of_products();
  limit_soft(RLIMIT_AS, mapped_bytes() + (static_cast<rlim_t>(megabytes) << 20U));
}

void apply_limits(const IsolationLimits& limits) {
  std::signal(SIGXFSZ, SIG_IGN);  // output beyond kLogBytes is truncated and the work goes on
  limit_soft(RLIMIT_FSIZE, kLogBytes);
  limit_soft(RLIMIT_CORE, 0);
  limit_soft(RLIMIT_CPU, processor_seconds(limits.stage_seconds.front()));
  if (limits.memory_mb && !kAddressSanitizer) limit_memory(*limits.memory_mb);
}

void run_work(const IsolatedWork& work, int pipe) {
  try {
    work(LineSender(pipe));
    write_line(pipe, kFinished, "");
  } catch (const std::bad_alloc&) {
    limit_soft(RLIMIT_AS, RLIM_INFINITY);  // the line needs memory too
    write_line(pipe, kOutOfMemory, "");
  } catch (...) {
    write_line(pipe, kThrew, current_exception_text());
  }
}

std::string last_line_of_file(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, kLastWordsBytes)), '\0');
  const ssize_t got = pread(file, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return last_line(text);
}

std::string with_last_words(std::string text, const ChildEnd& end) {
  return end.last_words.empty() ? text : fmt::format("{}: {}", text, end.last_words);
}

/// One child process that runs a piece of work under limits and sends lines to its parent.
class IsolatedChild {
 public:
  /// Forks. \throws MachineFull
  IsolatedChild(const IsolatedWork& work, const IsolationLimits& limits)
      : limits_(limits),
        pipe_(make_pipe()),
        log_(make_memory_file()),
        process_({.out = log_.number(), .err = log_.number()}, pipe_.write.number(), [&] {
          apply_limits(limits);
          run_work(work, pipe_.write.number());
        }) {
    pipe_.write.reset();
    set_non_blocking(pipe_.read);
    begin_stage();
  }

  [[nodiscard]] pid_t id() const { return process_.id(); }
  /// Descriptors to poll: one is readable when `advance` has something to do. -1: none.
  [[nodiscard]] int line_descriptor() const { return pipe_.read.number(); }
  [[nodiscard]] int end_descriptor() const { return process_.end_descriptor(); }

  /// Reads the lines that have arrived, enforces the limits, collects a dead child. True once it has ended.
  bool advance() {
    read_lines();
    if (process_.has_ended()) {
      collect();
      return true;
    }
    enforce_deadline();
    return false;
  }

  /// Asks the child to end; `advance` then collects it.
  void interrupt() {
    if (!stopped_) stop(ChildEnd::Kind::interrupted);
  }

  /// Those that have arrived so far; they may be taken out of their strings.
  [[nodiscard]] std::vector<std::string>& lines() { return end_.lines; }
  /// Valid once `advance` has returned true.
  [[nodiscard]] ChildEnd take_end() { return std::move(end_); }

 private:
  /// Sets the limits of processor and wall time for what comes until the next line.
  void begin_stage() {
    const std::size_t stages = limits_.stage_seconds.size(), stage = end_.lines.size();
    const double seconds =
        limits_.stage_seconds[limits_.repeated ? stage % stages : std::min(stage, stages - 1)];
    allowance_ = ChildAllowance(process_, seconds);
    allowed_seconds_ += seconds;
    rlimit limit{};
    if (prlimit(id(), RLIMIT_CPU, nullptr, &limit) != 0) return;  // it is dead already
    limit.rlim_cur = std::min(processor_seconds(allowed_seconds_), limit.rlim_max);
    prlimit(id(), RLIMIT_CPU, &limit, nullptr);
  }

  void take_line(std::string_view line) {
    const char tag = line.empty() ? '\0' : line.front();
    if (tag == kLine) {
      end_.lines.emplace_back(line.substr(1));
      if (!stopped_) begin_stage();
      return;
    }
    if (work_ended_) return;
    work_ended_ = tag == kFinished || tag == kThrew || tag == kOutOfMemory;
    if (tag == kThrew) end_.kind = ChildEnd::Kind::threw;
    if (tag == kOutOfMemory) end_.kind = ChildEnd::Kind::out_of_memory;
    if (work_ended_) end_.detail = line.substr(1);
  }

  void read_lines() {
    read_available(pipe_.read, partial_line_, kLongestLine);
    std::size_t begin = 0;
    // What was searched before holds no line break: a child that sends none must not be searched anew each
    // time.
    for (std::size_t end = partial_line_.find('\n', searched_); end != std::string::npos;
         end = partial_line_.find('\n', begin)) {
      take_line(std::string_view(partial_line_).substr(begin, end - begin));
      begin = end + 1;
    }
    partial_line_.erase(0, begin);
    searched_ = partial_line_.size();
    if (searched_ > kLongestLine && !stopped_) stop(ChildEnd::Kind::flooded);
  }

  void stop(ChildEnd::Kind reason) {
    stopped_ = reason;
    process_.send_signal(SIGTERM);
    end_of_grace_ = Deadline::after_wall(limits_.grace);
  }

  void enforce_deadline() {
    if (!(stopped_ ? end_of_grace_.passed() : allowance_.used(process_))) return;
    if (!stopped_) {
      stop(ChildEnd::Kind::timed_out);
    } else {
      process_.send_signal(SIGKILL);
    }
  }

  void collect() {
    const int status = process_.reap();
    read_lines();  // those sent since the last look
    end_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    end_.last_words = last_line_of_file(log_.number());
    if (work_ended_) return;
    if (stopped_) {
      end_.kind = *stopped_;
    } else if (WIFSIGNALED(status)) {
      end_.code = WTERMSIG(status);
      end_.kind = end_.code == SIGXCPU ? ChildEnd::Kind::out_of_processor_time : ChildEnd::Kind::signalled;
    } else {
      end_.kind = ChildEnd::Kind::exited;
      end_.code = WEXITSTATUS(status);
    }
  }

  IsolationLimits limits_;
  Pipe pipe_;
  Descriptor log_;  ///< stdout and stderr of the child, a file in memory
  ChildProcess process_;
  std::string partial_line_;
  std::size_t searched_ = 0;  ///< bytes of it without a line break
  bool work_ended_ = false;   ///< the child reported how its work ended
  std::optional<ChildEnd::Kind> stopped_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ChildAllowance allowance_;      ///< of its stage
  Deadline end_of_grace_;         ///< once it is asked to stop
  double allowed_seconds_ = 0.0;  ///< of all stages so far
  ChildEnd end_;
};

struct RunningChild {
  std::size_t index;
  std::unique_ptr<IsolatedChild> child;
  std::size_t told = 0;  ///< lines that OnLine was called with

  void tell(const OnLine& on_line) {
    for (; on_line && told < child->lines().size(); ++told) on_line(index, std::move(child->lines()[told]));
  }
};

/// Returns when a child has sent something or has ended, or when the limits have to be looked at.
void wait_for_any(const std::vector<RunningChild>& running) {
  constexpr int kLook = 20, kLookForEnd = 1;  // [ms]
  std::vector<pollfd> descriptors;
  int timeout = kLook;
  for (const RunningChild& one : running) {
    for (const int descriptor : {one.child->line_descriptor(), one.child->end_descriptor()}) {
      if (descriptor >= 0) descriptors.push_back({.fd = descriptor, .events = POLLIN, .revents = 0});
    }
    // A child that has closed its pipe is about to end, and without this descriptor nothing tells when.
    if (one.child->line_descriptor() < 0 && one.child->end_descriptor() < 0) timeout = kLookForEnd;
  }
  poll(descriptors.data(), descriptors.size(), timeout);
}

/// Ends this process's children that are not among those running: descendants that left their process group.
/// As this process is a subreaper they become its children when their parents die, and so do their own
/// children in turn.
void end_orphans(const std::vector<RunningChild>& running) {
  for (bool found = true; found;) {
    found = false;
    std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", getpid()));
    for (pid_t child = 0; children >> child;) {
      const auto is_ours = [child](const RunningChild& one) { return one.child->id() == child; };
      if (std::ranges::any_of(running, is_ours)) continue;
      kill(child, SIGKILL);
      found = waitpid(child, nullptr, 0) == child || found;
    }
  }
}

}  // namespace

void LineSender::operator()(std::string_view line) const { write_line(pipe_, kLine, line); }

std::string describe(const ChildEnd& end) {
  switch (end.kind) {
    case ChildEnd::Kind::finished:
      return "finished";
    case ChildEnd::Kind::threw:
      return fmt::format("exception: {}", end.detail);
    case ChildEnd::Kind::out_of_memory:
      return "out of memory";
    case ChildEnd::Kind::exited:
      return with_last_words(fmt::format("the process ended with code {} before an answer", end.code), end);
    case ChildEnd::Kind::signalled:
      return with_last_words(fmt::format("signal {} ({})", end.code, strsignal(end.code)), end);
    case ChildEnd::Kind::timed_out:
      return "stopped at the time limit";
    case ChildEnd::Kind::out_of_processor_time:
      return "stopped at the limit of processor time";
    case ChildEnd::Kind::flooded:
      return "stopped: it wrote more than a record into the pipe of the harness";
    case ChildEnd::Kind::interrupted:
      return "interrupted";
  }
  return {};
}

std::vector<ChildEnd> run_isolated_together(const std::vector<IsolatedWork>& work,
                                            const IsolationLimits& limits, int parallel, const OnEnd& on_end,
                                            const OnLine& on_line) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  std::vector<ChildEnd> ends(work.size());
  std::vector<RunningChild> running;
  std::size_t next = 0;
  while (next < work.size() || !running.empty()) {
    while (next < work.size() && running.size() < static_cast<std::size_t>(parallel) && !interrupted()) {
      running.push_back({next, std::make_unique<IsolatedChild>(work[next], limits)});
      ++next;
    }
    if (interrupted()) {
      for (; next < work.size(); ++next) ends[next].kind = ChildEnd::Kind::interrupted;
      for (const RunningChild& one : running) one.child->interrupt();
    }
    if (running.empty()) break;
    wait_for_any(running);
    std::vector<std::size_t> ended;
    std::erase_if(running, [&](RunningChild& one) {
      const bool has_ended = one.child->advance();
      one.tell(on_line);
      if (!has_ended) return false;
      ends[one.index] = one.child->take_end();
      ended.push_back(one.index);
      return true;
    });
    if (!ended.empty()) end_orphans(running);
    for (const std::size_t index : ended) {
      if (on_end) on_end(index, ends[index]);
    }
  }
  return ends;
}

ChildEnd run_isolated(const IsolatedWork& work, const IsolationLimits& limits) {
  return std::move(run_isolated_together({work}, limits, 1).front());
}

}  // namespace signorini
