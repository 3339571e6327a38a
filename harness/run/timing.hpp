#pragma once
// Times of set-up and solve, with Google Benchmark as the stopwatch.

#include <functional>
#include <string>
#include <vector>

#include "harness/records/record.hpp"

namespace signorini {

/// How long to measure.
struct TimingBudget {
  int rounds = 3;
  double round_seconds = 0.01;  ///< least time spent in one round; work slower than this runs once a round
  double total_seconds = 5.0;   ///< slower work gets fewer rounds, never less than one
};

/// Number of rounds of work whose first call took `first` seconds; that call counts as one.
int rounds_for(double first, const TimingBudget& budget);

/// Least time of one call in one round [s]. Google Benchmark chooses how many calls the round has. Each call
/// of `timed` returns its own time, so that clean-up is not counted. A first call that lasts as long as a
/// round is the round; unless it lasts ten times as long, a second call must confirm that, because an
/// interruption may have prolonged the first. \param first  time of the first call, already made [s]
double time_round(const std::string& name, const std::function<double()>& timed, double first,
                  const TimingBudget& budget);

/// Statistics of set-up + solve over the rounds, at least one.
Seconds summarise(const std::vector<TimedRound>& rounds);

}  // namespace signorini
