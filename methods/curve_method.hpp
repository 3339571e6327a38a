#pragma once
// What a method offers beside single solves: its own curve over the frequency of the load.

#include <chrono>
#include <vector>

#include "methods/method.hpp"
#include "methods/orbit/continuation/branch.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Limits of a diagram of branches. Cascades of doublings are infinite; without limits it would not end.
struct CurveLimits {
  int max_order = 2;      ///< forcing periods per period; the scene's order where that is larger
  int max_branches = 60;  ///< in all
  int max_points = 2000;  ///< of one branch
  int phases = 0;         ///< of a forcing period at which the points keep their motion; 0: it is not kept
  std::vector<double> at = {};  ///< frequencies at which every branch has points [rad/s]
  TakeBranch take = {};         ///< called with each branch as soon as it is known
  /// The end of the time budget.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// A method that follows the solutions of its own equations by arc length. Derived from beside Method.
class CurveMethod {
 public:
  virtual ~CurveMethod() = default;
  /// The branches that hang together with its answers at both ends of an interval of frequencies. Every end
  /// of a branch has its reason; where nothing could be followed, `unfinished` says why. Numerical failure is
  /// a diagram too, never an exception.
  /// \param problem  valid and supported at both ends; its own frequency does not count
  /// \param from, to  > 0, different [rad/s]
  [[nodiscard]] virtual BranchDiagram follow(const Problem& problem, double from, double to,
                                             const CurveLimits& limits) const = 0;
};

}  // namespace signorini
