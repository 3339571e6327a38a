#include "harness/reduction/shared_reduction.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/child_process.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

fs::path reducer() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / kSharedReducer;
  if (!fs::exists(program))
    throw UsageError(
        fmt::format("mpi (must be left out: {} is not beside the program; the package signorini-mpi has it, "
                    "and a build where libmumps-dev is installed)",
                    kSharedReducer));
  return program;
}

std::vector<std::string> words_of(const ReductionOrder& order, const MpiLaunch& launch) {
  std::vector<std::string> words = split(launch.launcher, ' ');
  std::erase(words, "");
  if (words.empty()) throw UsageError("launcher (must name a command)");
  for (const std::string& word : {std::string("-n"), std::to_string(launch.processes), reducer().string(),
                                  order.scene, order.out.string(), std::to_string(order.vectors)})
    words.push_back(word);
  return words;
}

}  // namespace

std::string reduce_by_mpi(const ReductionOrder& order, const MpiLaunch& launch) {
  const std::vector<std::string> words = words_of(order, launch);
  const ProgramEnd end = run_to_end(words);
  if (end.missing()) throw UsageError(fmt::format("launcher = {} (could not be run)", launch.launcher));
  const std::string last = last_line(end.output);
  if (last.starts_with(kReductionRefused)) throw UsageError(last.substr(kReductionRefused.size()));
  if (last.starts_with(kReductionFailed)) throw ReductionFailure(last.substr(kReductionFailed.size()));
  if (interrupted()) return {};
  if (last != kReductionDone)
    throw ReductionFailure(fmt::format("{} ended with code {} before it was done", words.front(), end.code));
  return end.output.substr(0, end.output.rfind(kReductionDone));
}

}  // namespace signorini
