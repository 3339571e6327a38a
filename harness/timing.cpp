#include "harness/timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>

#include "harness/statistics.hpp"

namespace signorini {

namespace {

constexpr const char* kLeast = "least";

/// Keeps the least time of each round and prints nothing.
class RoundCollector final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const auto least = run.counters.find(kLeast);
      if (least != run.counters.end()) rounds.push_back(least->second.value);
    }
  }

  std::vector<double> rounds;
};

}  // namespace

bool build_may_be_timed() {
#if defined(NDEBUG) && defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
  return true;
#else
  return false;
#endif
}

std::vector<double> time_rounds(const std::string& name, const std::function<double()>& timed, double first,
                                const TimingBudget& budget) {
  const bool slow = first >= budget.round_seconds;
  int rounds = budget.rounds;
  if (slow) rounds = std::clamp(static_cast<int>(budget.total_seconds / first), 1, rounds) - 1;
  RoundCollector collector;
  if (slow) collector.rounds.push_back(first);
  if (rounds == 0) return collector.rounds;
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
  registered->UseManualTime()->Repetitions(rounds);
  if (slow) {
    registered->Iterations(1);
  } else {
    registered->MinTime(budget.round_seconds);
  }
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.rounds;
}

Seconds summarise(const std::vector<double>& setup, const std::vector<double>& solve) {
  std::vector<double> total;
  for (std::size_t i = 0; i < std::min(setup.size(), solve.size()); ++i) total.push_back(setup[i] + solve[i]);
  return {.median = median(total),
          .min = *std::min_element(total.begin(), total.end()),
          .mad = median_deviation(total),
          .repetitions = static_cast<int>(total.size()),
          .setup = median(setup),
          .solve = median(solve)};
}

}  // namespace signorini
