#pragma once
// All checks of a method, in processes of their own: a crash or a hang is a finding, not the end.

#include <functional>
#include <string>
#include <vector>

#include "harness/conformance/finding.hpp"
#include "harness/plan/plan.hpp"

namespace signorini {

/// What is asked of a method.
struct ConformanceQuest {
  std::vector<Scene> scenes = {};
  std::string checks = "*";  ///< filter of globs on names of checks
  double timeout = 10.0;     ///< of one solve [s]
};

/// Told what is under way.
using ConformanceNews = std::function<void(const std::string& what)>;

/// Findings in the order of the checks, each on the scenes in their order; method's own checks first. Once a
/// check has outlasted its limit, the others on that scene are not asked: they are `not_applicable`. Ends
/// early, with what is known, after an interrupt. \throws NothingMatched if the filter takes no check
std::vector<CheckFinding> check_method(const MethodEntry& entry, const ConformanceQuest& quest,
                                       const ConformanceNews& news = {});

/// Names of all checks, in order.
std::vector<std::string> check_names();

/// Whether one of the findings failed.
bool any_failed(const std::vector<CheckFinding>& findings);

}  // namespace signorini
