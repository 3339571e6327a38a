#pragma once
// The motion that the solves of a case start from where its setting `start` asks for one.

#include <memory>
#include <string>

#include "harness/judge/reference.hpp"
#include "harness/plan/plan.hpp"

namespace signorini {

struct StartPoint {
  std::shared_ptr<const Trajectory> motion = {};  ///< null: cold, at rest
  std::string obstacle = {};                      ///< why there is no motion though one is asked for
};

/// The reference orbit, late by the share of its period that the case asks for (MethodChoice::start) and
/// repeated to the period of the problem; cold if the case asks for none.
StartPoint start_point(const Case& planned_case, const Problem& problem, const Reference& reference);

}  // namespace signorini
