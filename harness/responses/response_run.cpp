#include "harness/responses/response_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <utility>

#include "harness/build_info.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/progress.hpp"
#include "harness/records/record_check.hpp"
#include "harness/run/applicability.hpp"
#include "harness/run/round_messages.hpp"
#include "harness/sweep/branch_response.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// Frequencies of a sweep by steps, one way.
constexpr int kSteps = 61;

std::vector<MethodChoice> prescribed(const std::vector<std::string>& filters,
                                     std::span<const MethodEntry> catalogue) {
  std::vector<MethodChoice> choices;
  for (const std::string& filter : filters)
    std::ranges::move(select_methods(filter, catalogue), std::back_inserter(choices));
  return choices;
}

/// The suite's own choice of methods, or what a filter makes of it.
std::vector<MethodChoice> chosen(const std::vector<std::string>& filters,
                                 const std::optional<std::string>& filter,
                                 std::span<const MethodEntry> catalogue) {
  const std::vector<MethodChoice> listed = prescribed(filters, catalogue);
  return filter ? select_methods(*filter, catalogue, listed) : listed;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

SweepRange range_of(const SuiteResponse& response) {
  return {.from = response.from, .to = response.to, .points = kSteps, .back = true};
}

ResponseRecord blank(const SuiteResponse& response, const Scene& scene) {
  return {.scene = scene.problem.name,
          .from = response.from,
          .to = response.to,
          .orders = response.orders,
          .scene_law = as_represented(scene.problem.law),
          .coordinates = scene.problem.size(),
          .contacts = scene.problem.contact_count()};
}

/// The law that the method represents, if it applies.
void take_law(const Scene& scene, const MethodChoice& method, int memory_mb, ResponseRecord& record) {
  const Case asked{.choice = method};
  const Case* const list = &asked;
  for (const Applicability& answer : ask_applicability(scene, std::span(&list, 1), memory_mb)) {
    record.law = answer.law;
    if (record.law) record.law_matches_scene = law_matches(*record.law, scene.problem.law);
  }
}

/// A scene with its exact response, and what the cases of one response share.
struct ResponseScene {
  const SuiteResponse& response;
  Scene scene;
  Limits limits;
  std::string identity;  // of all that the exact response depends on
  ResponseCurve exact = {};
  ResponseRecord exact_record = {};

  [[nodiscard]] ParametrisedScene varied() const {
    return over_frequency(scene.problem, response.from, response.to);
  }
  [[nodiscard]] CurveLimits branch_limits(double timeout) const {
    return {.max_order = response.orders, .deadline = deadline_after(timeout)};
  }

  /// Orbits that it finds in steps of the frequency on none of the branches: those of isolated
  /// ones, and beyond ends at which a branch could not be followed.
  void add_orbits_beside() {
    constexpr double kShareOfSolve = 0.1;  // of the time limit
    const SweepRange range = range_of(response);
    const MethodChoice method{.entry = &exact_method()};
    const ResponseCurve steps =
        curve_of(frequency_response(scene, method, range,
                                    {.timeout = kShareOfSolve * limits.reference_timeout,
                                     .deadline = deadline_after(limits.reference_timeout)}));
    const double window = std::abs(range.to - range.from);
    const double amplitude = std::max(amplitude_of(exact), amplitude_of(steps));
    if (!(amplitude > 0.0)) return;
    const std::vector<ResponseBranch> beside =
        beside_branches(exact, steps, ResponseMetric(window, amplitude), window);
    std::size_t orbits = 0;
    for (const ResponseBranch& branch : beside) orbits += branch.points.size();
    if (orbits > 0)
      exact.open_ends.push_back(fmt::format("{} orbits in steps of the frequency lie on no branch", orbits));
    exact.branches.insert(exact.branches.end(), beside.begin(), beside.end());
  }

  void follow_exactly() {
    constexpr double kFineStep = 1.0 / 3.0;  // of the usual
    CurveLimits fine = branch_limits(limits.reference_timeout);
    fine.phases = kComparedPhases;
    fine.step_share = kFineStep;
    try {
      exact = curve_of(exact_branches(varied(), fine));
      add_orbits_beside();
      exact_record.status = exact.branches.empty() ? Status::not_converged : Status::converged;
    } catch (const std::runtime_error& error) {
      exact_record.status = Status::not_applicable;
      exact_record.message = as_message(error.what());
    }
    for (const ResponseBranch& branch : exact.branches)
      exact_record.points += static_cast<int>(branch.points.size());
    exact_record.branches = drawn(exact);
    exact_record.located = exact.located;
    for (const std::string& end : exact.open_ends) exact_record.open_ends.push_back(as_message(end));
  }
};

/// The response with what it is worth against the exact one.
ResponseRecord judged_response(const ResponseCurve& exact, const ResponseCurve& curve,
                               const SweepRange& range, ResponseRecord record) {
  for (const ResponseBranch& branch : curve.branches) record.points += static_cast<int>(branch.points.size());
  record.status = record.points > 0 ? Status::converged : Status::not_converged;
  for (const std::string& end : curve.open_ends) record.open_ends.push_back(as_message(end));
  record.located = curve.located;
  record.branches = drawn(curve);
  const double window = std::abs(range.to - range.from), amplitude = amplitude_of(exact);
  if (amplitude > 0.0)
    record.comparison = compare_curves(exact, curve, ResponseMetric(window, amplitude), window);
  else
    record.message = "nothing to compare with: the exact response has no branch, or the scene no contact";
  return record;
}

/// Follows a curve for its time, then once more for its motions.
ResponseRecord follow(const ResponseScene& at, const MethodChoice& method, ResponseRecord record) {
  constexpr double kTimed = 0.3;  // s: shorter curves are followed again
  constexpr int kMost = 5;
  double all = 0.0;
  for (int round = 0; round < kMost && (round == 0 || all < kTimed); ++round) {
    const double begin = processor_seconds();
    static_cast<void>(branches_of(at.varied(), method, at.branch_limits(at.limits.timeout)));
    const double seconds = processor_seconds() - begin;
    all += seconds;
    record.seconds = std::min(record.seconds.value_or(seconds), seconds);
  }
  CurveLimits limits = at.branch_limits(at.limits.timeout);
  limits.phases = kComparedPhases;
  const BranchDiagram diagram = branches_of(at.varied(), method, limits).value();
  return judged_response(at.exact, curve_of(diagram), range_of(at.response), std::move(record));
}

ResponseRecord follow_isolated(const ResponseScene& at, const MethodChoice& method, ResponseRecord record) {
  const double limit = 2.0 * enforced(at.limits.timeout) + kQuickSeconds;
  const ChildEnd end = run_isolated(
      [&](const LineSender& send) {
        try {
          send(response_line(follow(at, method, record)));
        } catch (const UsageError& error) {  // the method does not apply
          record.status = Status::not_applicable;
          record.message = as_message(error.what());
          send(response_line(record));
        }
      },
      {.stage_seconds = {limit, kQuickSeconds}, .memory_mb = at.limits.memory_mb});
  if (!end.lines.empty()) return response_from_line(end.lines.front());
  Record failed;
  take_failure(end, failed);
  record.status = failed.status;
  record.message = failed.message;
  return record;
}

ResponseRecord step(const ResponseScene& at, const MethodChoice& method, ResponseRecord record) {
  constexpr double kShareOfSolve = 0.1;  // of the time limit
  const SweepRange range = range_of(at.response);
  const std::vector<SweepPoint> points = frequency_response(
      at.scene, method, range,
      {.timeout = kShareOfSolve * at.limits.timeout, .deadline = deadline_after(at.limits.timeout)});
  double seconds = 0.0;
  std::size_t failed = 0;
  for (const SweepPoint& point : points) {
    seconds += point.seconds.value_or(0.0);
    if (point.status == Status::not_applicable) {
      record.status = point.status;
      record.message = point.message;
      return record;
    }
    if (point.status != Status::converged) ++failed;
  }
  record.seconds = seconds;
  ResponseCurve curve = curve_of(points);
  if (failed > 0) curve.open_ends.push_back(fmt::format("{} of {} solves failed", failed, points.size()));
  if (points.size() < 2 * sweep_frequencies(range).size()) curve.open_ends.emplace_back("the time is up");
  return judged_response(at.exact, curve, range, std::move(record));
}

std::string key_of(const ResponseScene& at, const ResponseCase& one) {
  std::string text = at.identity + one.method.label() + (one.by_steps ? " by steps\n" : "\n");
  return sha256(text + code_version(one.method.entry->name) + one.method.entry->plugin);
}

ResponseScene scene_of(const SuiteResponse& response, const Limits& limits) {
  Scene scene = read_scene(find_scene(response.scene));
  std::string identity = fmt::format("{}\n{} {} {}\n{} {}\n", scene.sha256, response.from, response.to,
                                     response.orders, limits.timeout, limits.reference_timeout);
  ResponseScene at{.response = response, .scene = std::move(scene), .limits = limits, .identity = identity};
  at.exact_record = blank(response, at.scene);
  at.exact_record.case_id = at.scene.problem.name + "/";
  at.exact_record.key = sha256(identity + code_version(exact_method().name));
  return at;
}

/// The records of a folder by their keys.
class ResponseStore {
 public:
  ResponseStore(std::filesystem::path folder, bool resume) : folder_(std::move(folder)) {
    if (resume) records_ = read_responses(folder_);
    const std::filesystem::path file = folder_ / kResponsesFile;
    if (!resume && std::filesystem::exists(file))
      std::filesystem::rename(file, folder_ / "responses.previous.jsonl");
  }
  [[nodiscard]] bool contains(const std::string& key) const {
    return std::ranges::any_of(records_, [&](const ResponseRecord& record) { return record.key == key; });
  }
  /// In place of what an earlier version of the case has left.
  void put(ResponseRecord record) {
    std::erase_if(records_, [&](const ResponseRecord& old) { return old.case_id == record.case_id; });
    records_.push_back(std::move(record));
    write_responses(folder_, records_);
  }

 private:
  std::filesystem::path folder_;
  std::vector<ResponseRecord> records_;
};

}  // namespace

std::vector<ResponseCase> response_cases(const Suite& suite, const Narrowing& narrowing,
                                         std::span<const MethodEntry> catalogue) {
  const std::vector<MethodChoice> by_arc_length = chosen(suite.methods, narrowing.methods, catalogue);
  std::vector<MethodChoice> by_steps = prescribed(suite.by_steps, catalogue);
  if (narrowing.methods)
    std::erase_if(by_steps, [&](const MethodChoice& choice) {
      return !filter_matches(*narrowing.methods, choice.entry->name);
    });
  const SceneFilter filter(narrowing.scenes);
  if (!filter.files().empty())
    throw UsageError(fmt::format("scenes = {} (must be names: suite {} says between which frequencies)",
                                 filter.files().front().file.string(), suite.name));
  std::vector<ResponseCase> cases;
  for (std::size_t i = 0; i < suite.responses.size(); ++i) {
    const std::string& scene = suite.responses[i].scene;
    if (!filter.takes(scene)) continue;
    for (const MethodChoice& choice : by_arc_length) {
      const bool steps = !has_curve(choice);
      cases.push_back({i, choice, steps, scene + "/" + choice.label() + (steps ? " by steps" : "")});
    }
    for (const MethodChoice& choice : by_steps)
      cases.push_back({i, choice, true, scene + "/" + choice.label() + " by steps"});
  }
  if (cases.empty())
    throw NothingMatched(fmt::format("scenes = {} (matches no response of suite {})",
                                     narrowing.scenes.empty() ? "*" : joined(narrowing.scenes, " "),
                                     suite.name));
  return cases;
}

ResponseRunResult run_responses(const Suite& suite, std::span<const ResponseCase> cases, const Limits& limits,
                                const std::filesystem::path& folder, bool resume) {
  ResponseStore store(folder, resume);
  ResponseRunResult result;
  Progress progress(cases.size());
  std::optional<ResponseScene> at;  // the response of the cases whose turn it is
  std::size_t current = suite.responses.size();
  bool followed = false;
  for (const ResponseCase& one : cases) {
    if (one.response != current) {
      current = one.response;
      at.emplace(scene_of(suite.responses[current], limits));
      followed = false;
    }
    const std::string key = key_of(*at, one);
    if (store.contains(key)) {
      ++result.present;
      progress.advance();
      continue;
    }
    if (!followed) {
      progress.begin(at->exact_record.scene + ": exact response");
      at->follow_exactly();
      if (interrupted()) break;
      store.put(at->exact_record);
      followed = true;
    }
    progress.begin(one.id);
    ResponseRecord record = blank(at->response, at->scene);
    record.case_id = one.id;
    record.key = key;
    record.method = one.method.label();
    record.by_steps = one.by_steps;
    take_law(at->scene, one.method, limits.memory_mb, record);
    record = one.by_steps ? step(*at, one.method, record) : follow_isolated(*at, one.method, record);
    if (interrupted()) break;
    store.put(std::move(record));
    ++result.ran;
    progress.advance();
  }
  result.interrupted = interrupted();
  return result;
}

}  // namespace signorini
