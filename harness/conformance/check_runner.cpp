#include "harness/conformance/check_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "harness/conformance/checks.hpp"
#include "harness/conformance/resolution_series.hpp"
#include "harness/failure.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// A check may take kSolvesPerCheck times the limit of a solve and kSpareSeconds of wall time.
constexpr double kSolvesPerCheck = 4.0;
constexpr double kSpareSeconds = 10.0;
/// For the end of a child after its last check [s].
constexpr double kEndSeconds = 10.0;
constexpr long kMemory = 2048;  // [MiB]

/// A check that waits to be run in a child process, and its result.
struct PendingCheck {
  CheckResult result = {};
  std::function<CheckResult()> examine = {};
};

/// The result of a check before it was run.
template <class Check>
CheckResult result_of(const Check& check, const std::string& scene) {
  return {.check = std::string(check.name), .promise = std::string(check.promise), .scene = scene};
}

void set_outcome(CheckResult& result, CheckResult outcome) {
  result.outcome = outcome.outcome;
  result.why = std::move(outcome.why);
  result.reproduce = std::move(outcome.reproduce);
}

bool is_timeout(const ChildEnd& end) {
  return end.kind == ChildEnd::Kind::timed_out || end.kind == ChildEnd::Kind::out_of_processor_time;
}

/// Runs the checks from `first` on in one child, each within `limit` seconds; each sends one line.
ChildEnd run_in_child(const std::vector<PendingCheck>& checks, std::size_t first, double limit) {
  IsolationLimits limits{.stage_seconds = std::vector<double>(checks.size() - first, limit),
                         .memory_mb = kMemory};
  limits.stage_seconds.push_back(kEndSeconds);
  return run_isolated(
      [&](const LineSender& send) {
        for (std::size_t i = first; i < checks.size(); ++i)
          send(to_json(checks[i].examine()).dump(-1, ' ', false, Json::error_handler_t::replace));
      },
      limits);
}

/// Runs all checks, in a new child after each one that ended its child: how the child ended is then the
/// result of that check. After a check that exceeded its limit the remaining ones are not run. After an
/// interrupt, only those that were run are left.
void run_checks(std::vector<PendingCheck>& checks, double limit) {
  std::size_t next = 0;
  while (next < checks.size() && !interrupted()) {
    const ChildEnd end = run_in_child(checks, next, limit);
    if (end.kind == ChildEnd::Kind::interrupted) return;
    for (const std::string& line : end.lines)
      set_outcome(checks[next++].result, check_result_from_json(Json::parse(line)));
    if (end.kind == ChildEnd::Kind::finished) continue;
    const std::size_t culprit = next < checks.size() ? next++ : next - 1;
    set_outcome(checks[culprit].result, failed(describe(end)));
    if (!is_timeout(end)) continue;
    for (; next < checks.size(); ++next)
      set_outcome(checks[next].result,
                  not_applicable("not asked: " + checks[culprit].result.check + " did not end"));
  }
  checks.resize(std::min(next, checks.size()));
}

/// Runs the checks of one method that the options ask for.
class CheckRunner {
 public:
  CheckRunner(const MethodEntry& entry, const CheckOptions& options, const CheckProgress& progress)
      : entry_(entry), options_(options), progress_(progress) {}

  std::vector<CheckResult> run() {
    run_all(checks_of_method(), "");
    for (const Scene& scene : options_.scenes) {
      if (interrupted()) break;
      run_all(checks_on(scene), scene.problem.name);
      check_ladder(scene);
    }
    return in_order_of_checks();
  }

 private:
  [[nodiscard]] bool wanted(std::string_view check) const {
    return filter_matches(options_.checks, std::string(check));
  }

  void run_all(std::vector<PendingCheck> checks, const std::string& scene) {
    if (checks.empty()) return;
    if (progress_) progress_(fmt::format("{}{}{}", entry_.name, scene.empty() ? "" : " on ", scene));
    run_checks(checks, kSolvesPerCheck * options_.timeout + kSpareSeconds);
    for (PendingCheck& check : checks) results_.push_back(std::move(check.result));
  }

  [[nodiscard]] std::vector<PendingCheck> checks_of_method() const {
    std::vector<PendingCheck> pending;
    for (const MethodCheck& check : method_checks()) {
      if (wanted(check.name))
        pending.push_back({result_of(check, ""), [this, &check] { return check.examine(entry_); }});
    }
    return pending;
  }

  [[nodiscard]] std::vector<PendingCheck> checks_on(const Scene& scene) const {
    // Each child makes the method when its first check needs it: the method may crash there too.
    const auto checked = std::make_shared<std::unique_ptr<CheckedMethod>>();
    std::vector<PendingCheck> pending;
    for (const SceneCheck& check : scene_checks()) {
      if (!wanted(check.name)) continue;
      pending.push_back({result_of(check, scene.problem.name), [this, &scene, &check, checked] {
                           if (!*checked) *checked = make_checked(scene);
                           return check.examine(**checked);
                         }});
    }
    return pending;
  }

  [[nodiscard]] std::unique_ptr<CheckedMethod> make_checked(const Scene& scene) const {
    CheckSettings settings = check_settings_of(entry_);
    settings.timeout = options_.timeout;
    return std::make_unique<CheckedMethod>(entry_, scene.problem, settings);
  }

  void check_ladder(const Scene& scene) {
    std::vector<const LadderCheck*> checks;
    for (const LadderCheck& check : ladder_checks()) {
      if (wanted(check.name)) checks.push_back(&check);
    }
    if (checks.empty()) return;
    if (progress_) progress_(fmt::format("{} on {}: its ladder", entry_.name, scene.problem.name));
    const std::optional<LadderRecords> ladder = run_ladder(scene);
    if (!ladder) return;
    for (const LadderCheck* check : checks) {
      results_.push_back(result_of(*check, scene.problem.name));
      set_outcome(results_.back(), check->examine(*ladder));
    }
  }

  /// Whether the method can be made at every step of its ladder, tried in a child; check_declaration says why
  /// not.
  [[nodiscard]] bool can_be_made() const {
    const auto make = [this](const LineSender&) {
      for (const Settings& settings : usable_ladder(entry_)) (void)entry_.make(settings)->options();
    };
    return run_isolated(make, {.stage_seconds = {kEndSeconds}, .memory_mb = kMemory}).kind ==
           ChildEnd::Kind::finished;
  }

  /// The records of the ladder, as a run of the benchmark writes them. Empty after an interrupt.
  [[nodiscard]] std::optional<LadderRecords> run_ladder(const Scene& scene) const {
    LadderRecords ladder{.entry = entry_, .ladder = {}, .records = {}};
    if (!can_be_made()) return ladder;
    ladder.ladder = usable_ladder(entry_);
    std::vector<Case> cases;
    for (const Settings& settings : ladder.ladder) cases.push_back(make_case(scene, 0, {&entry_, settings}));
    Runner runner(Limits{.timeout = options_.timeout, .memory_mb = kMemory, .repetitions = 1});
    for (const Job& job : runner.make_jobs(scene, cases)) {
      const auto record = runner.run(scene, job, {.timed = false});
      if (!record) return std::nullopt;
      ladder.records.push_back(*record);
    }
    if (ladder.records.size() < ladder.ladder.size()) return std::nullopt;
    return ladder;
  }

  [[nodiscard]] std::vector<CheckResult> in_order_of_checks() const {
    std::vector<CheckResult> ordered;
    for (const std::string& name : check_names()) {
      std::copy_if(results_.begin(), results_.end(), std::back_inserter(ordered),
                   [&](const CheckResult& result) { return result.check == name; });
    }
    return ordered;
  }

  const MethodEntry& entry_;
  const CheckOptions& options_;
  const CheckProgress& progress_;
  std::vector<CheckResult> results_ = {};
};

}  // namespace

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const MethodCheck& check : method_checks()) names.emplace_back(check.name);
  for (const SceneCheck& check : scene_checks()) names.emplace_back(check.name);
  for (const LadderCheck& check : ladder_checks()) names.emplace_back(check.name);
  return names;
}

std::vector<CheckResult> check_method(const MethodEntry& entry, const CheckOptions& options,
                                      const CheckProgress& progress) {
  const std::vector<std::string> names = check_names();
  if (std::none_of(names.begin(), names.end(),
                   [&](const std::string& name) { return filter_matches(options.checks, name); }))
    throw NothingMatched(
        fmt::format("checks = {} (matches none of {})", options.checks, fmt::join(names, ", ")));
  return CheckRunner(entry, options, progress).run();
}

bool any_failed(const std::vector<CheckResult>& results) {
  return std::any_of(results.begin(), results.end(),
                     [](const CheckResult& result) { return result.outcome == CheckOutcome::failed; });
}

}  // namespace signorini
