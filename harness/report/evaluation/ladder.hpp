#pragma once
// The runs of one method on one scene, coarse to fine, and what each of them reached at what cost.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/records/record.hpp"

namespace signorini {

/// Something that a run spends: seconds, or a count that no noise touches.
struct CostAxis {
  std::string_view name = {};  ///< "time", "pivots"
  std::string_view unit = {};  ///< "s"; empty for counts
  std::optional<double> (*cost)(const Record&) = nullptr;
};

/// Median time of set-up and solve [s].
const CostAxis& time_axis();

/// Pivots, iterations, evaluations of right-hand sides, factorisations, unknowns. What an iteration is
/// differs between methods: counts compare resolutions of one method, or methods of one kind.
std::span<const CostAxis> work_axes();

/// The settings in the brackets of a case, "key=value" each, in their order.
std::vector<std::string> settings_of(const Record& record);

/// Whether the value of a setting is a number.
bool is_numeric(const std::string& setting);

/// "event-driven[flow=cvode]": the method with those settings of its case that are words, and kStartSetting:
/// who starts at the orbit competes with nobody else. Those that are numbers are its ladder.
std::string contestant_of(const Record& record);

/// "fourier-lipschitz[harmonics=40]": the case without its scene.
std::string resolution_of(const Record& record);

/// One run of a ladder.
struct Rung {
  const Record* record = nullptr;
  /// Relative L2 of x (of u where there is no contact), not below ten error bars of the orbit. Absent unless
  /// the harness says converged and certifies the orbit: the one reached from rest, where that is known.
  std::optional<double> error = {};
  bool bounded = false;  ///< below ten error bars: never ranked by its error
};

/// How a method takes part on a scene.
enum class Standing {
  competes,
  another_law,    ///< it solves another problem than the scene states: shown apart, never ranked
  not_applicable  ///< at none of its resolutions
};

/// The runs of one contestant on one scene.
struct Ladder {
  std::string scene = {}, contestant = {};
  Standing standing = Standing::competes;
  std::vector<Rung> rungs = {};  ///< in the order of the records
};

/// Ladders of all records, by scene and contestant in the order of their first record. They point into
/// `records`.
std::vector<Ladder> ladders_of(const std::vector<Record>& records);

/// How many of its runs are credited with an error.
std::size_t credited_rungs(const Ladder& ladder);

/// What a run of this record is credited with, see Rung::error.
Rung rung_of(const Record& record);

}  // namespace signorini
