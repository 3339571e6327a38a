#include "harness/isolation/isolated_child.hpp"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <new>

#include "harness/failure.hpp"

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

/// Limit of processor time, in whole seconds, that one thread cannot reach within this wall time.
rlim_t processor_seconds(double wall_seconds) { return static_cast<rlim_t>(std::ceil(wall_seconds)) + 1; }

void apply_limits(const IsolationLimits& limits) {
  std::signal(SIGXFSZ, SIG_IGN);  // output beyond kLogBytes is truncated and the work goes on
  limit_soft(RLIMIT_FSIZE, kLogBytes);
  limit_soft(RLIMIT_CORE, 0);
  limit_soft(RLIMIT_CPU, processor_seconds(limits.stage_seconds.front()));
#ifndef __SANITIZE_ADDRESS__  // it reserves terabytes of address space
  if (limits.memory_mb) limit_soft(RLIMIT_AS, static_cast<rlim_t>(*limits.memory_mb) << 20U);
#endif
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

}  // namespace

void LineSender::operator()(std::string_view line) const { write_line(pipe_, kLine, line); }

IsolatedChild::IsolatedChild(const IsolatedWork& work, const IsolationLimits& limits)
    : limits_(limits),
      pipe_(make_pipe()),
      log_(memfd_create("log", MFD_CLOEXEC)),
      process_({.out = log_.number(), .err = log_.number()}, pipe_.write.number(), [&] {
        apply_limits(limits);
        run_work(work, pipe_.write.number());
      }) {
  pipe_.write.reset();
  set_non_blocking(pipe_.read);
  begin_stage();
}

void IsolatedChild::begin_stage() {
  const double seconds = limits_.stage_seconds[std::min(end_.lines.size(), limits_.stage_seconds.size() - 1)];
  deadline_ = deadline_after(seconds);
  allowed_seconds_ += seconds;
  rlimit limit{};
  if (prlimit(id(), RLIMIT_CPU, nullptr, &limit) != 0) return;  // it is dead already
  limit.rlim_cur = std::min(processor_seconds(allowed_seconds_), limit.rlim_max);
  prlimit(id(), RLIMIT_CPU, &limit, nullptr);
}

void IsolatedChild::take_line(std::string_view line) {
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

void IsolatedChild::read_lines() {
  read_available(pipe_.read, partial_line_);
  std::size_t begin = 0;
  for (std::size_t end = partial_line_.find('\n'); end != std::string::npos;
       end = partial_line_.find('\n', begin)) {
    take_line(std::string_view(partial_line_).substr(begin, end - begin));
    begin = end + 1;
  }
  partial_line_.erase(0, begin);
}

void IsolatedChild::stop(ChildEnd::Kind reason) {
  stopped_ = reason;
  process_.send_signal(SIGTERM);
  deadline_ = deadline_after(limits_.grace);
}

void IsolatedChild::interrupt() {
  if (!stopped_) stop(ChildEnd::Kind::interrupted);
}

void IsolatedChild::enforce_deadline() {
  if (std::chrono::steady_clock::now() < deadline_) return;
  if (!stopped_) {
    stop(ChildEnd::Kind::timed_out);
  } else {
    process_.send_signal(SIGKILL);
  }
}

void IsolatedChild::collect() {
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

bool IsolatedChild::advance() {
  read_lines();
  if (process_.has_ended()) {
    collect();
    return true;
  }
  enforce_deadline();
  return false;
}

}  // namespace signorini
