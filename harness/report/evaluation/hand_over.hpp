#pragma once
// Commands that stay between solves tell their own time; what passes beside it is their hand-over.

#include <string>
#include <vector>

#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// A configuration whose cases tell their own time, medians over those that were timed.
struct HandOver {
  std::string configuration = {};
  int cases = 0;
  double own = 0.0;     ///< set-up and solve by the command's own account, as tables show them [s]
  double beside = 0.0;  ///< writing the problem, waiting for and reading the answer of one solve [s]
};

/// Of each configuration with a record that has Seconds::exchange, in the order of configurations.
std::vector<HandOver> hand_overs(const Evaluation& evaluation);

}  // namespace signorini
