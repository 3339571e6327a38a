#pragma once
// Trajectories as records keep them, and back.

#include <memory>
#include <string_view>

#include "harness/record.hpp"
#include "harness/sampled_trajectory.hpp"

namespace signorini {

/// One period at `count` instants.
TrajectorySamples samples_of(const Trajectory& trajectory, int count);

/// \throws BadRecord if the lists do not fit together
std::shared_ptr<const SampledTrajectory> trajectory_of(double period, const TrajectorySamples& samples);

/// The trajectory in what `solve --json --samples N` printed.
/// \throws UsageError `file` and what is wrong with it
std::shared_ptr<const SampledTrajectory> start_from_file(const std::string& path);

}  // namespace signorini
