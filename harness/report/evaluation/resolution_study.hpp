#pragma once
// The runs of one configuration of a method on one scene at all of its resolutions, with their errors.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "harness/records/record.hpp"

namespace signorini {

/// Whether the value of a setting is a number.
bool is_numeric(const std::string& value);

/// "event-driven[flow=cvode]": the method with those of its settings that are words, and kStartSetting, as a
/// solve that starts at the orbit is compared with no other. Settings that are numbers are its resolution.
std::string configuration_of(const Record& record);

/// One run of a study with its error.
struct ScoredRun {
  const Record* record = nullptr;
  Measure error = {};    ///< certified_error
  bool bounded = false;  ///< below ten error bars: never ranked by its error
};

/// Whether a configuration is ranked on a scene.
enum class Eligibility {
  ranked,  ///< it solves the problem that the scene states
  /// It solves another problem than the scene states, or would if it applied: shown apart, never ranked.
  another_law,
  not_applicable  ///< at none of its resolutions; ranked as unsolved where it applies to other scenes
};

/// The names in tables.
template <>
struct EnumNames<Eligibility> {
  /// In order.
  static constexpr std::array<std::string_view, 3> values{"competes", "another-law", "not-applicable"};
};

/// The runs of one configuration on one scene.
struct ResolutionStudy {
  std::string scene = {}, configuration = {};
  Eligibility eligibility = Eligibility::ranked;
  std::vector<ScoredRun> runs = {};  ///< in the order of the records
};

/// Studies of all records, by scene and configuration in the order of their first record. They point into
/// `records`.
std::vector<ResolutionStudy> resolution_studies(const std::vector<Record>& records);

/// How many of its runs have an error.
std::ptrdiff_t solved_runs(const ResolutionStudy& study);

/// The run of a record with its error.
ScoredRun scored_run(const Record& record);

}  // namespace signorini
