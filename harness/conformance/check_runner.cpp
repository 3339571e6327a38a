#include "harness/conformance/check_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "harness/conformance/checked_method.hpp"
#include "harness/conformance/resolution_series.hpp"
#include "harness/failure.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/run/runner.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// A check may take so many times the limit of a solve, and kQuickSeconds of wall time.
constexpr double kSolvesPerCheck = 4.0;

/// A promise and the function that asks for it. `promise` is a predicate whose subject is the method or its
/// answer.
template <class Subject>
struct Check {
  std::string_view name;
  std::string_view promise;
  CheckResult (*examine)(const Subject& subject);
};

/// Of the method alone, in the order of a review.
constexpr std::array<Check<MethodEntry>, 3> kMethodChecks{{
    {"declaration", "declares its name, laws, ladder and options", check_declaration},
    {"echo", "echoes its options as they were set", check_echo},
    {"refusals", "refuses bad options in one line", check_refusals},
}};

/// Of the method on a scene.
constexpr std::array<Check<CheckedMethod>, 12> kSceneChecks{{
    {"applicability", "refuses a scene only with a reason, and declares a law that fits",
     check_applicability},
    {"trajectory", "answers with a sound trajectory", check_trajectory},
    {"determinism", "gives the same bits again", check_determinism},
    {"time-budget", "ends soon after its time is up", check_time_budget},
    {"load-scaling", "scales with load and gap", check_load_scaling},
    {"structure-scaling", "scales its forces with the structure", check_structure_scaling},
    {"time-scaling", "does not depend on the unit of time", check_time_scaling},
    {"numbering", "does not depend on the numbering of coordinates", check_numbering},
    {"time-shift", "comes later with the load", check_time_shift},
    {"origin-shift", "does not depend on where the origin of x is", check_origin_shift},
    {"contact-free", "is the linear response where no stop is in reach", check_contact_free},
    {"curve", "is a point of the curve that it follows", check_curve},
}};

/// Of the records of a ladder on a scene.
constexpr std::array<Check<LadderRecords>, 3> kLadderChecks{{
    {"convergence", "converges at every step of its ladder", check_convergence},
    {"certificate", "claims nothing that the harness refutes", check_certificate},
    {"order", "errs less and less along its ladder, as fast as it declares", check_order},
}};

/// A check that waits to be run in a child process, and its result.
struct PendingCheck {
  CheckResult result = {};
  std::function<CheckResult()> examine = {};
};

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
                         .memory_mb = Limits{}.memory_mb};
  limits.stage_seconds.push_back(kQuickSeconds);
  return run_isolated(
      [&](const LineSender& send) {
        for (std::size_t i = first; i < checks.size(); ++i) send(json_line(to_json(checks[i].examine())));
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
      set_outcome(checks[next++].result, check_result_from_json(parse_json(line)));
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
struct CheckRunner {
  const MethodEntry& entry;
  const CheckOptions& options;
  const CheckProgress& progress;
  std::vector<CheckResult> results = {};

  std::vector<CheckResult> run() {
    run_all(checks_of_method(), "");
    for (const Scene& scene : options.scenes) {
      if (interrupted()) break;
      run_all(checks_on(scene), scene.problem.name);
      check_ladder(scene);
    }
    return in_order_of_checks();
  }

  void run_all(std::vector<PendingCheck> checks, const std::string& scene) {
    if (checks.empty()) return;
    if (progress) progress(fmt::format("{}{}{}", entry.name, scene.empty() ? "" : " on ", scene));
    run_checks(checks, kSolvesPerCheck * options.timeout + kQuickSeconds);
    for (PendingCheck& check : checks) results.push_back(std::move(check.result));
  }

  /// Those of the checks that are asked for, of what `subject` gives once they are run.
  template <std::size_t N, class Subject>
  [[nodiscard]] std::vector<PendingCheck> pending(const std::array<Check<Subject>, N>& checks,
                                                  const std::string& scene,
                                                  const std::function<const Subject&()>& subject) const {
    std::vector<PendingCheck> wanted;
    for (const auto& check : checks) {
      if (!filter_matches(options.checks, check.name)) continue;
      wanted.push_back(
          {{.check = std::string(check.name), .promise = std::string(check.promise), .scene = scene},
           [&check, subject] { return check.examine(subject()); }});
    }
    return wanted;
  }

  [[nodiscard]] std::vector<PendingCheck> checks_of_method() const {
    return pending(kMethodChecks, "", {[this]() -> const MethodEntry& { return entry; }});
  }

  [[nodiscard]] std::vector<PendingCheck> checks_on(const Scene& scene) const {
    // Each child makes the method when its first check needs it: the method may crash there too.
    const auto checked = std::make_shared<std::unique_ptr<CheckedMethod>>();
    return pending(kSceneChecks, scene.problem.name, {[this, &scene, checked]() -> const CheckedMethod& {
                     if (!*checked) {
                       CheckSettings settings = check_settings_of(entry);
                       settings.timeout = options.timeout;
                       *checked = std::make_unique<CheckedMethod>(entry, scene.problem, settings);
                     }
                     return **checked;
                   }});
  }

  void check_ladder(const Scene& scene) {
    LadderRecords ladder{.entry = entry, .ladder = {}, .records = {}};
    const std::vector<PendingCheck> checks =
        pending(kLadderChecks, scene.problem.name, {[&]() -> const LadderRecords& { return ladder; }});
    if (checks.empty()) return;
    if (progress) progress(fmt::format("{} on {}: its ladder", entry.name, scene.problem.name));
    if (!run_ladder(scene, ladder)) return;
    for (const PendingCheck& check : checks) {
      results.push_back(check.result);
      set_outcome(results.back(), check.examine());
    }
  }

  /// Whether the method can be made at every step of its ladder, tried in a child; check_declaration says why
  /// not.
  [[nodiscard]] bool can_be_made() const {
    const auto make = [this](const LineSender&) {
      for (const Settings& settings : usable_ladder(entry)) (void)entry.make(settings)->options();
    };
    return run_isolated(make, {.stage_seconds = {kQuickSeconds}, .memory_mb = Limits{}.memory_mb}).kind ==
           ChildEnd::Kind::finished;
  }

  /// Takes the records of the ladder, as a run of the benchmark writes them. \return false after an interrupt
  [[nodiscard]] bool run_ladder(const Scene& scene, LadderRecords& ladder) const {
    if (!can_be_made()) return true;
    ladder.ladder = usable_ladder(entry);
    std::vector<Case> cases;
    for (const Settings& settings : ladder.ladder) cases.push_back(make_case(scene, 0, {&entry, settings}));
    Runner runner(Limits{.timeout = options.timeout, .repetitions = 1});
    for (const Job& job : runner.make_jobs(scene, cases)) {
      const auto record = runner.run(scene, job, {.timed = false});
      if (!record) return false;
      ladder.records.push_back(*record);
    }
    return ladder.records.size() == ladder.ladder.size();
  }

  [[nodiscard]] std::vector<CheckResult> in_order_of_checks() const {
    std::vector<CheckResult> ordered;
    for (const std::string& name : check_names()) {
      std::ranges::copy_if(results, std::back_inserter(ordered),
                           [&](const CheckResult& result) { return result.check == name; });
    }
    return ordered;
  }
};

}  // namespace

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const auto& check : kMethodChecks) names.emplace_back(check.name);
  for (const auto& check : kSceneChecks) names.emplace_back(check.name);
  for (const auto& check : kLadderChecks) names.emplace_back(check.name);
  return names;
}

std::vector<CheckResult> check_method(const MethodEntry& entry, const CheckOptions& options,
                                      const CheckProgress& progress) {
  const std::vector<std::string> names = check_names();
  if (std::ranges::none_of(names, [&](const auto& name) { return filter_matches(options.checks, name); }))
    throw NothingMatched("checks = {} (matches none of {})", options.checks, joined(names, ", "));
  return CheckRunner{entry, options, progress}.run();
}

bool any_failed(const std::vector<CheckResult>& results) {
  return std::ranges::any_of(
      results, [](const CheckResult& result) { return result.outcome == CheckOutcome::failed; });
}

}  // namespace signorini
