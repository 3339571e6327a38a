#pragma once
// Branches of a method that may crash or hang.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/sweep/branch_response.hpp"

namespace signorini {

/// What has arrived of a method's branches.
struct IsolatedBranches {
  BranchDiagram diagram = {};
  std::string failure =
      {};  ///< how its process ended early: "hat-lcp: signal 11 (Segmentation fault)"; or empty
};

/// Follows curves within limits; calls CurveLimits::take with the first ones, or all.
using FollowCurves = std::function<BranchDiagram(const CurveLimits& limits)>;

/// What `follow` finds in a process of its own, which ends soon after `limits.deadline`, within
/// Limits::memory_mb of default limits. `limits.take` is called here, with each branch as it arrives. Of a
/// process that ends early the branches that had arrived are there, and `unfinished` says the failure.
/// \param method  its label \throws UsageError where `follow` throws it or a SceneError
IsolatedBranches isolated_branches(const std::string& method, const CurveLimits& limits,
                                   const FollowCurves& follow);

/// branches_of in such a process.
/// \param beginnings  makes more of CurveLimits::begin_at, in that process, if given \return nothing where
/// the method has no curve of its own \throws UsageError as branches_of
std::optional<IsolatedBranches> isolated_branches(
    const ParametrisedScene& scene, const MethodChoice& method, const CurveLimits& limits,
    const std::function<std::vector<KnownMotion>()>& beginnings = {});

/// What a record of the method on the scene would say of its law (law_remark): "e = 1"; asked in a process of
/// its own. Empty where the method does not apply.
std::string law_remark_of(const Scene& scene, const MethodChoice& method);

}  // namespace signorini
