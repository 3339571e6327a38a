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

/// Rounds that work gets whose first call took this long [s], that call included.
int rounds_for(double first, const TimingBudget& budget);

/// Least time of one call in one round [s]. Google Benchmark chooses how many calls the round has; a call's
/// time is read within `timed`, which returns it, so that clean-up stays outside. A first call that alone
/// fills a round is the round; where it barely does, a second call must do so too, for the first may only
/// have been interrupted. \param first  time of the first call, already made
double time_round(const std::string& name, const std::function<double()>& timed, double first,
                  const TimingBudget& budget);

/// Statistics of set-up + solve over the rounds, at least one.
Seconds summarise(const std::vector<TimedRound>& rounds);

}  // namespace signorini
