#pragma once
// Whether methods apply to a scene, asked in a process of their own.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/isolation/isolation.hpp"
#include "harness/plan/plan.hpp"

namespace signorini {

/// What the method of a case says of the scene, or how the process that asked it ended.
struct Applicability {
  bool applies = false;
  std::string reason = {};                 ///< why it does not apply
  std::optional<RepresentedLaw> law = {};  ///< that the method represents there; set if it applies
  std::optional<ChildEnd> failure = {};
};

/// Asks the methods of several cases of one scene, within ten seconds and 0.1 ms per coordinate each and
/// `memory_mb` MiB of address space. \return one answer for each case in their order; fewer after an
/// interrupt
std::vector<Applicability> ask_applicability(const Scene& scene, std::span<const Case* const> cases,
                                             int memory_mb);

}  // namespace signorini
