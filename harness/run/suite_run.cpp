#include "harness/run/suite_run.hpp"

#include <algorithm>
#include <map>
#include <unordered_set>
#include <utility>

#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/progress.hpp"
#include "harness/run/rounds.hpp"

namespace signorini {

namespace {

/// Stores the records of one scene's cases and shows the progress.
class SceneObserver final : public RoundObserver {
 public:
  /// \param completed  counts the cases whose records are complete
  SceneObserver(RecordStore& store, Progress& progress, std::size_t cases, int rounds, std::size_t& completed)
      : store_(store),
        progress_(progress),
        share_of_round_(1.0 / rounds),
        rest_(cases, 1.0),
        completed_(completed) {}

  void begins(const std::string& what) override { progress_.begin(what); }
  void round_done(std::size_t index, const Record& record) override {
    store_.keep_unfinished(record);
    progress_.advance(share_of_round_);
    rest_[index] -= share_of_round_;
  }
  void case_done(std::size_t index, const Record& record) override {
    store_.append(record);
    progress_.advance(rest_[index]);
    done_[index] = record;
    ++completed_;
  }

  /// In the order of the jobs.
  [[nodiscard]] std::vector<Record> records() const {
    std::vector<Record> records;
    for (const auto& [index, record] : done_) records.push_back(record);
    return records;
  }

 private:
  RecordStore& store_;
  Progress& progress_;
  double share_of_round_;     // of a case, for the progress
  std::vector<double> rest_;  // of each case
  std::map<std::size_t, Record> done_;
  std::size_t& completed_;
};

/// Runs cases of one scene. \param completed  counts them \return their records; empty after an interrupt
std::optional<std::vector<Record>> run_scene(const Scene& scene, const std::vector<const Case*>& cases,
                                             const Schedule& schedule, Runner& runner, RecordStore& store,
                                             Progress& progress, std::size_t& completed) {
  progress.begin(scene.problem.name + ": references");
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  if (interrupted()) return std::nullopt;
  runner.compute_references(scene, jobs);
  if (interrupted()) return std::nullopt;
  std::vector<std::optional<Record>> begun;
  for (const Case* planned_case : cases)
    begun.push_back(store.unfinished(runner.key_of(scene, *planned_case)));
  SceneObserver observer(store, progress, cases.size(), runner.limits().repetitions, completed);
  const bool complete = run_rounds(runner, scene, jobs, std::move(begun), schedule, observer);
  if (!complete) return std::nullopt;
  store.clear_unfinished();
  return observer.records();
}

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

std::vector<const Case*> missing_cases(const Plan& plan, const Runner& runner, const RecordStore& store) {
  std::vector<const Case*> missing;
  std::unordered_set<std::string> planned;
  for (const Case& planned_case : plan.cases) {
    // Two spellings of one case ("harmonics=20" and the default) have one key.
    const std::string key = runner.key_of(plan.scenes[planned_case.scene], planned_case);
    if (!store.contains(key) && planned.insert(key).second) missing.push_back(&planned_case);
  }
  return missing;
}

SuiteRunResult run_plan(const Plan& plan, Runner& runner, RecordStore& store, const Schedule& schedule,
                        const SceneDone& scene_done) {
  const std::vector<const Case*> missing = missing_cases(plan, runner, store);
  SuiteRunResult result{.present = plan.cases.size() - missing.size()};
  Progress progress(missing.size());
  for (std::size_t s = 0; s < plan.scenes.size(); ++s) {
    std::vector<const Case*> cases;
    std::copy_if(missing.begin(), missing.end(), std::back_inserter(cases),
                 [&](const Case* planned_case) { return planned_case->scene == s; });
    if (cases.empty()) continue;
    runner.forget_references();
    const auto records = run_scene(plan.scenes[s], cases, schedule, runner, store, progress, result.ran);
    if (!records) {
      result.interrupted = true;
      return result;
    }
    if (!scene_done || records->empty()) continue;
    progress.clear();
    scene_done(*records);
  }
  // An earlier run may have been killed between its last record and this.
  store.clear_unfinished();
  return result;
}

std::vector<std::string> unexpected_failures(const std::vector<Record>& records, const Suite& suite) {
  std::vector<std::string> failures;
  for (const Record& record : records) {
    if (record.status == Status::converged || record.status == Status::not_applicable) continue;
    const auto expected = [&](const ExpectedFailure& e) { return glob_match(e.case_glob, record.case_id); };
    if (std::any_of(suite.expected_failures.begin(), suite.expected_failures.end(), expected)) continue;
    failures.push_back(record.case_id);
  }
  return failures;
}

}  // namespace signorini
