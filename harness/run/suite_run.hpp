#pragma once
// A run of a whole plan: every case gets its record in the store.

#include <functional>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/plan/schedule.hpp"
#include "harness/records/record_store.hpp"
#include "harness/records/run_folder.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

struct SuiteRunResult {
  std::size_t ran = 0;      ///< cases run now
  std::size_t present = 0;  ///< cases whose record was there already
  bool interrupted = false;
};

/// Called with the records of a scene, in the order of the plan, once all of them are complete.
using SceneDone = std::function<void(const std::vector<Record>& records)>;

/// Runs what the store does not hold yet, scene by scene, each record stored as soon as its rounds are
/// complete; what is known before is kept aside, so that a kill loses only the round under way.
SuiteRunResult run_plan(const Plan& plan, Runner& runner, RecordStore& store, const Schedule& schedule = {},
                        const SceneDone& scene_done = {});

/// Cases of a plan with their keys, each key once.
std::vector<PlannedCase> planned_cases(const Plan& plan, const Runner& runner);

/// Cases of the plan that the store does not hold, in order.
std::vector<const Case*> missing_cases(const Plan& plan, const Runner& runner, const RecordStore& store);

/// Cases that fail a run, exit code 1: neither converged nor not applicable, nor expected to fail by the
/// suite.
std::vector<std::string> unexpected_failures(const std::vector<Record>& records, const Suite& suite);

}  // namespace signorini
