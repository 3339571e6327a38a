#pragma once
// Runs of one suite over time: what the program has come to solve, how accurately and how fast.

#include <cstddef>
#include <string>
#include <vector>

#include "harness/compare/comparison.hpp"

namespace signorini {

/// A run among others over time.
struct HistoryPoint {
  std::string run = {};         ///< name of its folder
  std::string date = {};        ///< of its manifest, as 2026-11-29T18:05:00Z
  std::string commit = {};      ///< of its build, 12 digits; empty where that does not know
  std::size_t certified = 0;    ///< of History::cases
  Measure error = {};           ///< of x, median over History::certified cases [-]
  Measure seconds = {};         ///< geometric mean over History::timed cases, as on the first machine [s]
  std::string hides_time = {};  ///< why there are no times of this run, a clause
};

/// Runs by date, over the cases of motions that all of them have of one and the same scene's text.
struct History {
  std::size_t cases = 0;      ///< whose method applies in one run at least
  std::size_t certified = 0;  ///< of these, in all runs
  std::size_t timed = 0;      ///< of the certified ones, in all runs whose times count
  std::vector<HistoryPoint> points = {};
};

/// Errors are not below what is known of the orbit (measurable_error). The times of a run count where they
/// are comparable, and its machine is that of the first such run or times_factor to that is known; they are
/// multiplied by that factor.
History history_of(std::vector<WholeRun> runs);

}  // namespace signorini
