#pragma once
// How the work of an isolated child process ended.

#include <string>
#include <vector>

namespace signorini {

/// How a child ended and what it had sent until then.
struct ChildEnd {
  enum class Kind {
    finished,               ///< the work returned
    threw,                  ///< the work threw an exception; `detail` is its text
    out_of_memory,          ///< the work threw std::bad_alloc
    exited,                 ///< the process ended with `code` before the work returned
    signalled,              ///< signal `code` ended the process
    timed_out,              ///< the parent ended it at its limit of wall time
    out_of_processor_time,  ///< the system ended it at its limit of processor time
    interrupted             ///< the parent ended it because it was itself asked to stop (SIGINT, SIGTERM)
  };
  Kind kind = Kind::finished;
  int code = 0;
  std::string detail = {};              ///< text of the exception
  std::string last_words = {};          ///< last line on stdout or stderr, to explain a crash
  std::vector<std::string> lines = {};  ///< complete lines, in the order they were sent
  double seconds = 0.0;                 ///< wall time from its start to its end [s]
};

/// "signal 11 (Segmentation fault): last words" and so on, one phrase for a person.
std::string describe(const ChildEnd& end);

}  // namespace signorini
