#pragma once
// Work in a process of its own, for what it costs there.

#include <functional>
#include <optional>

namespace signorini::test {

struct ChildCost {
  bool finished = false;   ///< the work returned; false if it threw, or died
  double seconds = 0.0;    ///< of processor time, which others on the machine hardly change
  double megabytes = 0.0;  ///< peak resident set, the parent's pages it reads included
};

/// Runs the work in a forked child, which may map at most `more_megabytes` of address space beyond what the
/// parent has. No limit under the address sanitizer, which maps terabytes.
ChildCost run_in_child(const std::function<void()>& work, std::optional<double> more_megabytes = {});

}  // namespace signorini::test
