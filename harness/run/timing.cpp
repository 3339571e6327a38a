#include <algorithm>
#include <utility>

#include "harness/run/trial.hpp"
#include "harness/statistics.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

/// A first call that fills a round this many times was not long by mere preemption.
constexpr double kSureFactor = 10.0;

/// Calls of a round that may end before its time is over: its first ones find caches and predictions cold.
constexpr int kLeastCalls = 5;
constexpr double kRoundShare = 0.1;  // of the time of a round
constexpr double kTick = 1e-9;       // s: a clock may stand still for a call
/// Times that differ by less than this factor are the least time twice.
constexpr double kAgreeing = 1.01;

}  // namespace

int rounds_for(double first, const TimingBudget& budget) {
  if (first < budget.round_seconds) return budget.rounds;
  return static_cast<int>(std::clamp(budget.total_seconds / first, 1.0, static_cast<double>(budget.rounds)));
}

bool rounds_agree(const std::vector<TimedRound>& rounds, int count) {
  if (std::cmp_less(rounds.size(), count)) return false;
  std::vector<double> total;
  for (const TimedRound& round : rounds) total.push_back(round.setup + round.solve);
  std::ranges::sort(total);
  for (std::size_t last = static_cast<std::size_t>(count) - 1; last < total.size(); ++last)
    if (total[last] <= kSteadyFactor * total[last + 1 - static_cast<std::size_t>(count)]) return true;
  return false;
}

int rounds_missing(const std::vector<TimedRound>& rounds, int planned, int more) {
  const int taken = static_cast<int>(rounds.size());
  if (taken < planned) return planned - taken;
  return taken < planned + more && !rounds_agree(rounds, planned) ? 1 : 0;
}

double time_round(const std::function<double()>& timed, double first, const TimingBudget& budget) {
  if (first >= kSureFactor * budget.round_seconds) return first;
  // A first call that fills the round ends it if a second does: it may have been interrupted.
  double least = kInfinity, second = kInfinity, spent = 0.0;
  for (int calls = 1; spent < budget.round_seconds; ++calls) {
    const double seconds = timed();
    spent += std::max(seconds, kTick);
    second = std::min(second, std::max(least, seconds));
    least = std::min(least, seconds);
    if (calls >= kLeastCalls && spent >= kRoundShare * budget.round_seconds && second <= kAgreeing * least)
      break;
  }
  return first >= budget.round_seconds ? std::min(first, least) : least;
}

Seconds summarise(const std::vector<TimedRound>& rounds) {
  std::vector<double> setup, solve, total, first;
  for (const TimedRound& round : rounds) {
    setup.push_back(round.setup);
    solve.push_back(round.solve);
    total.push_back(round.setup + round.solve);
    if (round.first) first.push_back(*round.first);
  }
  Seconds seconds{.median = median(total),
                  .min = *std::ranges::min_element(total),
                  .mad = median_deviation(total),
                  .repetitions = static_cast<int>(total.size()),
                  .setup = median(setup),
                  .solve = median(solve)};
  seconds.rounds = rounds;
  if (!first.empty()) seconds.first = median(first);
  if (rounds.size() > 1) seconds.unstable = seconds.mad > kUnstable * seconds.median;
  return seconds;
}

}  // namespace signorini
