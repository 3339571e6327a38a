#pragma once
// A forked process in a process group of its own, the pipes between it and its parent, and programs of the
// machine that are run to their end for what they print, without a shell.

#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "methods/deadline.hpp"

namespace signorini {

/// A file descriptor, closed by its owner's destructor.
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
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

struct Pipe {
  Descriptor read, write;
};

/// A pipe that no program inherits. \throws MachineFull
Pipe make_pipe();

/// A file in memory that no program inherits. \throws MachineFull
Descriptor make_memory_file();

/// Reads and writes of it return at once, with EAGAIN where they would have to wait.
void set_non_blocking(const Descriptor& descriptor);

/// Longest line that is taken, of a pipe or a file [bytes]: a record with 65,536 instants of ten contacts;
/// one with waveforms has some 10^5.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 26U;

/// Appends to `text` what a non-blocking descriptor has to read, until `text` is longer than `most` bytes;
/// closes the descriptor at the end of its input.
void read_available(Descriptor& from, std::string& text,
                    std::size_t most = std::numeric_limits<std::size_t>::max());

/// The last line of a text, without the blanks and line breaks at its end.
std::string last_line(std::string_view text);

/// The descriptors that become stdin, stdout and stderr of a child; -1: those of the parent.
struct StandardStreams {
  int in = -1, out = -1, err = -1;
};

/// What a child and those below it have taken.
struct ChildTimes {
  double processor = 0.0;  ///< that of what has ended below it, too, in steps of some 10 ms [s]
  /// For which threads that are there could have run and had no processor, added up; infinite where the
  /// system does not tell [s]
  double waiting = 0.0;
};

/// A child process that leads a process group of its own, has the default signal handlers and none of the
/// parent's open files, and dies with the parent. It is killed with its whole group when this object is
/// destroyed. The parent must have no other threads.
class ChildProcess {
 public:
  /// Forks and calls `body` in the child, whose exit code is 0 once it returns. `body` must not throw.
  /// \param kept  a descriptor that stays open in the child beside the standard streams; -1: none
  /// \throws MachineFull if no process can be made
  template <std::invocable Body>
  ChildProcess(const StandardStreams& streams, int kept, const Body& body) {
    if (fork_process(streams, kept) == Side::parent) return;
    body();
    _exit(EXIT_SUCCESS);
  }
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }
  /// Whether the child itself has ended; the rest of its group may still run.
  [[nodiscard]] bool has_ended() const;
  /// Readable, for poll(2), once the child has ended; -1 on systems that offer no such descriptor.
  [[nodiscard]] int end_descriptor() const { return end_.number(); }
  [[nodiscard]] ChildTimes times() const;  ///< so far
  /// Sends a signal to the whole group.
  void send_signal(int signal) const;
  /// Kills what is left of the group and waits for the child; to be called once. \return as of waitpid(2)
  int reap();

 private:
  enum class Side { parent, child };
  Side fork_process(const StandardStreams& streams, int kept);

  pid_t id_ = -1;
  Descriptor end_;
};

/// The time that a child may take from now on: processor time, or wall time in which none of its threads
/// waited for a processor. What sleeps uses it, and other work on the machine does not, up to
/// Deadline::kWallPerProcessor times as much wall time.
class ChildAllowance {
 public:
  ChildAllowance() = default;  ///< endless
  /// \param seconds  what it may take [s]
  ChildAllowance(const ChildProcess& child, double seconds);
  /// Whether the child has taken it.
  [[nodiscard]] bool used(const ChildProcess& child) const;
  /// Wall time that passes at least before it can be used, negative once that has passed [s].
  [[nodiscard]] double least_wait() const { return seconds_ - wall_seconds(); }

 private:
  [[nodiscard]] double wall_seconds() const {
    return std::chrono::duration<double>(Deadline::Clock::now() - start_).count();
  }

  double seconds_ = std::numeric_limits<double>::infinity();
  Deadline::Clock::time_point start_ = Deadline::Clock::now();
  ChildTimes before_;
};

/// How a program ended.
struct ProgramEnd {
  std::string output = {};  ///< what it wrote to standard output
  int code = -1;            ///< its exit code, -1 where a signal ended it

  /// Whether there was no such program.
  [[nodiscard]] bool missing() const { return code == kMissing; }

  static constexpr int kMissing = 127;  ///< as shells say it
};

/// Runs a program that is looked for in $PATH, with nothing on standard input. An interrupt of this one, once
/// it watches them, ends it, and so does more than `most` bytes of output; in both cases `code` says nothing.
/// \param words  its name and its arguments \throws MachineFull where no process can be made
ProgramEnd run_to_end(const std::vector<std::string>& words,
                      std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace signorini
