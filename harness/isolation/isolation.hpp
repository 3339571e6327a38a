#pragma once
// Work in child processes that may crash, hang or leak without harm to anyone else.

#include <functional>
#include <vector>

#include "harness/isolation/child_end.hpp"
#include "harness/isolation/isolated_child.hpp"

namespace signorini {

/// Runs the work in a forked child with its own process group. However the child ends, the group is killed as
/// a whole, and so are its descendants that left the group; it dies with the parent. The parent must have no
/// other threads and no other children. \throws std::system_error if no process can be made
ChildEnd run_isolated(const IsolatedWork& work, const IsolationLimits& limits);

/// Called with each end as soon as it is known.
using OnEnd = std::function<void(std::size_t index, const ChildEnd& end)>;

/// Several at the same time, at most `parallel`; results in the order of the work.
std::vector<ChildEnd> run_isolated_together(const std::vector<IsolatedWork>& work,
                                            const IsolationLimits& limits, int parallel,
                                            const OnEnd& on_end = {});

}  // namespace signorini
