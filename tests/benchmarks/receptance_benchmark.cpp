// Time and peak memory of the receptances of a brick next to those of one factorisation of its K, each in a
// process of its own. usage: receptance_benchmark [CUBES_PER_EDGE [CONTACTS_PER_EDGE [HARMONICS]]], 32 10 30
// by default.

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "methods/kernels/receptance.hpp"
#include "problems/sparse_cholesky.hpp"
#include "tests/support/brick.hpp"

namespace signorini {
namespace {

struct Cost {
  double seconds = 0.0;
  double megabytes = 0.0;  // peak of the process, the scene included
};

// The scene is the parent's; its pages count for the child as it reads them.
Cost cost_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    work();
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) != child || status != 0) std::exit(1);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return {passed.count(), static_cast<double>(used.ru_maxrss) / 1024.0};
}

int run(int cubes, int contacts, int harmonics) {
  const Problem problem = test::to_problem({.nx = cubes,
                                            .ny = cubes,
                                            .nz = cubes,
                                            .side = contacts,
                                            .alpha = 0.01,
                                            .beta = 0.01,
                                            .frequency = 0.3});
  fmt::print("{} coordinates, {} contacts, {} harmonics\n", problem.size(), problem.contact_count(),
             harmonics);
  const Cost one = cost_of([&] { const SparseCholesky factors(problem.stiffness); });
  fmt::print("one factorisation of K: {:.2f} s, {:.0f} MB\n", one.seconds, one.megabytes);
  const Cost all = cost_of([&] {
    const ContactReceptance receptance =
        contact_receptance(problem, harmonics, [](int n) { return exact_weights(0.3 * n); });
    fmt::print("basis {}, error {:.1e}\n", receptance.report.basis, receptance.report.error.value_or(0.0));
  });
  fmt::print("receptances: {:.2f} s, {:.0f} MB; {:.2f} x the time, {:.2f} x the memory\n", all.seconds,
             all.megabytes, all.seconds / one.seconds, all.megabytes / one.megabytes);
  return 0;
}

}  // namespace
}  // namespace signorini

int main(int argc, char** argv) {
  const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  return signorini::run(argument(1, 32), argument(2, 10), argument(3, 30));
}
