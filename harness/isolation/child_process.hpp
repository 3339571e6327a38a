#pragma once
// A forked process in a process group of its own, and the pipes between it and its parent.

#include <sys/types.h>
#include <unistd.h>

#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

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

/// A pipe that no program inherits. \throws std::system_error
Pipe make_pipe();

/// Reads and writes of it return at once, with EAGAIN where they would have to wait.
void set_non_blocking(const Descriptor& descriptor);

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

/// A child process that leads a process group of its own, has the default signal handlers and none of the
/// parent's open files, and dies with the parent. It is killed with its whole group when this object is
/// destroyed. The parent must have no other threads.
class ChildProcess {
 public:
  /// Forks and calls `body` in the child, whose exit code is 0 once it returns. `body` must not throw.
  /// \param kept  a descriptor that stays open in the child beside the standard streams; -1: none
  /// \throws std::system_error if no process can be made
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
  /// Processor time so far of the child, of what has ended below it, and of what runs there, in steps of some
  /// 10 ms [s].
  [[nodiscard]] double processor_seconds() const;
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

}  // namespace signorini
