#pragma once
// A run of a whole plan: every case gets its record in the store, scene by scene, the rounds of timing of a
// scene's cases interleaved.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/responses/exact_response.hpp"
#include "harness/run/runner.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/run_folder/run_folder.hpp"

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

/// Asks the methods of cases of one scene, computes the references of its solves and gives responses their
/// tasks. \param exact  the exact response of the scene; must outlive the jobs \return fewer jobs than cases
/// after an interrupt
std::vector<Job> prepared_jobs(Runner& runner, const Scene& scene, std::span<const Case* const> cases,
                               ExactResponse& exact);

/// Cases of a plan with their keys, each key once.
std::vector<PlannedCase> planned_cases(const Plan& plan, const Runner& runner);

/// Whether a case fails a run, exit code 1: neither converged nor not applicable, nor expected to fail by the
/// suite.
bool is_unexpected(const std::string& case_id, Status status, const Suite& suite);

/// Follows the cases of a scene through their rounds; `index` is that of the job.
struct RoundObserver {
  /// \param what  the case, or the round of several, for a person
  std::function<void(const std::string& what)> begins = [](const std::string&) {};
  using Take = std::function<void(std::size_t index, const Record& record)>;
  Take round_done = [](std::size_t, const Record&) {};  ///< the record lacks rounds of timing yet
  Take case_done = [](std::size_t, const Record&) {};   ///< the record is complete
};

/// Runs every job, round by round in random order: the first round solves, measures and certifies, the later
/// ones only time. A case that fails has no later rounds. \param begun  what an earlier, interrupted run left
/// of each job, if anything \return the record of each job; nothing of one that an interrupt left incomplete
std::vector<std::optional<Record>> run_rounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
                                              std::vector<std::optional<Record>> begun,
                                              const Schedule& schedule, const RoundObserver& observer);

}  // namespace signorini
