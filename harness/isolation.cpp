#include "harness/isolation.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>

#include <cstring>
#include <memory>

#include "harness/child_process.hpp"
#include "harness/interrupt.hpp"

namespace signorini {

namespace {

/// Between looks at deadlines and at children that closed their pipe [ms].
constexpr int kLook = 20;
constexpr int kQuickLook = 1;

struct Running {
  std::size_t index;
  std::unique_ptr<ChildProcess> child;
};

void wait_for_any(const std::vector<Running>& running) {
  std::vector<pollfd> descriptors;
  int timeout = kLook;
  for (const Running& one : running) {
    if (one.child->descriptor() >= 0) {
      descriptors.push_back({.fd = one.child->descriptor(), .events = POLLIN, .revents = 0});
    } else {
      timeout = kQuickLook;
    }
  }
  poll(descriptors.data(), descriptors.size(), timeout);
}

}  // namespace

std::vector<ChildEnd> run_isolated_together(const std::vector<IsolatedWork>& work,
                                            const IsolationLimits& limits, int parallel) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  std::vector<ChildEnd> ends(work.size());
  std::vector<Running> running;
  std::size_t next = 0;
  while (next < work.size() || !running.empty()) {
    while (next < work.size() && running.size() < static_cast<std::size_t>(parallel) && !interrupted()) {
      running.push_back({next, std::make_unique<ChildProcess>(work[next], limits)});
      ++next;
    }
    if (interrupted()) {
      for (; next < work.size(); ++next) ends[next].kind = ChildEnd::Kind::interrupted;
      for (const Running& one : running) one.child->interrupt();
    }
    if (running.empty()) break;
    wait_for_any(running);
    std::erase_if(running, [&](Running& one) {
      if (!one.child->advance()) return false;
      ends[one.index] = one.child->take_end();
      return true;
    });
  }
  return ends;
}

ChildEnd run_isolated(const IsolatedWork& work, const IsolationLimits& limits) {
  return std::move(run_isolated_together({work}, limits, 1).front());
}

std::string describe(const ChildEnd& end) {
  const auto with_words = [&](std::string text) {
    return end.last_words.empty() ? text : fmt::format("{}: {}", text, end.last_words);
  };
  switch (end.kind) {
    case ChildEnd::Kind::finished:
      return "finished";
    case ChildEnd::Kind::threw:
      return fmt::format("exception: {}", end.detail);
    case ChildEnd::Kind::out_of_memory:
      return "out of memory";
    case ChildEnd::Kind::exited:
      return with_words(fmt::format("the process ended with code {} before an answer", end.code));
    case ChildEnd::Kind::signalled:
      return with_words(fmt::format("signal {} ({})", end.code, strsignal(end.code)));
    case ChildEnd::Kind::timed_out:
      return "stopped at the time limit";
    case ChildEnd::Kind::interrupted:
      return "interrupted";
  }
  return {};
}

}  // namespace signorini
