#pragma once
// How busy a machine is with other programs while cases are timed, and whether times are comparable.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace signorini {

/// What the file proc/loadavg below `root` says (proc(5)).
struct LoadAverage {
  double minute = 0.0;  ///< processes that ran or waited to run, mean over about a minute [-]
  int running = 0;      ///< that do so now beside the one that asks [-]
};

/// Nothing where the system does not tell.
std::optional<LoadAverage> load_average(const std::filesystem::path& root = "/");

/// The load of other programs over the processors that `jobs` cases leave to them, (load - own) / (processors
/// - jobs), not below 0 and for a quarter of a processor at least: above 1 they take time from the cases [-].
/// \param own  processes of the program itself that the load counts
double load_share(double load, int own, int jobs, int processors);

/// load_share of this machine while so many cases run.
std::optional<double> load_beside(int jobs);

/// Writes into the manifest of a run whether its times are comparable, `times_comparable`, and why they are
/// not, `times_not_comparable`. \param before  why those of a run that this one resumes are not; or empty
void note_times(nlohmann::ordered_json& manifest, const std::string& before = {});

/// Writes the load at the end of a run into the manifest in its folder, and note_times. \param start  why
/// times are not comparable by the manifest with which it began; or empty \throws UsageError
void close_manifest(const std::filesystem::path& folder, const std::string& start = {});

/// Why times of a run are not comparable, by its manifest, as a clause: the build has none, cases ran at the
/// same time, or at its start or end, or at those of a shard, load_share was above 1. At the start counted is
/// the lesser of the mean and of what ran then: a build that has just ended disturbs nothing. Empty where
/// they are comparable, as far as the manifest tells.
std::string why_not_comparable(const nlohmann::ordered_json& manifest);

/// What times of a run are multiplied by to stand beside those of a run on another machine: the ratio of the
/// times that the calibration solve took there and here, by their manifests [-]. Nothing unless both have the
/// time of one version of it, or where the ratio is beyond 1e6.
std::optional<double> times_factor(const nlohmann::ordered_json& there, const nlohmann::ordered_json& here);

}  // namespace signorini
