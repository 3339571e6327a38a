#include "harness/run/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>
#include <system_error>
#include <thread>

#include "harness/failure.hpp"

namespace signorini {

namespace {

// First character of every line in the pipe.
constexpr char kData = 'D';
constexpr char kFinished = 'F';
constexpr char kThrew = 'X';
constexpr char kOutOfMemory = 'M';

constexpr rlim_t kLogBytes = 1U << 20U;
constexpr off_t kLastWordsBytes = 400;

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(EXIT_FAILURE);  // nobody listens any more
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void send_line(int descriptor, char tag, std::string_view text) {
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

/// Whole seconds that a soft limit of processor time can be set to, above what wall time allows one thread.
rlim_t processor_seconds(double wall_seconds) { return static_cast<rlim_t>(std::ceil(wall_seconds)) + 1; }

/// The parent's files are none of the child's business, and locks on them would outlive the parent.
void close_all_but(int descriptor) {
  const auto kept = static_cast<unsigned>(descriptor);
  if (kept > STDERR_FILENO + 1) close_range(STDERR_FILENO + 1, kept - 1, 0);
  close_range(kept + 1, ~0U, 0);
}

void prepare_child(pid_t parent, int pipe, int log, const IsolationLimits& limits) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);  // the parent died before the line above
  for (const int signal : {SIGINT, SIGTERM, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // too much talk is cut off, not punished
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  close_all_but(pipe);
  limit_soft(RLIMIT_FSIZE, kLogBytes);
  limit_soft(RLIMIT_CORE, 0);
  limit_soft(RLIMIT_CPU, processor_seconds(limits.stage_seconds.front()));
#ifndef __SANITIZE_ADDRESS__
  if (limits.memory_mb) limit_soft(RLIMIT_AS, static_cast<rlim_t>(*limits.memory_mb) << 20U);
#endif
}

[[noreturn]] void run_child(const IsolatedWork& work, int pipe) {
  try {
    work([pipe](std::string_view line) { send_line(pipe, kData, line); });
    send_line(pipe, kFinished, "");
  } catch (const std::bad_alloc&) {
    limit_soft(RLIMIT_AS, RLIM_INFINITY);
    send_line(pipe, kOutOfMemory, "");
  } catch (...) {
    send_line(pipe, kThrew, current_exception_text());
  }
  _exit(EXIT_SUCCESS);
}

std::string last_line(int log) {
  const off_t size = lseek(log, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, kLastWordsBytes)), '\0');
  const ssize_t got = pread(log, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t begin = text.find_last_of('\n');
  return begin == std::string::npos ? text : text.substr(begin + 1);
}

}  // namespace

ChildProcess::ChildProcess(const IsolatedWork& work, const IsolationLimits& limits) : limits_(limits) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  log_ = memfd_create("log", MFD_CLOEXEC);
  std::fflush(nullptr);  // or the child would print the parent's unwritten text once more
  std::cout.flush();
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ < 0) {
    const int reason = errno;
    close(ends[0]);
    close(ends[1]);
    if (log_ >= 0) close(log_);
    throw std::system_error(reason, std::generic_category(), "fork");
  }
  if (child_ == 0) {
    prepare_child(parent, ends[1], log_, limits_);
    run_child(work, ends[1]);
  }
  setpgid(child_, child_);  // in both processes: whoever comes first
  close(ends[1]);
  pipe_ = ends[0];
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
  begin_stage();
}

ChildProcess::~ChildProcess() {
  if (child_ > 0) {
    kill(-child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  if (pipe_ >= 0) close(pipe_);
  if (log_ >= 0) close(log_);
}

void ChildProcess::begin_stage() {
  const double seconds = limits_.stage_seconds[std::min(end_.lines.size(), limits_.stage_seconds.size() - 1)];
  deadline_ =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  allowed_seconds_ += seconds;
  rlimit limit{};
  if (prlimit(child_, RLIMIT_CPU, nullptr, &limit) != 0) return;  // it is dead already
  limit.rlim_cur = std::min(processor_seconds(allowed_seconds_), limit.rlim_max);
  prlimit(child_, RLIMIT_CPU, &limit, nullptr);
}

void ChildProcess::take_line(std::string line) {
  const char tag = line.empty() ? '\0' : line.front();
  if (tag == kData) {
    end_.lines.push_back(line.substr(1));
    if (!stopped_) begin_stage();
    return;
  }
  if (told_end_) return;
  told_end_ = tag == kFinished || tag == kThrew || tag == kOutOfMemory;
  if (tag == kThrew) end_.kind = ChildEnd::Kind::threw;
  if (tag == kOutOfMemory) end_.kind = ChildEnd::Kind::out_of_memory;
  if (told_end_) end_.detail = line.substr(1);
}

void ChildProcess::read_pipe() {
  std::array<char, 1U << 16U> buffer{};
  while (pipe_ >= 0) {
    const ssize_t got = read(pipe_, buffer.data(), buffer.size());
    if (got < 0) return;  // nothing yet, or a signal: `advance` will be called again
    if (got == 0) {
      close(pipe_);
      pipe_ = -1;
      return;
    }
    partial_.append(buffer.data(), static_cast<std::size_t>(got));
    std::size_t begin = 0;
    for (std::size_t end = partial_.find('\n'); end != std::string::npos; end = partial_.find('\n', begin)) {
      take_line(partial_.substr(begin, end - begin));
      begin = end + 1;
    }
    partial_.erase(0, begin);
  }
}

void ChildProcess::stop(ChildEnd::Kind reason) {
  stopped_ = reason;
  kill(-child_, SIGTERM);
  deadline_ = Clock::now() +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits_.grace));
}

void ChildProcess::interrupt() {
  if (!stopped_) stop(ChildEnd::Kind::interrupted);
}

void ChildProcess::enforce_deadline() {
  if (Clock::now() < deadline_) return;
  if (!stopped_) {
    stop(ChildEnd::Kind::timed_out);
  } else {
    kill(-child_, SIGKILL);
  }
}

void ChildProcess::collect() {
  // The child is dead but not yet reaped, so its group's number is still its own: end the rest of it.
  kill(-child_, SIGKILL);
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  // Descendants whose parent died are ours now (subreaper): no zombies stay.
  for (int i = 0; i < 100 && waitpid(-child_, nullptr, WNOHANG) >= 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  read_pipe();
  end_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  end_.last_words = last_line(log_);
  if (!told_end_) {
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
  child_ = -1;
}

bool ChildProcess::advance() {
  read_pipe();
  siginfo_t info{};
  const int found = waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT);
  if (found == 0 && info.si_pid == child_) {
    collect();
    return true;
  }
  enforce_deadline();
  return false;
}

}  // namespace signorini
