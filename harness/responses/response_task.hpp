#pragma once
// What the processes of a case do that is a response: it is followed, measured against the exact one, and
// timed.

#include <vector>

#include "harness/responses/exact_response.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

/// Gives the jobs of cases that are responses their tasks (Job::task). The exact response is followed by
/// continuation of exact orbits with steps of a third of the usual length, within
/// Limits::reference_timeout, begun also at the motions that starts settle to (`attractors_over`), which take
/// as much, and completed by orbits that steps of the frequency find on none of its branches, in as much
/// again. What a method has on none of them the judge is asked about (TrueMotions). A method has
/// Limits::timeout: it follows its curve once for the time and once for its motions, or is taken through the
/// frequencies, each solve in a process of its own; its time is of the processor. \param scene, limits, exact
/// must outlive the jobs
void give_tasks(const Scene& scene, const Limits& limits, ExactResponse& exact, std::vector<Job>& jobs);

}  // namespace signorini
