#include "harness/run/isolation.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <memory>

#include "harness/interrupt.hpp"
#include "harness/run/child_process.hpp"

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

/// Ends the children that are none of those running; false if there were none.
bool end_orphans_once(const std::vector<Running>& running) {
  const pid_t self = getpid();
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", self));
  bool found = false;
  for (pid_t child = 0; children >> child;) {
    const auto is_ours = [child](const Running& one) { return one.child->id() == child; };
    if (std::any_of(running.begin(), running.end(), is_ours)) continue;
    kill(child, SIGKILL);
    found = waitpid(child, nullptr, 0) == child || found;
  }
  return found;
}

/// Descendants that left their process group are this process's children once their parents are dead, and
/// theirs once they are.
void end_orphans(const std::vector<Running>& running) {
  while (end_orphans_once(running)) {
  }
}

}  // namespace

std::vector<ChildEnd> run_isolated_together(const std::vector<IsolatedWork>& work,
                                            const IsolationLimits& limits, int parallel,
                                            const OnEnd& on_end) {
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
    std::vector<std::size_t> ended;
    std::erase_if(running, [&](Running& one) {
      if (!one.child->advance()) return false;
      ends[one.index] = one.child->take_end();
      ended.push_back(one.index);
      return true;
    });
    if (!ended.empty()) end_orphans(running);
    for (const std::size_t index : ended) {
      if (on_end) on_end(index, ends[index]);
    }
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
    case ChildEnd::Kind::out_of_processor_time:
      return "stopped at the limit of processor time: more than one thread is at work";
    case ChildEnd::Kind::interrupted:
      return "interrupted";
  }
  return {};
}

}  // namespace signorini
