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
  double round_seconds = 0.01;  ///< least time spent in one round; work slower than this runs once a round
  double total_seconds = 5.0;   ///< slower work gets fewer rounds, never less than one
};

/// Least time of one call per round [s], at least one round. Google Benchmark chooses how many calls a round
/// has and repeats the rounds; a call's time is read within `timed`, which returns it, so that clean-up stays
/// outside. A first call that alone fills a round counts as one.
/// \param first  time of the first call, already made
std::vector<double> time_rounds(const std::string& name, const std::function<double()>& timed, double first,
                                const TimingBudget& budget);

/// Statistics over rounds of set-up + solve, as many as both have, at least one.
Seconds summarise(const std::vector<double>& setup, const std::vector<double>& solve);

}  // namespace signorini
