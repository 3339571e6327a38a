// What the arithmetic that nobody can leave out takes, by Google Benchmark: transforms over a period and one
// solve per harmonic. limits.py sets the methods beside it; run as `build/release/tests/limits_benchmark`.

#include <benchmark/benchmark.h>

#include <Eigen/Core>

#include "methods/discretisation/real_fft.hpp"

namespace signorini {
namespace {

/// N samples to coefficients and back.
void transform_pair(benchmark::State& state) {
  RealFft transform(static_cast<int>(state.range(0)));
  Eigen::VectorXd values = Eigen::VectorXd::Random(transform.samples());
  Eigen::VectorXcd spectrum(transform.coefficients());
  for (auto _ : state) {
    transform.forward(values, spectrum);
    transform.inverse(spectrum, values);
    benchmark::DoNotOptimize(values.data());
  }
}
BENCHMARK(transform_pair)->Arg(1024)->Arg(16384)->Arg(65536)->Unit(benchmark::kMicrosecond);

/// Of H harmonics and one contact: a pair of transforms of 4 H samples, and between them a division per
/// harmonic.
void harmonic_step(benchmark::State& state) {
  const auto harmonics = static_cast<int>(state.range(0));
  RealFft transform(4 * harmonics);
  Eigen::VectorXd values = Eigen::VectorXd::Random(transform.samples());
  Eigen::VectorXcd spectrum(transform.coefficients());
  const Eigen::VectorXcd stiffness = Eigen::VectorXcd::Random(harmonics).array() + 4.0;
  for (auto _ : state) {
    transform.forward(values, spectrum);
    spectrum.head(harmonics).array() /= stiffness.array();
    transform.inverse(spectrum, values);
    benchmark::DoNotOptimize(values.data());
  }
}
BENCHMARK(harmonic_step)->Arg(20)->Arg(80)->Arg(320)->Arg(1280)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace signorini

BENCHMARK_MAIN();
