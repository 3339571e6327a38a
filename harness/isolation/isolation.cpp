#include "harness/isolation/isolation.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <memory>

#include "harness/interrupt.hpp"

namespace signorini {

namespace {

struct RunningChild {
  std::size_t index;
  std::unique_ptr<IsolatedChild> child;
};

/// Returns when a child has sent something or has ended, or when the limits have to be looked at.
void wait_for_any(const std::vector<RunningChild>& running) {
  constexpr int kLook = 20, kLookForEnd = 1;  // [ms]
  std::vector<pollfd> descriptors;
  int timeout = kLook;
  for (const RunningChild& one : running) {
    for (const int descriptor : {one.child->line_descriptor(), one.child->end_descriptor()}) {
      if (descriptor >= 0) descriptors.push_back({.fd = descriptor, .events = POLLIN, .revents = 0});
    }
    // A child that has closed its pipe is about to end, and without this descriptor nothing tells when.
    if (one.child->line_descriptor() < 0 && one.child->end_descriptor() < 0) timeout = kLookForEnd;
  }
  poll(descriptors.data(), descriptors.size(), timeout);
}

/// Ends this process's children that are not among those running; false if there were none.
bool end_orphans_once(const std::vector<RunningChild>& running) {
  const pid_t self = getpid();
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", self));
  bool found = false;
  for (pid_t child = 0; children >> child;) {
    const auto is_ours = [child](const RunningChild& one) { return one.child->id() == child; };
    if (std::any_of(running.begin(), running.end(), is_ours)) continue;
    kill(child, SIGKILL);
    found = waitpid(child, nullptr, 0) == child || found;
  }
  return found;
}

/// Ends descendants that left their process group: as this process is a subreaper they become its children
/// when their parents die, and so do their own children in turn.
void end_orphans(const std::vector<RunningChild>& running) {
  while (end_orphans_once(running)) {
  }
}

}  // namespace

std::vector<ChildEnd> run_isolated_together(const std::vector<IsolatedWork>& work,
                                            const IsolationLimits& limits, int parallel,
                                            const OnEnd& on_end) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  std::vector<ChildEnd> ends(work.size());
  std::vector<RunningChild> running;
  std::size_t next = 0;
  while (next < work.size() || !running.empty()) {
    while (next < work.size() && running.size() < static_cast<std::size_t>(parallel) && !interrupted()) {
      running.push_back({next, std::make_unique<IsolatedChild>(work[next], limits)});
      ++next;
    }
    if (interrupted()) {
      for (; next < work.size(); ++next) ends[next].kind = ChildEnd::Kind::interrupted;
      for (const RunningChild& one : running) one.child->interrupt();
    }
    if (running.empty()) break;
    wait_for_any(running);
    std::vector<std::size_t> ended;
    std::erase_if(running, [&](RunningChild& one) {
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

}  // namespace signorini
