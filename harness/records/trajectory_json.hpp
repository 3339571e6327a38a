#pragma once
// Trajectories as records keep them, and back.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "harness/records/record.hpp"
#include "harness/records/sampled_trajectory.hpp"

namespace signorini {

/// As records keep it. `from` throws nlohmann's exceptions on missing keys and wrong types.
nlohmann::ordered_json to_json(const TrajectorySamples& trajectory);
TrajectorySamples trajectory_samples_from_json(const nlohmann::ordered_json& json);

/// One period at `count` instants.
TrajectorySamples samples_of(const Trajectory& trajectory, int count);

/// \throws BadRecord if the lists do not fit together
std::shared_ptr<const SampledTrajectory> trajectory_of(double period, const TrajectorySamples& samples);

/// The trajectory in what `solve --json --samples N` printed.
/// \throws UsageError `file` and what is wrong with it
std::shared_ptr<const SampledTrajectory> start_from_file(const std::string& path);

}  // namespace signorini
