#pragma once
// The cases of one scene, their rounds of timing interleaved.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/run/runner.hpp"

namespace signorini {

/// How the cases of a scene take turns.
struct Turns {
  std::uint64_t seed = 1;  ///< of the Latin squares, one for each scene
  int parallel = 1;        ///< cases at the same time
  int beside = 1;          ///< such runs on this machine at the same time, this one included

  /// Cases at the same time on this machine.
  [[nodiscard]] int together() const { return parallel * beside; }
};

/// Told of what happens; `index` is that of the job.
struct RoundEvents {
  std::function<void(const std::string& what)> begin = {};
  std::function<void(std::size_t index, const Record& record)> unfinished = {};  ///< rounds are missing yet
  std::function<void(std::size_t index, const Record& record)> complete = {};
};

/// Runs every job, round by round in the order of a Latin square: the first round solves, measures and
/// certifies, the later ones only time. A case that fails leaves. \param begun  what an earlier, interrupted
/// run left of each job, if anything \return false if interrupted
bool run_rounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
                std::vector<std::optional<Record>> begun, const Turns& turns, const RoundEvents& events);

}  // namespace signorini
