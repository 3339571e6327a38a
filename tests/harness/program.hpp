#pragma once
// The built program, run as users run it.

#include <string>

namespace signorini::test {

struct Outcome {
  int code = -1;  ///< exit code; -1 where a signal ended it
  std::string out = {};
  std::string err = {};
};

/// Runs it with these arguments, quoted as for a shell, in `folder` if one is given.
Outcome run_program(const std::string& arguments, const std::string& folder = ".");

}  // namespace signorini::test
