// Processor time and peak memory of the receptances of a block next to those of one factorisation of its K,
// each in a process of its own. usage: receptance_benchmark [CUBES_PER_EDGE [CONTACTS_PER_EDGE [HARMONICS]]],
// 32 10 30 by default.

#include <fmt/format.h>

#include <cstdlib>
#include <functional>

#include "methods/structure/receptance.hpp"
#include "problems/sparse_cholesky.hpp"
#include "tests/support/child.hpp"
#include "tests/support/elastic_block.hpp"

namespace signorini {
namespace {

using test::ChildCost;

ChildCost cost_of(const std::function<void()>& work) {
  const ChildCost cost = test::run_in_child(work);
  if (!cost.finished) std::exit(1);
  return cost;
}

int run(int cubes, int contacts, int harmonics) {
  const Problem problem = test::elastic_block_problem({.nx = cubes,
                                                       .ny = cubes,
                                                       .nz = cubes,
                                                       .side = contacts,
                                                       .alpha = 0.01,
                                                       .beta = 0.01,
                                                       .frequency = 0.3});
  fmt::print("{} coordinates, {} contacts, {} harmonics\n", problem.size(), problem.contact_count(),
             harmonics);
  const ChildCost one = cost_of([&] { const SparseCholesky factors(problem.stiffness()); });
  fmt::print("one factorisation of K: {:.2f} s, {:.0f} MB\n", one.seconds, one.megabytes);
  const ChildCost all = cost_of([&] {
    const ContactReceptance receptance =
        contact_receptance(problem, harmonics, [](int n) { return exact_weights(0.3 * n); });
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
