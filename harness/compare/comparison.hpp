#pragma once
// What changed between two runs, beyond the noise of both.

#include <string>
#include <vector>

#include "harness/compare/noise.hpp"
#include "harness/records/run_folder.hpp"

namespace signorini {

enum class ChangeKind { broken, less_accurate, slower, repaired, more_accurate, faster };

/// "broken", "less accurate", ...
std::string_view change_name(ChangeKind kind);

struct CaseChange {
  std::string case_id = {};
  ChangeKind kind = ChangeKind::broken;
  std::string detail = {};  ///< what was and what is
};

struct Comparison {
  std::size_t cases = 0;                  ///< in both runs
  std::size_t timed = 0;                  ///< of these, with comparable times
  std::vector<CaseChange> changes = {};   ///< by kind, worst first, then as in the first run
  std::vector<MethodTimes> methods = {};  ///< empty where times are not comparable
  std::vector<std::string> remarks = {};  ///< cases of one run only, work counted, why times are not compared
};

/// The first run is the one of before. A case is broken that converged and ends otherwise, or has no record;
/// it is less accurate where the harness finds it inaccurate, its certificate is lost, or its error grew by
/// kErrorFactor and is above ten error bars. Times are compared if both runs are of the same machine, one
/// case at a time; see noise.hpp.
Comparison compare_runs(const RunFolder& before, const RunFolder& after);

/// Something is broken, less accurate or slower.
bool has_regression(const Comparison& comparison);

}  // namespace signorini
