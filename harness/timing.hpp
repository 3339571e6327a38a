#pragma once
// Times of set-up and solve, with Google Benchmark as the stopwatch.

#include <functional>
#include <string>
#include <vector>

#include "harness/record.hpp"

namespace signorini {

/// False in builds whose times mean nothing: assertions on, no optimiser, or sanitizers.
bool build_may_be_timed();

/// How long to measure.
struct TimingBudget {
  int rounds = 3;
  double round_seconds = 0.02;  ///< least time spent in one round; work slower than this runs once a round
};

/// Least time of one call per round [s]. Google Benchmark chooses how many calls a round has and repeats the
/// rounds; a call's time is read within `timed`, which returns it, so that clean-up stays outside.
/// \param first  time of a call already made, to decide whether a round is more than one call
std::vector<double> time_rounds(const std::string& name, const std::function<double()>& timed, double first,
                                const TimingBudget& budget);

/// Statistics over rounds of set-up + solve, both of equal length >= 1.
Seconds summarise(const std::vector<double>& setup, const std::vector<double>& solve);

/// Rounds that fit: `rounds` unless one would take over a minute (then one) or they would exceed `available`.
int affordable_rounds(int rounds, double one_round, double available);

}  // namespace signorini
