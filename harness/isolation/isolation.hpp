#pragma once
// Work in child processes that may crash, hang or leak without harm to anyone else.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// What a child may use.
struct IsolationLimits {
  /// Processor time, its descendants' included, until each line that the child sends [s]; the last one holds
  /// for all later lines and the end. What sleeps uses it, too; what waits for a processor does not, up to
  /// Deadline::kWallPerProcessor times as much wall time. The system ends a process that has all of it so far
  /// and one second more.
  std::vector<double> stage_seconds{30.0};
  /// After the last one they begin anew with the first, in place of the last one holding.
  bool repeated = false;
  double grace = 0.5;  ///< from SIGTERM to SIGKILL [s]
  /// Address space beyond that of the program and its libraries [MiB]; not enforced under the address
  /// sanitizer.
  std::optional<long> memory_mb{};
};

/// How a child ended and what it had sent until then.
struct ChildEnd {
  enum class Kind {
    finished,               ///< the work returned
    threw,                  ///< the work threw an exception; `detail` is its text
    out_of_memory,          ///< the work threw std::bad_alloc
    exited,                 ///< the process ended with `code` before the work returned
    signalled,              ///< signal `code` ended the process
    timed_out,              ///< the parent ended it at its limit of processor or wall time
    out_of_processor_time,  ///< the system ended it at its limit of processor time
    flooded,                ///< the parent ended it because it sent a line without end
    interrupted             ///< the parent ended it because it was itself asked to stop (SIGINT, SIGTERM)
  };
  Kind kind = Kind::finished;
  int code = 0;
  std::string detail = {};      ///< text of the exception
  std::string last_words = {};  ///< last line on stdout or stderr, to explain a crash
  /// Complete lines, in the order they were sent; empty ones where OnLine took them.
  std::vector<std::string> lines = {};
  double seconds = 0.0;  ///< wall time from its start to its end [s]
};

/// "signal 11 (Segmentation fault): last words" and so on, one phrase for a person.
std::string describe(const ChildEnd& end);

/// The child's way to its parent.
class LineSender {
 public:
  explicit LineSender(int pipe) : pipe_(pipe) {}
  /// Hands one line to the parent at once; line breaks in it become blanks.
  void operator()(std::string_view line) const;

 private:
  int pipe_;
};

using IsolatedWork = std::function<void(const LineSender& send)>;

/// Runs the work in a forked child with its own process group. However the child ends, the group is killed as
/// a whole, and so are its descendants that left the group; it dies with the parent. The parent must have no
/// other threads and no other children. \throws MachineFull if no process can be made
ChildEnd run_isolated(const IsolatedWork& work, const IsolationLimits& limits);

/// Called with each end as soon as it is known.
using OnEnd = std::function<void(std::size_t index, const ChildEnd& end)>;

/// Called with each line as soon as it has arrived, which it takes.
using OnLine = std::function<void(std::size_t index, std::string line)>;

/// Several at the same time, at most `parallel`; results in the order of the work.
std::vector<ChildEnd> run_isolated_together(const std::vector<IsolatedWork>& work,
                                            const IsolationLimits& limits, int parallel,
                                            const OnEnd& on_end = {}, const OnLine& on_line = {});

}  // namespace signorini
