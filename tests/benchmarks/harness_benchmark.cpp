// What the harness itself costs, by Google Benchmark: planning, and a case whose method does nothing. Figures
// of a Release build on a quiet machine are the only ones that count; run as
// `build/release/tests/harness_benchmark`.

#include <benchmark/benchmark.h>

#include "harness/run/suite_run.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/run_folder/shards.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

/// Every scene of the suite catalogue with enough settings of one method to make ten thousand cases, and
/// their keys.
void planning_ten_thousand_cases(benchmark::State& state) {
  const Suite suite = load_suite("catalogue");
  constexpr int kSettings = 280;
  std::string methods = "hat-lcp[samples=";
  for (int i = 0; i < kSettings; ++i) methods += (i == 0 ? "" : "|") + std::to_string(64 + i);
  const Narrowing narrowing{.methods = methods + "]", .scenes = {}};
  const Runner runner(suite.limits);
  std::size_t cases = 0;
  for (auto _ : state) {
    const Plan plan = make_plan(suite, narrowing, method_catalogue(), shipped_scenes());
    cases = planned_cases(plan, runner).size();
    benchmark::DoNotOptimize(take_shard(plan, {1, 8}, {}));
  }
  state.counters["cases"] = static_cast<double>(cases);
}
BENCHMARK(planning_ten_thousand_cases)->Unit(benchmark::kMillisecond);

/// A process that does nothing.
void empty_process(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(run_isolated([](const LineSender&) {}, {}));
}
BENCHMARK(empty_process)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A case of a method that gives up at once: its process, its record, its line on the disk. What remains of a
/// case is the method's and the judge's.
void overhead_per_case(benchmark::State& state) {
  const auto folder = test::fresh_folder("benchmark");
  const Scene scene = test::one_mass_scene();
  Runner runner({}, test::free_orbits());
  RecordStore store(folder, false);
  const std::vector cases{test::fake_case(scene, "give_up")};
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  runner.compute_references(scene, jobs);
  long count = 0;
  const auto append = [&](std::size_t, const Record& record) {  // every record under a key of its own
    Record fresh = record;
    fresh.key = std::to_string(++count);
    store.append(fresh);
  };
  for (auto _ : state) run_rounds(runner, scene, jobs, {std::nullopt}, {}, {.case_done = append});
}
BENCHMARK(overhead_per_case)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace signorini

BENCHMARK_MAIN();
