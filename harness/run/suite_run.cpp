#include "harness/run/suite_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <unordered_set>
#include <utility>

#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/progress.hpp"
#include "harness/responses/response_task.hpp"
#include "harness/run_folder/machine_load.hpp"

namespace signorini {

namespace {

/// Runs cases of one scene. \return the records of those that no interrupt prevented, in the order of the
/// cases
std::vector<Record> run_scene(const Scene& scene, const std::vector<const Case*>& cases,
                              const Schedule& schedule, Runner& runner, RecordStore& store,
                              ExactResponse& exact, Progress& progress) {
  progress.begin(scene.problem.name + ": references");
  const std::vector<Job> jobs = prepared_jobs(runner, scene, cases, exact);
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
                                     const double share = std::min(share_of_round, rest[index]);
                                     progress.advance(share);
                                     rest[index] -= share;
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

bool is_exact(const Case& one) { return one.response && one.response->way == ResponseWay::exact; }

/// Whether the cases have a response that needs the exact one, which is not among them.
bool lacks_exact(const std::vector<const Case*>& cases) {
  return std::ranges::any_of(cases, [](const Case* one) { return one->response.has_value(); }) &&
         std::ranges::none_of(cases, [](const Case* one) { return is_exact(*one); });
}

/// Cases of the plan that the store does not hold, in order, by scene; and before others the exact response
/// that they are measured against, unless its file is there.
std::vector<std::vector<const Case*>> missing_cases(const Plan& plan, const Runner& runner,
                                                    const RecordStore& store, ExactResponse& exact) {
  std::vector<std::vector<const Case*>> missing(plan.scenes.size());
  std::unordered_set<std::string> planned;
  for (const Case& planned_case : plan.cases) {
    // Two spellings of one case ("harmonics=20" and the default) have one key.
    const std::string key = runner.key_of(plan.scenes[planned_case.scene], planned_case);
    if (!store.contains(key) && planned.insert(key).second)
      missing[planned_case.scene].push_back(&planned_case);
  }
  for (const Case& planned_case : plan.cases) {
    std::vector<const Case*>& cases = missing[planned_case.scene];
    const Scene& scene = plan.scenes[planned_case.scene];
    if (is_exact(planned_case) && lacks_exact(cases) &&
        !exact.read(scene.problem.name, runner.key_of(scene, planned_case)))
      cases.insert(cases.begin(), &planned_case);
  }
  return missing;
}

/// Takes the exact response of a scene from its file.
void read_exact(const Plan& plan, std::size_t scene, const Runner& runner, ExactResponse& exact) {
  for (const Case& one : plan.cases) {
    if (one.scene == scene && is_exact(one))
      static_cast<void>(exact.read(plan.scenes[scene].problem.name, runner.key_of(plan.scenes[scene], one)));
  }
}

/// The cases of one scene and what is known of each.
struct SceneRounds {
  Runner& runner;
  const Scene& scene;
  std::span<const Job> jobs;
  std::vector<std::optional<Record>> records;
  Schedule schedule;
  const RoundObserver& observer;

  std::vector<int> least = std::vector<int>(jobs.size(), 1);       // rounds of each job
  std::vector<bool> done = std::vector<bool>(jobs.size(), false);  // and told so

  std::vector<std::optional<Record>> run() {
    int round = 0;
    while (round < runner.limits().repetitions) run_round(round++);
    measure_equal_solves_again();
    while (!interrupted() && rounds_are_missing()) run_round(round++);  // of what is unsteady
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!records[i]) continue;
      if (missing(i) > 0)
        records[i].reset();
      else if (!done[i])
        observer.case_done(i, *records[i]);
    }
    return std::move(records);
  }

  [[nodiscard]] bool rounds_are_missing() const {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (records[i] && missing(i) > 0) return true;
    }
    return false;
  }

  [[nodiscard]] int missing(std::size_t i) const {
    return runner.rounds_missing(*records[i], schedule.more_rounds, least[i]);
  }

  /// Whether a case has one round that may have to be confirmed by another one.
  [[nodiscard]] bool is_unconfirmed(std::size_t i) const {
    const Record& record = *records[i];
    return schedule.more_rounds > 0 && record.seconds && record.seconds->rounds.size() == 1 &&
           !record.answer.empty();
  }

  /// Cases of one method with the same problem and the same answer to the last bit are one solve: where their
  /// times differ by more than kSteadyFactor, those of a single round get another one.
  void measure_equal_solves_again() {
    std::map<std::array<std::string, 3>, std::vector<std::size_t>> equal;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!records[i] || !records[i]->seconds) continue;
      const Record& record = *records[i];
      if (!record.answer.empty() && !record.problem.empty())
        equal[{record.method, record.problem, record.answer}].push_back(i);
    }
    if (schedule.more_rounds == 0) return;
    const auto seconds = [&](std::size_t i) { return records[i]->seconds->median; };
    for (const auto& [what, cases] : equal) {
      const auto [shortest, longest] = std::ranges::minmax(cases, {}, seconds);
      if (seconds(longest) <= kSteadyFactor * seconds(shortest)) continue;
      for (const std::size_t i : cases) least[i] = 2;
    }
  }

  /// What jobs of these are about: exact responses, which others are measured against, before all others.
  [[nodiscard]] int kind_of(std::size_t index) const {
    const std::optional<ResponseQuestion>& asked = jobs[index].planned_case->response;
    if (!asked) return 3;
    return asked->way == ResponseWay::exact ? 0 : asked->way == ResponseWay::arc_length ? 1 : 2;
  }

  /// A case that was begun in an earlier run may be some rounds ahead of the others.
  [[nodiscard]] bool is_due(std::size_t i, int round) const {
    if (round == 0 || !records[i]) return round == 0 && !records[i];
    return missing(i) > 0 && std::cmp_less_equal(records[i]->seconds->rounds.size(), round);
  }

  void run_round(int round) {
    std::vector<std::size_t> due = round_order(jobs.size(), schedule.seed, scene.problem.name, round);
    std::erase_if(due, [&](std::size_t index) { return !is_due(index, round); });
    // Exact responses first, which others are measured against; side by side only what is of one kind.
    std::ranges::stable_sort(due, {}, [&](std::size_t index) {
      return schedule.parallel > 1 ? kind_of(index) : std::min(kind_of(index), 1);
    });
    // One by one where one runs at a time: each is announced before it begins.
    for (std::size_t i = 0, next = 0; i < due.size() && !interrupted(); i = next) {
      do ++next;
      while (schedule.parallel > 1 && next < due.size() && kind_of(due[next]) == kind_of(due[i]));
      run_together(std::span(due).subspan(i, next - i), round);
    }
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
    if (record.seconds) {
      if (schedule.together() > 1) record.seconds->jobs = schedule.together();
      const bool is_later = records[index] && records[index]->seconds;
      const Measure before = is_later ? records[index]->seconds->load : std::nullopt;
      const Measure now = load_beside(schedule.together());
      record.seconds->load = now && before ? std::max(*now, *before) : now ? now : before;
    }
    records[index] = std::move(record);
    done[index] = missing(index) == 0 && !is_unconfirmed(index);
    (done[index] ? observer.case_done : observer.round_done)(index, *records[index]);
  }
};

}  // namespace

std::vector<Job> prepared_jobs(Runner& runner, const Scene& scene, std::span<const Case* const> cases,
                               ExactResponse& exact) {
  std::vector<Job> jobs = runner.make_jobs(scene, cases);
  give_tasks(scene, runner.limits(), exact, jobs);
  std::vector<Job> solves = jobs;
  std::erase_if(solves, [](const Job& job) { return job.task != nullptr; });
  if (!interrupted()) runner.compute_references(scene, solves);
  return jobs;
}

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
  ExactResponse exact(store.file().parent_path());
  const std::vector<std::vector<const Case*>> missing = missing_cases(plan, runner, store, exact);
  std::size_t count = 0;
  for (const std::vector<const Case*>& cases : missing) count += cases.size();
  SuiteRunResult result{.present = plan.cases.size() - count};
  Progress progress(count);
  for (std::size_t s = 0; s < plan.scenes.size(); ++s) {
    const std::vector<const Case*>& cases = missing[s];
    if (cases.empty()) continue;
    runner.forget_references();
    if (lacks_exact(cases)) read_exact(plan, s, runner, exact);
    const std::vector<Record> records =
        run_scene(plan.scenes[s], cases, schedule, runner, store, exact, progress);
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
