#include <fmt/format.h>

#include <string>

#include "harness/commands/command_line.hpp"
#include "harness/interrupt.hpp"
#include "harness/reduction/reduction_files.hpp"
#include "harness/reduction/shared_reduction.hpp"

namespace signorini {

namespace {

struct ReduceArguments {
  ReductionOrder order;
  std::string out;
  MpiLaunch launch{.processes = 0};
};

int reduce(const ReduceArguments& arguments) {
  ReductionOrder order = arguments.order;
  order.out = arguments.out;
  require_scene_file(order.out);
  std::string told;
  if (arguments.launch.processes > 0) {
    (void)read_reducible(find_scene(order.scene));  // what is wrong with it is told by one process
    watch_interrupts();
    try {
      told = reduce_by_mpi(order, arguments.launch);
    } catch (const ReductionFailure& failure) {
      fmt::print(stderr, "{}\n", failure.what());
      return kUnexpectedFailure;
    }
    if (interrupted()) return kInterrupted;
  } else {
    const ReducibleScene scene = read_reducible(find_scene(order.scene));
    require_room_for_factors(order.scene, scene.problem.stiffness());
    told = write_reduction(scene, order, factorise_here);
  }
  fmt::print("{}", told);
  return kDone;
}

}  // namespace

void add_reduce_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "reduce", reduce, "Writes a small scene whose contacts behave as those of a large structure.");
  command.option("scene", arguments->order.scene, "a scene of the catalogue, or a scene file",
                 {.required = true});
  command.option("--out", arguments->out,
                 "NAME.toml: the scene to write, its matrices beside it in NAME-M.mtx and NAME-K.mtx",
                 {.required = true});
  command.option(
      "--vectors", arguments->order.vectors,
      "number of Krylov vectors kept; with at most 20 contacts and loads rounded up to whole blocks. "
      "Default: the larger of 90 and six blocks; with more than 20 contacts and loads 100",
      {.range = {1, 2000}});
  const Argument mpi = command.option("--mpi", arguments->launch.processes,
                                      "MPI processes that share the factors of the stiffness, by MUMPS: for "
                                      "structures whose factors do not fit into the memory of one machine",
                                      {.range = {1, 4096}});
  command.option("--launcher", arguments->launch.launcher, "what starts them, with its options, before -n N",
                 {.needs = mpi});
}

}  // namespace signorini
