#pragma once
// An executable that is given text and prints text.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/plan/deadline.hpp"

namespace signorini {

/// How a command ended.
struct CommandEnd {
  std::string output = {};         ///< what it printed on stdout
  bool expired = false;            ///< it was killed at the deadline
  std::string failure = {};        ///< "the command ended with exit code 3"; empty for exit code 0
  std::optional<int> signal = {};  ///< that ended it
  std::string last_words = {};     ///< last line on its stderr
};

/// Runs `words`, a program and its arguments, with `input` on stdin. At the end or at the deadline its
/// process group is killed, with all that the command has started in it. Libraries for linear algebra are
/// told to use one thread, as all methods do. The command dies with the calling process. \throws
/// std::system_error if no process can be made
CommandEnd run_command(const std::vector<std::string>& words, std::string_view input, Deadline deadline);

}  // namespace signorini
