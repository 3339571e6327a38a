#pragma once
// Work in a child process that may crash, hang or leak without harm to anyone else.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// What a child may use.
struct IsolationLimits {
  /// Wall time until each line that the child sends [s]; the last one holds for all later lines and the end.
  /// Of processor time it may use as much since its start, and a second more: enough for one thread.
  std::vector<double> stage_seconds{30.0};
  double grace = 0.5;               ///< from SIGTERM to SIGKILL [s]
  std::optional<long> memory_mb{};  ///< address space [MiB]; not enforced under the address sanitizer
};

/// Hands one line (without line breaks) to the parent at once.
using Send = std::function<void(std::string_view line)>;
using IsolatedWork = std::function<void(const Send& send)>;

/// How a child ended and what it had sent until then.
struct ChildEnd {
  enum class Kind {
    finished,       ///< the work returned
    threw,          ///< an exception left it; `detail` is its text
    out_of_memory,  ///< std::bad_alloc left it
    exited,         ///< the process ended with `code` before the work did
    signalled,      ///< signal `code` ended it
    timed_out,      ///< the parent ended it
    out_of_processor_time,
    interrupted  ///< the parent was asked to stop (SIGINT) and ended it
  };
  Kind kind = Kind::finished;
  int code = 0;
  std::string detail = {};              ///< what an exception said
  std::string last_words = {};          ///< last line on stdout or stderr, to explain a crash
  std::vector<std::string> lines = {};  ///< in order, whole ones only
  double seconds = 0.0;                 ///< wall time from its start to its end [s]
};

/// Runs the work in a forked child with its own process group, which is killed as a whole at the end,
/// however it came, with descendants that left the group; it dies with the parent. The parent must have no
/// other threads and no other children.
/// \throws std::system_error if no process can be made
ChildEnd run_isolated(const IsolatedWork& work, const IsolationLimits& limits);

/// Told of each end as it comes.
using OnEnd = std::function<void(std::size_t index, const ChildEnd& end)>;

/// Several at the same time, at most `parallel`; results in the order of the work.
std::vector<ChildEnd> run_isolated_together(const std::vector<IsolatedWork>& work,
                                            const IsolationLimits& limits, int parallel,
                                            const OnEnd& on_end = {});

/// "signal 11 (Segmentation fault)" and so on, one phrase for a person.
std::string describe(const ChildEnd& end);

}  // namespace signorini
