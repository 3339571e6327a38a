#include "harness/run_folder/status.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "harness/run_folder/record_store.hpp"
#include "harness/run_folder/shards.hpp"

namespace signorini {

namespace {

std::size_t& counter_of(Status status, RunStatus& counters) {
  if (status == Status::converged) return counters.converged;
  if (status == Status::not_applicable) return counters.not_applicable;
  return status == Status::inaccurate ? counters.inaccurate : counters.failed;
}

}  // namespace

RunStatus status_of(const RunFolder& run) {
  RunStatus status;
  std::unordered_set<std::string_view> present;
  for (const RecordEntry& record : run.records) {
    present.insert(record.key);
    ++counter_of(record.status, status);
    if (record.status != Status::converged && record.status != Status::not_applicable)
      status.failures.push_back({.case_id = record.case_id, .status = record.status});
  }
  status.stale = run.stale.size();
  status.planned = run.plan.empty() ? present.size() : run.plan.size();
  status.pending = status.planned - present.size();
  status.running = folder_in_use(run.path);
  if (status.pending == 0 || run.stale.size() + run.records.size() == 0) return status;
  Durations durations(run.stale);
  durations.add(run.records);
  const double jobs = run.manifest.value("jobs", 1.0);
  double seconds = 0.0;
  for (const PlannedCase& one : run.plan) {
    // As if the jobs stayed busy to the end: the time is a little too short where one long case is the last.
    if (!present.contains(one.key)) seconds += durations.of(one.case_id, one.method) / jobs;
  }
  status.remaining_seconds = seconds;
  return status;
}

RunStatus together(const std::vector<RunStatus>& parts) {
  RunStatus all;
  for (const RunStatus& part : parts) {
    for (const auto counter :
         {&RunStatus::planned, &RunStatus::converged, &RunStatus::inaccurate, &RunStatus::not_applicable,
          &RunStatus::failed, &RunStatus::pending, &RunStatus::stale}) {
      all.*counter += part.*counter;
    }
    all.failures.insert(all.failures.end(), part.failures.begin(), part.failures.end());
    all.running = all.running || part.running;
    if (part.remaining_seconds)
      all.remaining_seconds = std::max(all.remaining_seconds.value_or(0.0), *part.remaining_seconds);
  }
  return all;
}

}  // namespace signorini
