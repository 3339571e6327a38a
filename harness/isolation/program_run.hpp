#pragma once
// A program of the machine that is run to its end for what it prints, without a shell.

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace signorini {

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
