#pragma once
// Runs a suite of responses: every method's curve against the exact one.

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/responses/response_record.hpp"

namespace signorini {

/// One response of one method.
struct ResponseCase {
  std::size_t response = 0;  ///< index into Suite::responses
  MethodChoice method = {};
  bool by_steps = false;  ///< of the frequency, instead of by arc length
  std::string id = {};    ///< "sdof-stop/aft-hbm[harmonics=20] by steps"
};

/// The responses that the filters leave, and the cases of each: the methods of the suite by arc length where
/// they have curves of their own, its `by_steps` by steps. Method names that the suite does not list take
/// their own ladders. \throws NothingMatched, UsageError, InvalidOption
std::vector<ResponseCase> response_cases(const Suite& suite, const Narrowing& narrowing,
                                         std::span<const MethodEntry> catalogue);

/// How a run of responses went.
struct ResponseRunResult {
  std::size_t ran = 0, present = 0;
  bool interrupted = false;
};

/// Runs the cases scene by scene. The exact response of a scene comes first: continuation of exact orbits
/// with steps of a third of the usual length. A method follows its curve in a process of its own, once or
/// more for the time (the least counts) and once for its motions; of steps each solve has a process, and the
/// time is the sum of theirs. After each case DIR/responses.jsonl is written anew; with `resume` cases that
/// are there stay. A response is given Limits::timeout, the exact one Limits::reference_timeout. \throws
/// UsageError if the folder cannot be written, SceneError, BadRecord
ResponseRunResult run_responses(const Suite& suite, std::span<const ResponseCase> cases, const Limits& limits,
                                const std::filesystem::path& folder, bool resume);

}  // namespace signorini
