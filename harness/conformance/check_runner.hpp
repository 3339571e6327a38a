#pragma once
// Runs the checks of a method in child processes: a crash or a hang of the method is the result of a check.

#include <functional>
#include <string>
#include <vector>

#include "harness/conformance/check_result.hpp"
#include "harness/plan/plan.hpp"

namespace signorini {

/// What a method is checked on.
struct CheckOptions {
  std::vector<Scene> scenes = {};
  std::string checks = "*";  ///< filter of globs on the names of the checks
  double timeout = 10.0;     ///< processor time of one solve [s]
};

/// Called with one line before each group of checks: the method, and the scene.
using CheckProgress = std::function<void(const std::string& what)>;

/// The results in the order of the checks, those of the method alone first, and for each check in the order
/// of the scenes. After a check that exceeded its time limit, the remaining checks on that scene are
/// `not_applicable`. After an interrupt, the results until then. \throws NothingMatched if the filter matches
/// no check
std::vector<CheckResult> check_method(const MethodEntry& entry, const CheckOptions& options,
                                      const CheckProgress& progress = {});

/// Names of all checks, in the order of the results.
std::vector<std::string> check_names();

/// Whether one of the checks failed.
bool any_failed(const std::vector<CheckResult>& results);

}  // namespace signorini
