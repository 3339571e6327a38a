#include "harness/run/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/interrupt.hpp"
#include "harness/judge/certificate.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/run/timing.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// Processes that compute references at the same time: nothing is being timed then.
constexpr int kReferenceProcesses = 2;
/// A method that obeys its deadline ends by itself; this much later it is ended.
constexpr double kLateness = 1.05;
constexpr double kLatenessSeconds = 0.2;
/// Applicability and law, the end: quick unless something hangs [s].
constexpr double kQuickSeconds = 10.0;

double late(double seconds) { return seconds * kLateness + kLatenessSeconds; }

/// How many periods of a motion make the one that a scene asks for; 0 if no whole number does.
int whole_periods(const Problem& problem, const Trajectory& motion) {
  constexpr double kSamePeriod = 1e-6;  // as of an answer's period
  const double ratio = problem.period() / motion.period();
  const double whole = std::round(ratio);
  return whole >= 1.0 && std::abs(ratio - whole) <= kSamePeriod * ratio ? static_cast<int>(whole) : 0;
}

/// One line; text that is not UTF-8 is repaired rather than refused.
std::string as_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string law_key(const Problem& problem, const RepresentedLaw& law) {
  return std::holds_alternative<Undetermined>(law) ? law_to_json(as_represented(problem.law)).dump()
                                                   : law_to_json(law).dump();
}

Survey read_survey(const std::string& line) {
  const Json json = Json::parse(line);
  Survey survey;
  survey.ok = json.at("ok");
  survey.reason = json.at("reason");
  if (json.contains("law")) survey.law = law_from_json(json["law"]);
  return survey;
}

void send_survey(const Scene& scene, const Case& run, const LineSender& send) {
  const std::unique_ptr<Method> method = run.choice.make();
  const Support support = method->supports(scene.problem);
  Json json{{"ok", support.ok}, {"reason", support.reason}};
  if (support.ok) json["law"] = law_to_json(method->law(scene.problem));
  send(as_line(json));
}

Reference take_reference(const ChildEnd& end) {
  Reference reference;
  if (end.lines.empty()) {
    reference.reason = "its computation ended by " + describe(end);
    return reference;
  }
  try {
    return reference_from_json(Json::parse(end.lines.back()));
  } catch (const std::exception& error) {
    reference.reason = fmt::format("its computation left {}", error.what());
    return reference;
  }
}

constexpr const char* kRepeated = "in a repeated solve: ";

std::string repeat_line(const RepeatedSolve& repeat) {
  if (!repeat.times) return as_line({{"message", repeat.message}});
  return as_line({{"setup", repeat.times->setup}, {"solve", repeat.times->solve}, {"answer", repeat.answer}});
}

/// A child that died after the answer was in: while it was timed or cleaned up that is the method's doing,
/// between the two the harness's.
void take_late_end(const ChildEnd& end, Record& record) {
  if (end.kind == ChildEnd::Kind::finished) return;
  const auto last = static_cast<TrialStage>(end.lines.size() - 1);
  if (last == TrialStage::solved || last == TrialStage::certified) {
    take_failure(end, record);
    record.message = (last == TrialStage::solved ? kRepeated : "in its clean-up: ") + record.message;
    return;
  }
  record.certificate.status = CertificateStatus::uncertified;
  record.certificate.reason = "the harness's own check ended by " + describe(end);
}

}  // namespace

void take_failure(const ChildEnd& end, Record& record) {
  record.message = describe(end);
  switch (end.kind) {
    case ChildEnd::Kind::threw:
      record.status = Status::exception;
      record.message = end.detail;
      break;
    case ChildEnd::Kind::out_of_memory:
      record.status = Status::out_of_memory;
      break;
    case ChildEnd::Kind::timed_out:
    case ChildEnd::Kind::out_of_processor_time:
      record.status = Status::timeout;
      break;
    case ChildEnd::Kind::signalled:
      record.signal = end.code;
      record.status = Status::crashed;
      break;
    case ChildEnd::Kind::exited:
    case ChildEnd::Kind::finished:
    case ChildEnd::Kind::interrupted:
      record.status = Status::crashed;
      break;
  }
}

void take_round(const ChildEnd& end, Record& record) {
  record.elapsed = record.elapsed.value_or(0.0) + end.seconds;
  const Json json = end.lines.empty() ? Json::object() : Json::parse(end.lines.back());
  if (json.contains("setup")) {
    std::vector<TimedRound> rounds = record.seconds->rounds;
    rounds.push_back({.setup = json.at("setup"), .solve = json.at("solve")});
    record.seconds = summarise(rounds);
    count_repeat(json.at("answer"), record);
    return;
  }
  if (json.contains("message")) {
    record.status = Status::not_converged;
    record.message = json.at("message");
  } else {
    take_failure(end, record);
  }
  record.message = kRepeated + record.message;
  record.seconds.reset();
}

Runner::Runner(Limits limits, OrbitTools orbits, CodeVersion version)
    : limits_(limits), orbits_(std::move(orbits)), code_version_(std::move(version)) {}

std::string Runner::key_of(const Scene& scene, const Case& run) const {
  return case_key(scene, run, limits_, code_version_(run.choice.entry->name));
}

std::vector<Survey> Runner::survey(const Scene& scene, std::span<const Case* const> cases) const {
  std::vector<Survey> surveys;
  while (surveys.size() < cases.size() && !interrupted()) {
    const auto rest = cases.subspan(surveys.size());
    const ChildEnd end = run_isolated(
        [&](const LineSender& send) {
          for (const Case* run : rest) send_survey(scene, *run, send);
        },
        {.stage_seconds = {kQuickSeconds}, .memory_mb = limits_.memory_mb});
    for (const std::string& line : end.lines) surveys.push_back(read_survey(line));
    // The one that ended the child gets its ending; the others are asked again.
    if (end.kind != ChildEnd::Kind::finished && surveys.size() < cases.size()) {
      surveys.push_back({.ok = false, .reason = {}, .law = {}, .failure = end});
    }
  }
  return surveys;
}

void Runner::compute_references(const Scene& scene, std::span<const Survey> surveys) {
  std::vector<std::string> keys;
  std::vector<IsolatedWork> work;
  const auto add = [&](const RepresentedLaw& law) {
    const std::string key = law_key(scene.problem, law);
    if (references_.contains(key) || std::find(keys.begin(), keys.end(), key) != keys.end()) return;
    keys.push_back(key);
    work.push_back([this, &scene, law](const LineSender& send) {
      send(as_line(to_json(compute_reference(under_law(scene.problem, law), orbits_,
                                             deadline_after(limits_.reference_timeout)))));
    });
  };
  const auto runs = [](const Survey& survey) { return survey.ok; };
  if (std::none_of(surveys.begin(), surveys.end(), runs)) return;
  add(as_represented(scene.problem.law));
  for (const Survey& survey : surveys) {
    if (survey.law) add(*survey.law);
  }
  const std::vector<ChildEnd> ends = run_isolated_together(
      work, {.stage_seconds = {late(limits_.reference_timeout)}, .memory_mb = limits_.memory_mb},
      kReferenceProcesses);
  for (std::size_t i = 0; i < keys.size(); ++i) references_[keys[i]] = take_reference(ends[i]);
}

const Reference& Runner::reference_for(const Problem& problem, const RepresentedLaw& law) const {
  static const Reference none{.orbit = {}, .reason = "not computed", .residual = {}, .fingerprint = {}};
  const auto found = references_.find(law_key(problem, law));
  return found == references_.end() ? none : found->second;
}

void Runner::keep_confirmed(const Problem& problem, const Record& record) {
  const auto found = references_.find(law_key(problem, *record.law));
  if (found == references_.end()) return;
  std::vector<Certificate>& confirmed = found->second.confirmed;
  // An orbit that was recognised carries the very distance of the one known.
  const auto recognised = [&](const Certificate& known) {
    return known.return_distance == record.certificate.return_distance;
  };
  if (std::none_of(confirmed.begin(), confirmed.end(), recognised)) confirmed.push_back(record.certificate);
}

IsolationLimits Runner::trial_limits() const {
  // One per stage: first solve, a round of timing, measures, certificate; then the end of the process. On a
  // large structure the measures cost what the set-up did: both find receptances.
  return {.stage_seconds = {late(limits_.timeout), late(limits_.timeout) + kQuickSeconds,
                            late(limits_.timeout) + kQuickSeconds,
                            late(limits_.certificate_timeout) + kQuickSeconds, kQuickSeconds},
          .memory_mb = limits_.memory_mb};
}

Record Runner::blank(const Scene& scene, const Case& run, const Survey& survey) const {
  Record record;
  record.case_id = run.id;
  record.key = key_of(scene, run);
  record.scene = scene.problem.name;
  record.scene_sha256 = scene.sha256;
  record.family = scene.family;
  record.method = run.choice.entry->name;
  record.plugin = run.choice.entry->plugin;
  for (const OptionEcho& option : run.options) record.options.emplace_back(option.name, option.value);
  record.scene_law = as_represented(scene.problem.law);
  record.law = survey.law;
  if (survey.law) record.law_matches_scene = law_matches(*survey.law, scene.problem.law);
  record.certificate.reason = "there is no answer to certify";
  return record;
}

std::optional<Record> Runner::without_run(const Scene& scene, const Job& job) const {
  Record record = blank(scene, *job.run, *job.survey);
  if (job.survey->failure) {
    take_failure(*job.survey->failure, record);
    return record;
  }
  record.status = Status::not_applicable;
  record.message = job.survey->reason;
  if (!job.survey->ok) return record;
  record.message = start_obstacle(scene, job);
  if (record.message.empty()) return std::nullopt;
  return record;
}

std::string Runner::start_obstacle(const Scene& scene, const Job& job) const {
  if (!job.run->choice.start()) return {};
  const Reference& reference = reference_for(scene.problem, *job.survey->law);
  if (!reference.orbit) return "no orbit to start from: " + reference.reason;
  if (whole_periods(scene.problem, *reference.orbit) > 0) return {};
  return fmt::format(
      "no orbit to start from: the one reached from rest has a period of {:.6g} s, asked for is {:.6g} s",
      reference.orbit->period(), scene.problem.period());
}

std::shared_ptr<const Trajectory> Runner::start_of(const Scene& scene, const Job& job,
                                                   const SolveExtras& extras) const {
  const std::optional<double> late = job.run->choice.start();
  if (extras.start || !late) return extras.start;
  const std::shared_ptr<const SampledTrajectory>& orbit =
      reference_for(scene.problem, *job.survey->law).orbit;
  return std::make_shared<SampledTrajectory>(
      repeated(delayed(*orbit, *late), whole_periods(scene.problem, *orbit)));
}

Trial Runner::trial_of(const Scene& scene, const Job& job, const SolveExtras& extras) const {
  return {.scene = scene,
          .run = *job.run,
          .limits = limits_,
          .law = *job.survey->law,
          .reference = reference_for(scene.problem, *job.survey->law),
          .scene_reference = reference_for(scene.problem, Undetermined{}),
          .orbits = orbits_,
          .start = start_of(scene, job, extras),
          .samples = extras.samples,
          .timed = extras.timed,
          .certified = extras.certified,
          .waveforms = waveforms_};
}

void Runner::run_first(const Scene& scene, std::span<const Job> jobs, int parallel, const TakeRecord& take,
                       const SolveExtras& extras) {
  std::vector<std::size_t> places;
  std::vector<IsolatedWork> work;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (jobs[i].survey->failure && jobs[i].survey->failure->kind == ChildEnd::Kind::interrupted) continue;
    if (const std::optional<Record> record = without_run(scene, jobs[i])) {
      take(i, *record);
      continue;
    }
    places.push_back(i);
    work.push_back([this, &scene, &job = jobs[i], &extras](const LineSender& send) {
      run_trial(trial_of(scene, job, extras), blank(scene, *job.run, *job.survey),
                [&](const Record& so_far) { send(as_line(to_json(so_far))); });
    });
  }
  run_isolated_together(work, trial_limits(), parallel, [&](std::size_t k, const ChildEnd& end) {
    if (end.kind == ChildEnd::Kind::interrupted) return;
    const Job& job = jobs[places[k]];
    Record record = blank(scene, *job.run, *job.survey);
    if (end.lines.empty()) {
      take_failure(end, record);
    } else {
      record = record_from_json(Json::parse(end.lines.back()));
      take_late_end(end, record);
      apply_verdict(record);
      if (record.certificate.return_distance) keep_confirmed(scene.problem, record);
    }
    record.elapsed = end.seconds;
    take(places[k], std::move(record));
  });
}

void Runner::run_later(const Scene& scene, std::span<const Job> jobs, std::span<const Record> records,
                       int parallel, const TakeRecord& take, const SolveExtras& extras) const {
  std::vector<IsolatedWork> work;
  for (const Job& job : jobs) {
    work.push_back([this, &scene, &job, &extras](const LineSender& send) {
      // A run that is resumed may find no orbit this time.
      if (const std::string obstacle = start_obstacle(scene, job); !obstacle.empty())
        return send(repeat_line({.times = {}, .message = obstacle}));
      send(repeat_line(repeat_solve(scene, *job.run, limits_, start_of(scene, job, extras))));
    });
  }
  const IsolationLimits limits{.stage_seconds = {2.0 * late(limits_.timeout) + kQuickSeconds, kQuickSeconds},
                               .memory_mb = limits_.memory_mb};
  run_isolated_together(work, limits, parallel, [&](std::size_t i, const ChildEnd& end) {
    if (end.kind == ChildEnd::Kind::interrupted) return;
    Record record = records[i];
    take_round(end, record);
    take(i, std::move(record));
  });
}

int Runner::rounds_missing(const Record& record) const {
  if (!record.seconds || record.seconds->rounds.empty()) return 0;
  const TimedRound& first = record.seconds->rounds.front();
  return rounds_for(first.setup + first.solve, {.rounds = limits_.repetitions}) -
         static_cast<int>(record.seconds->rounds.size());
}

std::optional<Record> Runner::run(const Scene& scene, const Job& job, const SolveExtras& extras) {
  std::optional<Record> record;
  const std::array jobs{job};
  const TakeRecord take = [&](std::size_t, Record taken) { record = std::move(taken); };
  run_first(scene, jobs, 1, take, extras);
  while (record && rounds_missing(*record) > 0 && !interrupted()) {
    const std::array begun{*record};
    run_later(scene, jobs, begun, 1, take, extras);
  }
  return interrupted() ? std::nullopt : record;
}

}  // namespace signorini
