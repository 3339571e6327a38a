#pragma once
// Whether the records of a run come out again.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "harness/compare/comparison.hpp"
#include "harness/plan/suite.hpp"
#include "harness/records/record.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

/// What differs between a record kept and a new one, one line each; empty if nothing does. Compared are
/// status, certificate and the error of x, or what response_change tells. A status that a time limit decided
/// is no difference.
std::vector<std::string> compare_records(const Record& kept, const Record& now);

/// Time of a case over that of the baseline on the same scene in the same run, kept and new.
struct RelativeTime {
  std::string method = {};  ///< with its settings
  double kept = 0.0, now = 0.0;
};

/// Relative times of the cases timed in both runs, on scenes where both timed the baseline; `now[i]` is
/// kept[i] run again.
std::vector<RelativeTime> relative_times(const std::vector<const Record*>& kept,
                                         const std::vector<std::optional<Record>>& now);

struct Rerun {
  std::vector<std::string> differences = {};
  std::vector<std::string> remarks = {};  ///< what a time limit decided
  std::vector<double> time_ratios = {};   ///< new median over old, of each case timed in both
  std::vector<RelativeTime> relative_times = {};
  std::size_t cases = 0;                             ///< run again
  std::map<std::string, std::size_t> left_out = {};  ///< how many cases cannot be run here, by why not
  std::set<std::string> other_plugins = {};          ///< methods whose plugin is not the one of the records
  bool interrupted = false;
};

/// Runs every case again whose name matches the filter, scene by scene; calls `news` before each.
/// A scene whose file has changed is one difference. Cases of scenes and methods that are not here, and those
/// with options that their method does not take, are left out. \throws NothingMatched where the filter
/// matches no case; SceneError for a scene's file that cannot be used
Rerun rerun_records(const std::vector<Record>& kept, const Limits& limits, const std::string& filter,
                    std::span<const MethodEntry> catalogue,
                    const std::function<void(const std::string& what)>& news);

}  // namespace signorini
