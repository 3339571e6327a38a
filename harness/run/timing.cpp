#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "harness/run/trial.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

constexpr const char* kLeast = "least";

/// A first call that fills a round this many times was not long by mere preemption.
constexpr double kSureFactor = 10.0;

/// Keeps the least time of a round and prints nothing.
class LeastTime final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const auto least = run.counters.find(kLeast);
      if (least != run.counters.end()) seconds = least->second.value;
    }
  }

  double seconds = 0.0;
};

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

double time_round(const std::string& name, const std::function<double()>& timed, double first,
                  const TimingBudget& budget) {
  if (first >= kSureFactor * budget.round_seconds) return first;
  if (first >= budget.round_seconds) {
    // An interruption may have prolonged the first call.
    const double second = timed();
    if (second >= budget.round_seconds) return std::min(first, second);
  }
  benchmark::ClearRegisteredBenchmarks();
  auto* registered = benchmark::RegisterBenchmark(name.c_str(), [&timed](benchmark::State& state) {
    double least = std::numeric_limits<double>::infinity();
    for ([[maybe_unused]] const auto& iteration : state) {
      const double seconds = timed();
      state.SetIterationTime(seconds);
      least = std::min(least, seconds);
    }
    state.counters[kLeast] = least;
  });
  registered->UseManualTime()->MinTime(budget.round_seconds);
  LeastTime least;
  benchmark::RunSpecifiedBenchmarks(&least);
  benchmark::ClearRegisteredBenchmarks();
  return least.seconds;
}

Seconds summarise(const std::vector<TimedRound>& rounds) {
  std::vector<double> setup, solve, total;
  for (const TimedRound& round : rounds) {
    setup.push_back(round.setup);
    solve.push_back(round.solve);
    total.push_back(round.setup + round.solve);
  }
  Seconds seconds{.median = median(total),
                  .min = *std::ranges::min_element(total),
                  .mad = median_deviation(total),
                  .repetitions = static_cast<int>(total.size()),
                  .setup = median(setup),
                  .solve = median(solve)};
  seconds.rounds = rounds;
  if (rounds.size() > 1) seconds.unstable = seconds.mad > kUnstable * seconds.median;
  return seconds;
}

}  // namespace signorini
