#include "harness/isolation/child_end.hpp"

#include <fmt/format.h>

#include <cstring>

namespace signorini {

namespace {

std::string with_last_words(std::string text, const ChildEnd& end) {
  return end.last_words.empty() ? text : fmt::format("{}: {}", text, end.last_words);
}

}  // namespace

std::string describe(const ChildEnd& end) {
  switch (end.kind) {
    case ChildEnd::Kind::finished:
      return "finished";
    case ChildEnd::Kind::threw:
      return fmt::format("exception: {}", end.detail);
    case ChildEnd::Kind::out_of_memory:
      return "out of memory";
    case ChildEnd::Kind::exited:
      return with_last_words(fmt::format("the process ended with code {} before an answer", end.code), end);
    case ChildEnd::Kind::signalled:
      return with_last_words(fmt::format("signal {} ({})", end.code, strsignal(end.code)), end);
    case ChildEnd::Kind::timed_out:
      return "stopped at the time limit";
    case ChildEnd::Kind::out_of_processor_time:
      return "stopped at the limit of processor time: more than one thread is at work";
    case ChildEnd::Kind::interrupted:
      return "interrupted";
  }
  return {};
}

}  // namespace signorini
