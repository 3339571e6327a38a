// Cost of the contact solve against the number of harmonics and of contacts, by Google Benchmark, with fitted
// exponents; run as `build/release/tests/contacts_benchmark`.

#include <benchmark/benchmark.h>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "problems/assembly/beam.hpp"
#include "problems/assembly/damping.hpp"

namespace signorini {
namespace {

/// A cantilever with a rigid stop at every other node, gaps rising with the square of the distance: a beam
/// that wraps itself around an obstacle. 4 `contacts` coordinates, 2 % modal damping, driven at the tip.
Problem beam_on_obstacle(int contacts) {
  const Structure structure = assemble(Beam{.elements = 2 * contacts});
  Problem problem;
  problem.name = "beam-on-obstacle";
  problem.kind = "beam";
  problem.edit_structure([&](Structure& s) {
    s.mass = structure.mass;
    s.stiffness = structure.stiffness;
    s.damping = damping_matrix(ModalDamping{{0.02}}, structure.mass, structure.stiffness);
  });
  problem.frequency = 3.0;
  problem.force = {{.dof = 4 * contacts - 2, .harmonic = 1, .cos = 1.0}};
  for (int j = 1; j <= contacts; ++j) {
    const double x = static_cast<double>(j) / contacts;
    problem.contacts.push_back({.normal = {{4 * j - 2, 1.0}}, .gap = 0.2 * x * x});
  }
  problem.set_law(Restitution{1.0});
  return problem;
}

/// Newton's method on the exactly projected equations from a solution disturbed by a thousandth; time per
/// step.
void newton_step(benchmark::State& state, int harmonics, int contacts) {
  const Problem problem = beam_on_obstacle(contacts);
  const ContactReceptance receptance = fourier_receptance(problem, harmonics);
  const ProjectedLaw law = lipschitz_law(problem, {}, receptance);
  const Eigen::VectorXd gap = contact_gaps(problem);
  const FourierLipschitz method({{.harmonics = harmonics}});
  const Solution solution = method.prepare(problem)->solve({});
  if (solution.verdict != Verdict::converged) {
    state.SkipWithError(solution.message.c_str());
    return;
  }
  const Eigen::MatrixXcd near = (1.0 + 1e-6) * solution.trajectory->force_coefficients();
  long steps = 0;
  for (auto _ : state) {
    const ExactProjection exact =
        project_exactly({receptance, gap, law}, near, {.samples = 16 * harmonics, .tolerance = 1e-10});
    if (!exact.converged) {
      state.SkipWithError("did not converge");
      return;
    }
    steps += exact.iterations;
  }
  state.counters["steps"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kAvgIterations);
  state.counters["s_per_step"] = benchmark::Counter(
      static_cast<double>(steps), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void newton_against_harmonics(benchmark::State& state) {
  newton_step(state, static_cast<int>(state.range(0)), 4);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(newton_against_harmonics)
    ->RangeMultiplier(2)
    ->Range(40, 640)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

void newton_against_contacts(benchmark::State& state) {
  newton_step(state, 20, static_cast<int>(state.range(0)));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(newton_against_contacts)
    ->RangeMultiplier(2)
    ->Range(5, 80)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

/// The whole cold solve, receptances included.
void cold_solve(benchmark::State& state) {
  const Problem problem = beam_on_obstacle(static_cast<int>(state.range(0)));
  const FourierLipschitz method({{.harmonics = 20}});
  long pivots = 0;
  for (auto _ : state) {
    const Solution solution = method.prepare(problem)->solve({});
    if (solution.verdict != Verdict::converged) {
      state.SkipWithError(solution.message.c_str());
      return;
    }
    pivots += solution.work.pivots.value_or(0);
  }
  state.counters["pivots"] =
      benchmark::Counter(static_cast<double>(pivots), benchmark::Counter::kAvgIterations);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(cold_solve)->RangeMultiplier(2)->Range(5, 40)->Unit(benchmark::kMillisecond)->Complexity();

}  // namespace
}  // namespace signorini

BENCHMARK_MAIN();
