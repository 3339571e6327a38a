#include "harness/isolation/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/process_state.hpp"

namespace signorini {

namespace {

// Short of processes, descriptors or memory: no fault of this program, and nothing to report.
[[noreturn]] void refuse_surroundings(const char* wanted) {
  throw MachineFull("machine = full (must allow {}: {})", wanted,
                    std::error_code(errno, std::generic_category()).message());
}

// Where there are too many processes, some are about to end.
pid_t fork_patiently() {
  constexpr int kTries = 40;
  constexpr std::chrono::milliseconds kPause(50);
  pid_t id = fork();
  for (int i = 0; id < 0 && errno == EAGAIN && i < kTries; ++i) {
    std::this_thread::sleep_for(kPause);
    id = fork();
  }
  return id;
}

/// Closes every descriptor above stderr except `kept`: a child that kept the parent's locked files open would
/// hold their locks for longer than the parent lives.
void close_all_but(int kept) {
  constexpr unsigned kFirst = STDERR_FILENO + 1;
  if (kept < static_cast<int>(kFirst)) {
    close_range(kFirst, ~0U, 0);
    return;
  }
  const auto number = static_cast<unsigned>(kept);
  if (number > kFirst) close_range(kFirst, number - 1, 0);
  close_range(number + 1, ~0U, 0);
}

/// Time that the threads of a process have waited for a processor, infinite where the system does not tell
/// [s].
double waiting_seconds_of(const std::string& folder) {
  double seconds = 0.0;
  std::error_code gone;  // a thread may end, and the process with it
  for (const auto& thread : std::filesystem::directory_iterator(folder + "/task", gone)) {
    std::ifstream schedstat(thread.path() / "schedstat");
    double running = 0.0, waiting = std::numeric_limits<double>::infinity();
    schedstat >> running >> waiting;  // [ns]
    seconds += 1e-9 * waiting;
  }
  return seconds;
}

/// Those of a process, of its children that it has waited for, and of those that run.
ChildTimes times_of(pid_t process) {
  const std::string folder = "/proc/" + std::to_string(process);
  std::ifstream stat(folder + "/stat");
  std::string text;
  std::getline(stat, text);
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));  // from the third on
  constexpr int kFirstTime = 14, kLastTime = 17;  // of both in user and system mode (proc(5))
  double ticks = 0.0;
  for (int field = 3; field <= kLastTime && fields >> text; ++field)
    if (field >= kFirstTime) ticks += std::strtod(text.c_str(), nullptr);
  ChildTimes times{ticks / static_cast<double>(sysconf(_SC_CLK_TCK)), waiting_seconds_of(folder)};
  std::ifstream children(folder + "/task/" + std::to_string(process) + "/children");
  for (pid_t child = 0; children >> child;) {
    const ChildTimes below = times_of(child);
    times.processor += below.processor;
    times.waiting += below.waiting;
  }
  return times;
}

void prepare_child(pid_t parent, const StandardStreams& streams, int kept) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);  // the parent died before prctl
  for (const int signal :
       {SIGINT, SIGTERM, SIGPIPE, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGXCPU, SIGXFSZ}) {
    std::signal(signal, SIG_DFL);
  }
  if (streams.in >= 0) dup2(streams.in, STDIN_FILENO);
  if (streams.out >= 0) dup2(streams.out, STDOUT_FILENO);
  if (streams.err >= 0) dup2(streams.err, STDERR_FILENO);
  close_all_but(kept);
}

}  // namespace

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) refuse_surroundings("another pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Descriptor make_memory_file() {
  Descriptor file(memfd_create("log", MFD_CLOEXEC));
  if (!file.is_open()) refuse_surroundings("another file");
  return file;
}

void set_non_blocking(const Descriptor& descriptor) { fcntl(descriptor.number(), F_SETFL, O_NONBLOCK); }

void read_available(Descriptor& from, std::string& text, std::size_t most) {
  std::array<char, 1U << 16U> buffer{};
  while (from.is_open() && text.size() <= most) {
    const ssize_t got = read(from.number(), buffer.data(), buffer.size());
    if (got < 0) return;  // nothing yet, or a signal: the caller polls again
    if (got == 0) return from.reset();
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

std::string last_line(std::string_view text) {
  const std::size_t last = text.find_last_not_of("\n ");
  if (last == std::string_view::npos) return {};
  text = text.substr(0, last + 1);
  const std::size_t line_break = text.find_last_of('\n');
  return std::string(line_break == std::string_view::npos ? text : text.substr(line_break + 1));
}

ChildProcess::Side ChildProcess::fork_process(const StandardStreams& streams, int kept) {
  // Else the child would print what the parent has buffered a second time.
  std::fflush(nullptr);
  std::cout.flush();
  compute_on_one_thread();  // a test or a plugin may have set another number
  const pid_t parent = getpid();
  const double used = Deadline::processor_now();
  id_ = fork_patiently();
  if (id_ < 0) refuse_surroundings("another process");
  if (id_ == 0) {
    Deadline::go_on_from(used);
    prepare_child(parent, streams, kept);
    return Side::child;
  }
  setpgid(id_, id_);  // both processes do so, because either may run first
  end_ = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, id_, 0)));
  return Side::parent;
}

ChildProcess::~ChildProcess() {
  if (id_ > 0) reap();
}

bool ChildProcess::has_ended() const {
  siginfo_t info{};
  if (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return errno == ECHILD;
  return info.si_pid == id_;
}

ChildTimes ChildProcess::times() const { return times_of(id_); }

ChildAllowance::ChildAllowance(const ChildProcess& child, double seconds)
    : seconds_(seconds), before_(child.times()) {}

bool ChildAllowance::used(const ChildProcess& child) const {
  const double wall = wall_seconds();
  if (wall <= seconds_) return false;  // of either time it has no more than has passed
  if (wall > Deadline::kWallPerProcessor * seconds_) return true;
  const ChildTimes now = child.times();
  return now.processor - before_.processor > seconds_ || wall - (now.waiting - before_.waiting) > seconds_;
}

void ChildProcess::send_signal(int signal) const { kill(-id_, signal); }

int ChildProcess::reap() {
  // The number of the group cannot have been given away: the child, dead or not, has not been waited for.
  send_signal(SIGKILL);
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  // Where this process is a subreaper (isolation.cpp), the rest of the group are its children by now.
  constexpr int kMostWaits = 100;
  for (int i = 0; i < kMostWaits && waitpid(-id_, nullptr, WNOHANG) >= 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  id_ = -1;
  return status;
}

ProgramEnd run_to_end(const std::vector<std::string>& words, std::size_t most) {
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  arguments.push_back(nullptr);
  constexpr int kLook = 50;                                           // [ms]
  constexpr std::chrono::seconds kGrace(5);                           // for a launcher to end its processes
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));  // launchers read what is not for them
  Pipe pipe = make_pipe();
  ChildProcess child({.in = nothing.number(), .out = pipe.write.number(), .err = -1}, -1, [&] {
    execvp(arguments.front(), arguments.data());
    _exit(ProgramEnd::kMissing);
  });
  pipe.write.reset();
  set_non_blocking(pipe.read);
  ProgramEnd end;
  std::optional<std::chrono::steady_clock::time_point> last;  // after an interrupt
  while (!child.has_ended()) {
    std::array<pollfd, 1> waited{{{.fd = pipe.read.number(), .events = POLLIN, .revents = 0}}};
    poll(waited.data(), waited.size(), kLook);
    read_available(pipe.read, end.output, most);
    if (end.output.size() > most) return end;
    if (interrupted() && !last) {
      child.send_signal(SIGTERM);
      last = std::chrono::steady_clock::now() + kGrace;
    }
    if (last && std::chrono::steady_clock::now() > *last) break;
  }
  read_available(pipe.read, end.output, most);
  const int status = child.reap();
  if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
  return end;
}

}  // namespace signorini
