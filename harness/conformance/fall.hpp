#pragma once
// How errors fall along the ladder of a method.

#include <optional>
#include <vector>

#include "harness/conformance/finding.hpp"
#include "harness/plan/selection.hpp"

namespace signorini {

/// A declared order is met by this share of it: errors of a few coarse steps scatter.
inline constexpr double kOrderShare = 0.75;
/// Without a declared order the error must fall to this share of the first from the first step to the last.
inline constexpr double kFall = 0.5;

/// One step of a ladder: how fine it is, and what it reached.
struct LadderStep {
  double size =
      1.0;  ///< the number that its settings vary, or its inverse where that grows along the ladder [-]
  double error = 0.0;  ///< relative [-]
};

/// Steps of a ladder that differ in one number, coarse to fine, by their places in it.
struct LadderBranch {
  std::string words = {};  ///< the settings that are no numbers, "flow=modal"
  std::vector<std::size_t> places = {};
  std::vector<double> sizes = {};
};

/// The branches of a ladder in the order of their first steps. Where several numbers vary, sizes are the
/// places' own inverses, and no order can be told from them.
std::vector<LadderBranch> branches_of(const std::vector<Settings>& ladder);

/// Order p of error ~ size^p from the first step to the last; empty for less than two sizes.
std::optional<double> observed_order(const std::vector<LadderStep>& steps);

/// Whether errors fall as declared: the last is at `floor` or below, or the observed order is kOrderShare of
/// the declared one, or without one the last error is kFall of the first. Nothing can be told of a single
/// step above the floor.
CheckResult judge_fall(const std::vector<LadderStep>& steps, std::optional<double> order, double floor);

}  // namespace signorini
