// Speed of the numerics that methods share, by Google Benchmark. Figures of a Release build on a quiet
// machine are the only ones that count; run as `build/release/tests/numerics_benchmark`.

#include <benchmark/benchmark.h>

#include <algorithm>

#include "methods/complementarity/forms.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "methods/solvers/lcp/updated_qr.hpp"
#include "tests/support/population.hpp"

namespace signorini {
namespace {

/// Cold solves over the whole population: time per iteration is the mean over its 200 scenes.
void pivoting_on_population(benchmark::State& state) {
  const auto harmonics = static_cast<int>(state.range(0));
  const auto samples = static_cast<int>(state.range(1));
  const FourierLipschitz method(
      {.common = {.harmonics = harmonics, .samples = samples, .quadrature = Quadrature::sampled},
       .solver = ComplementaritySolver::pivoting});
  std::vector<Problem> scenes;
  for (const auto& oscillator : test::contact_population(200)) scenes.push_back(test::to_problem(oscillator));
  std::vector<std::unique_ptr<PreparedMethod>> prepared;
  prepared.reserve(scenes.size());
  for (const Problem& scene : scenes) prepared.push_back(method.prepare(scene));
  long pivots = 0;
  long converged = 0;
  for (auto _ : state) {
    for (const auto& scene : prepared) {
      const Solution solution = scene->solve({});
      pivots += solution.work.pivots.value_or(0);
      converged += solution.verdict == Verdict::converged ? 1 : 0;
    }
  }
  const auto solves = static_cast<double>(state.iterations()) * static_cast<double>(scenes.size());
  state.counters["ms_per_solve"] =
      benchmark::Counter(1e-3 * solves, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["pivots"] = static_cast<double>(pivots) / solves;
  state.counters["converged"] = static_cast<double>(converged) / solves;
}
BENCHMARK(pivoting_on_population)->Args({20, 160})->Args({10, 320})->Unit(benchmark::kMillisecond);

/// One rigid scene on ever finer grids; `dense_bytes` is what an N x N array would take, `kept_bytes`
/// what the lag table and the factors take.
void pivoting_against_grid(benchmark::State& state) {
  const auto samples = static_cast<int>(state.range(0));
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const ContactReceptance receptance = fourier_receptance(problem, samples / 32);
  Lcp lcp = projected_lcp(receptance, contact_gaps(problem), lipschitz_law(problem, {}, receptance), samples);
  LcpResult result;
  for (auto _ : state) result = solve_by_pivoting(lcp);
  const auto active = static_cast<double>((result.z.array() > 0.0).count());
  state.counters["pivots"] = static_cast<double>(result.pivots);
  state.counters["active"] = active;
  state.counters["kept_bytes"] = 8.0 * (2.0 * samples + 2.0 * 4.0 * active * active);
  state.counters["dense_bytes"] = 8.0 * samples * samples;
}
BENCHMARK(pivoting_against_grid)->RangeMultiplier(2)->Range(512, 8192)->Unit(benchmark::kMillisecond);

void circulant_product(benchmark::State& state) {
  const auto samples = static_cast<int>(state.range(0));
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const ContactReceptance receptance = fourier_receptance(problem, samples / 32);
  Lcp lcp = projected_lcp(receptance, contact_gaps(problem), lipschitz_law(problem, {}, receptance), samples);
  const Eigen::VectorXd z = Eigen::VectorXd::Ones(samples);
  for (auto _ : state) benchmark::DoNotOptimize(*lcp.matrix * z);
}
BENCHMARK(circulant_product)->RangeMultiplier(4)->Range(512, 32768);

/// One row and one column in and out again, against a factorisation from scratch.
void updated_factors(benchmark::State& state) {
  const auto size = static_cast<Eigen::Index>(state.range(0));
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(size, size);
  const Eigen::VectorXd column = Eigen::VectorXd::Random(size);
  const Eigen::VectorXd row = Eigen::VectorXd::Random(size + 1);
  UpdatedQr qr;
  qr.factorise(matrix);
  for (auto _ : state) {
    qr.append_column(column);
    qr.append_row(row);
    qr.remove_column(static_cast<int>(size));
    qr.remove_row(static_cast<int>(size));
  }
}
BENCHMARK(updated_factors)->Arg(10)->Arg(50)->Arg(200);

void factors_from_scratch(benchmark::State& state) {
  const auto size = static_cast<Eigen::Index>(state.range(0));
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Random(size, size);
  UpdatedQr qr;
  for (auto _ : state) qr.factorise(matrix);
}
BENCHMARK(factors_from_scratch)->Arg(10)->Arg(50)->Arg(200);

}  // namespace
}  // namespace signorini

BENCHMARK_MAIN();
