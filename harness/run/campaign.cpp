#include "harness/run/campaign.hpp"

#include <algorithm>
#include <map>
#include <unordered_set>
#include <utility>

#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/progress.hpp"

namespace signorini {

namespace {

/// Runs cases of one scene and tells of their records; false if interrupted.
bool run_scene(const Scene& scene, const std::vector<const Case*>& cases, const Schedule& schedule,
               Runner& runner, RecordStore& store, Progress& progress, CampaignResult& result,
               const SceneDone& scene_done) {
  progress.begin(scene.problem.name + ": references");
  const std::vector<Survey> surveys = runner.survey(scene, cases);
  if (interrupted()) return false;
  runner.compute_references(scene, surveys);
  if (interrupted()) return false;
  std::vector<Job> jobs;
  std::vector<std::optional<Record>> begun;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    jobs.push_back({.run = cases[i], .survey = &surveys[i]});
    begun.push_back(store.unfinished(runner.key_of(scene, *cases[i])));
  }
  const double round = 1.0 / runner.limits().repetitions;
  std::vector<double> rest(cases.size(), 1.0);  // of each case, for the progress
  std::map<std::size_t, Record> done;
  const RoundEvents events{.begin = [&](const std::string& what) { progress.begin(what); },
                           .unfinished =
                               [&](std::size_t index, const Record& record) {
                                 store.keep_unfinished(record);
                                 progress.advance(round);
                                 rest[index] -= round;
                               },
                           .complete =
                               [&](std::size_t index, const Record& record) {
                                 store.append(record);
                                 done[index] = record;
                                 progress.advance(rest[index]);
                                 ++result.ran;
                               }};
  if (!run_rounds(runner, scene, jobs, std::move(begun), schedule, events)) return false;
  store.clear_unfinished();
  if (!scene_done || done.empty()) return true;
  std::vector<Record> records;
  for (auto& [index, record] : done) records.push_back(std::move(record));
  progress.clear();
  scene_done(records);
  return true;
}

}  // namespace

std::vector<PlannedCase> planned_cases(const Plan& plan, const Runner& runner) {
  std::vector<PlannedCase> cases;
  std::unordered_set<std::string> keys;
  for (const Case& run : plan.cases) {
    const std::string key = runner.key_of(plan.scenes[run.scene], run);
    if (keys.insert(key).second) cases.push_back({.key = key, .case_id = run.id});
  }
  return cases;
}

std::vector<const Case*> missing_cases(const Plan& plan, const Runner& runner, const RecordStore& store) {
  std::vector<const Case*> missing;
  std::unordered_set<std::string> planned;
  for (const Case& run : plan.cases) {
    // Two spellings of one case ("harmonics=20" and the default) are one run.
    const std::string key = runner.key_of(plan.scenes[run.scene], run);
    if (!store.contains(key) && planned.insert(key).second) missing.push_back(&run);
  }
  return missing;
}

CampaignResult run_campaign(const Plan& plan, Runner& runner, RecordStore& store, const Schedule& schedule,
                            const SceneDone& scene_done) {
  const std::vector<const Case*> missing = missing_cases(plan, runner, store);
  CampaignResult result;
  result.present = plan.cases.size() - missing.size();
  Progress progress(missing.size());
  for (std::size_t s = 0; s < plan.scenes.size(); ++s) {
    std::vector<const Case*> cases;
    std::copy_if(missing.begin(), missing.end(), std::back_inserter(cases),
                 [&](const Case* run) { return run->scene == s; });
    if (cases.empty()) continue;
    runner.forget_references();
    if (!run_scene(plan.scenes[s], cases, schedule, runner, store, progress, result, scene_done)) {
      result.interrupted = true;
      break;
    }
  }
  // An earlier run may have been killed between its last record and this.
  if (!result.interrupted) store.clear_unfinished();
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
