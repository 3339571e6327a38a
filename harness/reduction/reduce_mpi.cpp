// What `signorini reduce --mpi N` starts N times: the reduction of a scene whose factors no process can hold.

#include <fmt/format.h>
#include <mpi.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>

#include "harness/failure.hpp"
#include "harness/reduction/mumps_solver.hpp"
#include "harness/reduction/reduction_files.hpp"
#include "harness/reduction/shared_reduction.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

// In rank 0. The exit code stays 0 where the scene is refused, for launchers comment on any other.
void reduce_scene(const ReductionOrder& order, const Factorise& factorise) {
  try {
    fmt::print("{}", write_reduction(read_reducible(find_scene(order.scene)), order, factorise));
    fmt::print("{}\n", kReductionDone);
  } catch (const UsageError& error) {
    fmt::print("{}{}\n", kReductionRefused, error.what());
  } catch (const SceneError& error) {
    fmt::print("{}{}\n", kReductionRefused, error.what());
  } catch (const InvalidProblem& error) {
    fmt::print("{}{}\n", kReductionRefused, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print("{}{}\n", kReductionRefused, error.what());
  } catch (const std::bad_alloc&) {
    fmt::print("{}out of memory\n", kReductionFailed);
  } catch (const std::exception& error) {
    fmt::print("{}{}\n", kReductionFailed, error.what());
  }
  std::fflush(stdout);
}

}  // namespace

}  // namespace signorini

int main(int argc, char** argv) {
  using namespace signorini;
  MPI_Init(&argc, &argv);
  constexpr int kWords = 4;  // with its own name: scene, file, vectors
  if (argc == kWords) {
    const ReductionOrder order{.scene = argv[1], .out = argv[2], .vectors = std::atoi(argv[3])};
    run_with_shared_factors([&](const Factorise& factorise) { reduce_scene(order, factorise); });
  }
  MPI_Finalize();
  return argc == kWords ? EXIT_SUCCESS : 2;
}
