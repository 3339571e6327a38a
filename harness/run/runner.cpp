#include "harness/run/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <numbers>
#include <utility>

#include "harness/files.hpp"
#include "harness/interrupt.hpp"
#include "harness/judge/certificate.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/records/record_json.hpp"
#include "harness/run/round_messages.hpp"
#include "harness/run/trial.hpp"
#include "harness/text/json.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

/// What the first answer of a job may take [s].
double answer_seconds(const Limits& limits, std::span<const Job> jobs) {
  const bool task = !jobs.empty() && jobs.front().task;
  return task ? jobs.front().task->seconds() : enforced(limits.timeout);
}

/// Processor time of each stage: the first solve, a round of timing, the measures, the certificate; then the
/// end of the process. On a large structure the measures cost what the set-up did: both find receptances.
IsolationLimits first_round_limits(const Limits& limits, double solve) {
  return {.stage_seconds = {solve, solve + kQuickSeconds, solve + kQuickSeconds,
                            enforced(limits.certificate_timeout) + kQuickSeconds, kQuickSeconds},
          .memory_mb = limits.memory_mb};
}

/// The same of one round after another, each with a line per stage and kRoundDone.
IsolationLimits series_limits(const Limits& limits) {
  IsolationLimits result = first_round_limits(limits, enforced(limits.timeout));
  result.repeated = true;
  return result;
}

IsolationLimits later_round_limits(const Limits& limits, double solve) {
  return {.stage_seconds = {2.0 * solve + kQuickSeconds, kQuickSeconds}, .memory_mb = limits.memory_mb};
}

/// Whether a factorisation of K in this process, which has no limits, is a matter of seconds and of a quarter
/// of what a process may take.
bool is_shared(const Problem& problem, int memory_mb) {
  constexpr double kMostOperations = 1e11, kShare = 0.25;
  if (problem.size() <= kMostFactorised && !prefers_reduction(problem)) return false;
  const auto [operations, entries] = SparseCholesky::cost_of(problem.stiffness());
  return operations <= kMostOperations && 8.0 * entries <= kShare * (1 << 20) * memory_mb;
}

/// The judge's space of a large structure that several answers are judged on: made here once, and inherited
/// by the processes of all.
void share_space(const Problem& problem, std::span<const Job> jobs, int memory_mb, KeptSpace& spaces) try {
  const auto judged = [](const Job& job) { return job.method.applies && !job.task; };
  if (std::ranges::count_if(jobs, judged) > 1 && is_shared(problem, memory_mb))
    static_cast<void>(spaces.of(problem));
  else
    spaces.forget();
} catch (const std::exception&) {  // whoever needs it says why there is none
  spaces.forget();
}

/// Entries in (1, 2) without a pattern that the structure of a matrix could share: the fractions of i times
/// the golden ratio.
Eigen::VectorXd probe(Eigen::Index size) {
  Eigen::VectorXd entries(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double turn = static_cast<double>(i + 1) * std::numbers::phi;
    entries[i] = 1.0 + turn - std::floor(turn);
  }
  return entries;
}

}  // namespace

Runner::Runner(Limits limits, OrbitTools orbits, CodeVersion version)
    : limits_(limits), orbits_(std::move(orbits)), code_version_(std::move(version)) {}

std::string Runner::key_of(const Scene& scene, const Case& planned_case) const {
  const std::string version = code_version_(planned_case.choice.entry->name);
  if (!planned_case.response)
    return case_key(scene, planned_case, limits_, version, kept_reference_digest(scene, references_folder()));
  const std::string& other = planned_case.measured_by;
  return case_key(scene, planned_case, limits_, version, other.empty() ? "" : code_version_(other));
}

std::vector<Job> Runner::make_jobs(const Scene& scene, std::span<const Case* const> cases) const {
  std::vector<Job> jobs;
  for (Applicability& method : ask_applicability(scene, cases, limits_.memory_mb))
    jobs.push_back({.planned_case = cases[jobs.size()], .method = std::move(method)});
  return jobs;
}

std::vector<Job> Runner::make_jobs(const Scene& scene, const std::vector<Case>& cases) const {
  std::vector<const Case*> pointers;
  for (const Case& planned_case : cases) pointers.push_back(&planned_case);
  return make_jobs(scene, pointers);
}

void Runner::compute_references(const Scene& scene, std::span<const Job> jobs) {
  std::vector<Applicability> methods;
  for (const Job& job : jobs) methods.push_back(job.method);
  share_space(scene.problem, jobs, limits_.memory_mb, *orbits_.spaces);
  references_.compute(scene, methods, orbits_, limits_);
}

Record Runner::blank(const Scene& scene, const Job& job) const {
  const Case& planned_case = *job.planned_case;
  const MethodEntry& entry = *planned_case.choice.entry;
  Record record;
  record.case_id = planned_case.id;
  record.settings = planned_case.choice.settings;
  record.key = key_of(scene, planned_case);
  record.scene = scene.problem.name;
  record.scene_sha256 = scene.sha256;
  record.family = scene.family;
  record.instance = scene.instance;
  record.method = entry.name;
  record.plugin = entry.plugin;
  const std::vector<OptionEcho> options = planned_case.choice.options();
  for (const OptionEcho& option : options) record.options.emplace_back(option.name, option.value);
  record.same_equations_as = same_equations_as(entry, options);
  record.scene_law = as_represented(scene.problem.law());
  record.coordinates = scene.problem.size();
  record.contacts = scene.problem.contact_count();
  record.law = job.method.law;
  if (record.law) {
    record.law_matches_scene = law_matches(*record.law, scene.problem.law());
    record.problem = problem_digest(scene.problem, *record.law);
  }
  record.certificate.reason = "there is no answer to certify";
  if (planned_case.response) {
    record.response.emplace().question = *planned_case.response;
    record.certificate.reason = "a response is measured against the exact one";
  }
  return record;
}

StartPoint Runner::start_of(const Scene& scene, const Job& job, const SolveExtras& extras) const {
  if (extras.start) return {.motion = extras.start};
  if (!job.method.law) return {};
  return start_point(*job.planned_case, scene.problem, references_.under(*job.method.law, scene.problem));
}

std::optional<Record> Runner::without_run(const Scene& scene, const Job& job, const StartPoint& start) const {
  if (job.method.applies && start.obstacle.empty()) return std::nullopt;
  Record record = blank(scene, job);
  if (job.method.failure) {
    take_failure(*job.method.failure, record);
    return record;
  }
  record.status = Status::not_applicable;
  record.message = job.method.applies ? start.obstacle : job.method.reason;
  return record;
}

Trial Runner::trial_of(const Scene& scene, const Job& job, const StartPoint& start,
                       const SolveExtras& extras) const {
  return {.scene = scene,
          .planned_case = *job.planned_case,
          .limits = limits_,
          .law = *job.method.law,
          .reference = references_.under(*job.method.law, scene.problem),
          .scene_reference = references_.under(Undetermined{}, scene.problem),
          .orbits = orbits_,
          .start = start.motion,
          .waveforms = waveforms_,
          .extras = extras};
}

void Runner::run_first(const Scene& scene, std::span<const Job> jobs, int parallel, const TakeRecord& take,
                       const SolveExtras& extras) {
  std::vector<std::size_t> indices;
  std::vector<IsolatedWork> work;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Job& job = jobs[i];
    if (job.method.failure && job.method.failure->kind == ChildEnd::Kind::interrupted) continue;
    const StartPoint start = start_of(scene, job, extras);
    if (const std::optional<Record> record = without_run(scene, job, start)) {
      take(i, *record);
      continue;
    }
    indices.push_back(i);
    work.push_back([this, &scene, &job, &extras, start](const LineSender& send) {
      const Record record = blank(scene, job);
      FirstRoundSender send_stage(send, record);
      if (!job.task) return run_trial(trial_of(scene, job, start, extras), record, std::ref(send_stage));
      job.task->run(record, std::ref(send_stage));
      send_stage.fill();
    });
  }
  std::vector<ReceivedRound> rounds(work.size());
  const OnLine take_line = [&](std::size_t k, std::string line) {
    rounds[k].push_back(std::move(line));
    if (extras.on_answer && rounds[k].size() == 1)
      extras.on_answer(record_of_answer(blank(scene, jobs[indices[k]]), rounds[k].front()));
  };
  const OnEnd take_end = [&](std::size_t k, const ChildEnd& end) {
    if (end.kind == ChildEnd::Kind::interrupted) return;
    const Job& job = jobs[indices[k]];
    Record record = received_first_round(blank(scene, job), rounds[k], end);
    rounds[k] = {};
    references_.keep_confirmed(scene.problem, record);
    if (job.task) job.task->release(record);
    take(indices[k], std::move(record));
  };
  run_isolated_together(work, first_round_limits(limits_, answer_seconds(limits_, jobs)), parallel, take_end,
                        take_line);
}

void Runner::run_later(const Scene& scene, std::span<const Job> jobs, std::span<const Record> records,
                       int parallel, const TakeRecord& take, const SolveExtras& extras) const {
  std::vector<IsolatedWork> work;
  for (const Job& job : jobs) {
    work.push_back([this, &scene, &job, start = start_of(scene, job, extras)](const LineSender& send) {
      // A run that is resumed may find no orbit this time.
      if (!start.obstacle.empty()) return send_later_round({.message = start.obstacle}, send);
      if (job.task) return send_later_round(job.task->repeat(), send);
      send_later_round(repeat_solve(scene, *job.planned_case, limits_, start.motion), send);
    });
  }
  const OnEnd take_end = [&](std::size_t i, const ChildEnd& end) {
    if (end.kind == ChildEnd::Kind::interrupted) return;
    Record record = records[i];
    take_later_round(end, record);
    if (record.seconds)
      record.seconds->unsteady = !rounds_agree(record.seconds->rounds, std::max(2, planned_rounds(record)));
    take(i, std::move(record));
  };
  run_isolated_together(work, later_round_limits(limits_, answer_seconds(limits_, jobs)), parallel, take_end);
}

bool Runner::run_series(const Job& job, SolveSeries& series, const std::function<void(const Record&)>& take,
                        const SolveExtras& extras) {
  if (job.method.failure && job.method.failure->kind == ChildEnd::Kind::interrupted) return false;
  const Record begun = blank(series.scene(), job);  // of all: their scenes are hardly different ones
  bool more = true;
  const auto go_on = [&](const Record& record) {
    if (!more) return;  // a child of the method's that says it all again
    take(record);
    more = series.go_on(record);
  };
  if (const std::optional<Record> record = without_run(series.scene(), job, {})) {
    go_on(*record);
    return more;
  }
  const auto start_now = [&]() -> StartPoint { return {.motion = series.start()}; };
  const std::vector<IsolatedWork> work{[&](const LineSender& send) {
    TrialSeries trials;
    Record record;
    for (;;) {
      FirstRoundSender send_stage(send, begun);
      trials.run(trial_of(series.scene(), job, start_now(), extras), begun, [&](const Record& so_far) {
        send_stage(so_far);
        record = so_far;
      });
      apply_verdict(record);
      // The last round is over when the process is: its clean-up belongs to it, and what the method does to
      // take another frequency.
      if (!series.go_on(record) || !trials.goes_on(series.scene().problem)) return;
      send_stage.fill();
      send(kRoundDone);
    }
  }};
  ReceivedRound round;  // of the solve under way
  const OnLine take_line = [&](std::size_t, std::string line) {
    if (line != kRoundDone) {
      round.push_back(std::move(line));
      return;
    }
    go_on(received_first_round(begun, round, {}));
    round.clear();
  };
  const OnEnd take_end = [&](std::size_t, const ChildEnd& end) {
    if (end.kind != ChildEnd::Kind::interrupted) go_on(received_first_round(begun, round, end));
  };
  run_isolated_together(work, series_limits(limits_), 1, take_end, take_line);
  return more && !interrupted();
}

int Runner::planned_rounds(const Record& record) const {
  if (is_plain(record.settings)) return 1;  // told beside the others, in no ranking
  const TimedRound& first = record.seconds->rounds.front();
  return rounds_for(first.setup + first.solve, {.rounds = limits_.repetitions});
}

int Runner::rounds_missing(const Record& record, int more, int least) const {
  if (!record.seconds || record.seconds->rounds.empty()) return 0;
  return signorini::rounds_missing(record.seconds->rounds, std::max(planned_rounds(record), least), more);
}

std::optional<Record> Runner::run(const Scene& scene, const Job& job, const SolveExtras& extras) {
  std::optional<Record> record;
  const std::array jobs{job};
  const TakeRecord take = [&](std::size_t, Record taken) { record = std::move(taken); };
  run_first(scene, jobs, 1, take, extras);
  while (record && rounds_missing(*record, kMoreRounds) > 0 && !interrupted()) {
    const std::array begun{*record};
    run_later(scene, jobs, begun, 1, take, extras);
  }
  return interrupted() ? std::nullopt : record;
}

std::string problem_digest(const Problem& problem, const RepresentedLaw& law) {
  std::string bytes = fmt::format("{} {:a} {} {}\n", problem.size(), problem.frequency, problem.subharmonic,
                                  json_text(JsonForm<RepresentedLaw>::write(law)));
  const Eigen::VectorXd vector = probe(problem.size());
  std::vector<const SparseMatrix*> matrices{&problem.mass(), &problem.damping(), &problem.stiffness()};
  if (const SpeedTerms* speed = problem.structure->speed.get())
    matrices.insert(matrices.end(), {&speed->gyroscopic, &speed->circulatory});
  for (const SparseMatrix* matrix : matrices) {
    const Eigen::VectorXd product = *matrix * vector;
    bytes.append(reinterpret_cast<const char*>(product.data()),
                 static_cast<std::size_t>(product.size()) * sizeof(double));
  }
  // At this frequency; what moves with the stops enters by its loads.
  for (const ForceTerm& term : problem.force) {
    const double factor = std::pow(problem.frequency, term.omega_power);
    bytes +=
        fmt::format("f {} {} {:a} {:a}\n", term.dof, term.harmonic, factor * term.cos, factor * term.sin);
  }
  for (const Contact& contact : problem.contacts) {
    bytes += fmt::format("g {:a}", contact.gap);
    for (const auto& [dof, coefficient] : contact.normal) bytes += fmt::format(" {} {:a}", dof, coefficient);
    bytes += "\n";
  }
  return short_digest(bytes);
}

}  // namespace signorini
