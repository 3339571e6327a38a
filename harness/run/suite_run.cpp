#include "harness/run/suite_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/progress.hpp"

namespace signorini {

namespace {

/// Runs cases of one scene. \return the records of those that no interrupt prevented, in the order of the
/// cases
std::vector<Record> run_scene(const Scene& scene, const std::vector<const Case*>& cases,
                              const Schedule& schedule, Runner& runner, RecordStore& store,
                              Progress& progress) {
  progress.begin(scene.problem.name + ": references");
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  if (!interrupted()) runner.compute_references(scene, jobs);
  if (interrupted()) return {};
  std::vector<std::optional<Record>> begun;
  for (const Case* planned_case : cases)
    begun.push_back(store.unfinished(runner.key_of(scene, *planned_case)));
  const double share_of_round = 1.0 / runner.limits().repetitions;  // of a case, for the progress
  std::vector<double> rest(cases.size(), 1.0);                      // of each case
  const RoundObserver observer{.begins = [&](const std::string& what) { progress.begin(what); },
                               .round_done =
                                   [&](std::size_t index, const Record& record) {
                                     store.keep_unfinished(record);
                                     progress.advance(share_of_round);
                                     rest[index] -= share_of_round;
                                   },
                               .case_done =
                                   [&](std::size_t index, const Record& record) {
                                     store.append(record);
                                     progress.advance(rest[index]);
                                   }};
  std::vector<Record> records;
  for (std::optional<Record>& record :
       run_rounds(runner, scene, jobs, std::move(begun), schedule, observer)) {
    if (record) records.push_back(std::move(*record));
  }
  return records;
}

/// Cases of the plan that the store does not hold, in order, by scene.
std::vector<std::vector<const Case*>> missing_cases(const Plan& plan, const Runner& runner,
                                                    const RecordStore& store) {
  std::vector<std::vector<const Case*>> missing(plan.scenes.size());
  std::unordered_set<std::string> planned;
  for (const Case& planned_case : plan.cases) {
    // Two spellings of one case ("harmonics=20" and the default) have one key.
    const std::string key = runner.key_of(plan.scenes[planned_case.scene], planned_case);
    if (!store.contains(key) && planned.insert(key).second)
      missing[planned_case.scene].push_back(&planned_case);
  }
  return missing;
}

/// The cases of one scene and what is known of each.
struct SceneRounds {
  Runner& runner;
  const Scene& scene;
  std::span<const Job> jobs;
  std::vector<std::optional<Record>> records;
  Schedule schedule;
  const RoundObserver& observer;

  std::vector<std::optional<Record>> run() {
    // Begun cases that lack no round are done: no round would be due that says so.
    for (std::size_t i = 0; i < records.size(); ++i) {
      if (records[i] && runner.rounds_missing(*records[i]) == 0) observer.case_done(i, *records[i]);
    }
    for (int round = 0; round < runner.limits().repetitions; ++round) run_round(round);
    for (std::optional<Record>& record : records) {
      if (record && runner.rounds_missing(*record) > 0) record.reset();
    }
    return std::move(records);
  }

  /// A case that was begun in an earlier run may be some rounds ahead of the others.
  [[nodiscard]] bool is_due(const std::optional<Record>& record, int round) const {
    if (round == 0) return !record;
    return record && runner.rounds_missing(*record) > 0 &&
           static_cast<int>(record->seconds->rounds.size()) <= round;
  }

  void run_round(int round) {
    std::vector<std::size_t> due = round_order(jobs.size(), schedule.seed, scene.problem.name, round);
    std::erase_if(due, [&](std::size_t index) { return !is_due(records[index], round); });
    // One by one where one runs at a time: each is announced before it begins.
    const std::size_t together = schedule.parallel > 1 ? std::max<std::size_t>(1, due.size()) : 1;
    for (std::size_t i = 0; i < due.size() && !interrupted(); i += together)
      run_together(std::span(due).subspan(i, together), round);
  }

  void run_together(std::span<const std::size_t> indices, int round) {
    observer.begins(indices.size() == 1 ? jobs[indices.front()].planned_case->id
                                        : fmt::format("{}, round {}", scene.problem.name, round + 1));
    std::vector<Job> due;
    for (const std::size_t index : indices) due.push_back(jobs[index]);
    const TakeRecord take = [&](std::size_t k, Record record) { take_record(indices[k], std::move(record)); };
    if (round == 0) return runner.run_first(scene, due, schedule.parallel, take);
    std::vector<Record> begun;
    for (const std::size_t index : indices) begun.push_back(*records[index]);
    runner.run_later(scene, due, begun, schedule.parallel, take);
  }

  void take_record(std::size_t index, Record record) {
    if (record.seconds && schedule.together() > 1) record.seconds->jobs = schedule.together();
    records[index] = std::move(record);
    if (runner.rounds_missing(*records[index]) > 0) {
      observer.round_done(index, *records[index]);
    } else {
      observer.case_done(index, *records[index]);
    }
  }
};

}  // namespace

std::vector<PlannedCase> planned_cases(const Plan& plan, const Runner& runner) {
  std::vector<PlannedCase> cases;
  std::unordered_set<std::string> keys;
  for (const Case& planned_case : plan.cases) {
    const std::string key = runner.key_of(plan.scenes[planned_case.scene], planned_case);
    if (keys.insert(key).second)
      cases.push_back(
          {.key = key, .case_id = planned_case.id, .method = std::string(planned_case.choice.entry->name)});
  }
  return cases;
}

SuiteRunResult run_plan(const Plan& plan, Runner& runner, RecordStore& store, const Schedule& schedule,
                        const SceneDone& scene_done) {
  const std::vector<std::vector<const Case*>> missing = missing_cases(plan, runner, store);
  std::size_t count = 0;
  for (const std::vector<const Case*>& cases : missing) count += cases.size();
  SuiteRunResult result{.present = plan.cases.size() - count};
  Progress progress(count);
  for (std::size_t s = 0; s < plan.scenes.size(); ++s) {
    const std::vector<const Case*>& cases = missing[s];
    if (cases.empty()) continue;
    runner.forget_references();
    const std::vector<Record> records = run_scene(plan.scenes[s], cases, schedule, runner, store, progress);
    result.ran += records.size();
    if (interrupted()) {
      result.interrupted = true;
      return result;
    }
    store.clear_unfinished();
    if (!scene_done || records.empty()) continue;
    progress.clear();
    scene_done(records);
  }
  // An earlier run may have been killed between its last record and this.
  store.clear_unfinished();
  return result;
}

bool is_unexpected(const std::string& case_id, Status status, const Suite& suite) {
  if (status == Status::converged || status == Status::not_applicable) return false;
  return std::ranges::none_of(suite.expected_failures, [&](const ExpectedFailure& expected) {
    return glob_match(expected.case_glob, case_id);
  });
}

std::vector<std::optional<Record>> run_rounds(Runner& runner, const Scene& scene, std::span<const Job> jobs,
                                              std::vector<std::optional<Record>> begun,
                                              const Schedule& schedule, const RoundObserver& observer) {
  return SceneRounds{runner, scene, jobs, std::move(begun), schedule, observer}.run();
}

}  // namespace signorini
