#include "harness/conformance/conformance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "harness/conformance/checks.hpp"
#include "harness/conformance/ladder_checks.hpp"
#include "harness/failure.hpp"
#include "harness/glob.hpp"
#include "harness/interrupt.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// Solves that one check may need, to find its limit of wall time.
constexpr double kSolvesPerCheck = 4.0;
constexpr double kSpareSeconds = 10.0;
constexpr double kEndSeconds = 10.0;
constexpr long kMemory = 2048;  // [MiB]

/// One question to the method, asked in a child process.
struct Question {
  CheckFinding finding = {};
  std::function<CheckResult()> ask = {};
};

template <class Check>
CheckFinding finding_of(const Check& check, const std::string& scene) {
  return {.check = std::string(check.name), .promise = std::string(check.promise), .scene = scene};
}

bool is_timeout(const ChildEnd& end) {
  return end.kind == ChildEnd::Kind::timed_out || end.kind == ChildEnd::Kind::out_of_processor_time;
}

/// Asks in one child after another until all questions have their result. A question that ends its child has
/// that as its result; one that outlasts its limit ends the questioning.
void ask_all(std::vector<Question>& questions, double limit) {
  std::size_t next = 0;
  while (next < questions.size() && !interrupted()) {
    const std::vector<double> stages(questions.size() - next, limit);
    IsolationLimits limits{.stage_seconds = stages, .memory_mb = kMemory};
    limits.stage_seconds.push_back(kEndSeconds);
    const ChildEnd end = run_isolated(
        [&](const LineSender& send) {
          for (std::size_t i = next; i < questions.size(); ++i)
            send(to_json(questions[i].ask()).dump(-1, ' ', false, Json::error_handler_t::replace));
        },
        limits);
    if (end.kind == ChildEnd::Kind::interrupted) return;
    for (const std::string& line : end.lines)
      questions[next++].finding.result = result_from_json(Json::parse(line));
    if (end.kind == ChildEnd::Kind::finished) continue;
    const std::size_t culprit = next < questions.size() ? next++ : next - 1;
    questions[culprit].finding.result = failed(describe(end));
    if (!is_timeout(end)) continue;
    for (; next < questions.size(); ++next)
      questions[next].finding.result =
          not_applicable("not asked: " + questions[culprit].finding.check + " did not end");
  }
  questions.resize(std::min(next, questions.size()));
}

/// The checks of one method, as the quest asks for them.
class Examination {
 public:
  Examination(const MethodEntry& entry, const ConformanceQuest& quest, const ConformanceNews& news)
      : entry_(entry), quest_(quest), news_(news) {}

  std::vector<CheckFinding> run() {
    std::vector<Question> own;
    for (const MethodCheck& check : method_checks()) {
      if (wanted(check.name))
        own.push_back({finding_of(check, ""), [this, &check] { return check.examine(entry_); }});
    }
    take(std::move(own), "");
    for (const Scene& scene : quest_.scenes) {
      if (interrupted()) break;
      take(questions_on(scene), scene.problem.name);
      take_ladder(scene);
    }
    return in_order_of_checks();
  }

 private:
  [[nodiscard]] bool wanted(std::string_view check) const {
    return filter_matches(quest_.checks, std::string(check));
  }

  void take(std::vector<Question> questions, const std::string& scene) {
    if (questions.empty()) return;
    if (news_) news_(fmt::format("{}{}{}", entry_.name, scene.empty() ? "" : " on ", scene));
    ask_all(questions, kSolvesPerCheck * quest_.timeout + kSpareSeconds);
    for (Question& question : questions) findings_.push_back(std::move(question.finding));
  }

  [[nodiscard]] std::vector<Question> questions_on(const Scene& scene) const {
    // One subject per child, made where it is first needed: its making is the method's doing too.
    const auto subject = std::make_shared<std::unique_ptr<Subject>>();
    std::vector<Question> questions;
    for (const SceneCheck& check : scene_checks()) {
      if (!wanted(check.name)) continue;
      questions.push_back({finding_of(check, scene.problem.name), [this, &scene, &check, subject] {
                             if (!*subject) {
                               Terms terms = terms_of(entry_);
                               terms.timeout = quest_.timeout;
                               *subject = std::make_unique<Subject>(entry_, scene.problem, terms);
                             }
                             return check.examine(**subject);
                           }});
    }
    return questions;
  }

  void take_ladder(const Scene& scene) {
    std::vector<const LadderCheck*> checks;
    for (const LadderCheck& check : ladder_checks()) {
      if (wanted(check.name)) checks.push_back(&check);
    }
    if (checks.empty()) return;
    if (news_) news_(fmt::format("{} on {}: its ladder", entry_.name, scene.problem.name));
    const std::optional<LadderRecords> ladder = run_ladder(scene);
    if (!ladder) return;
    for (const LadderCheck* check : checks) {
      findings_.push_back(finding_of(*check, scene.problem.name));
      findings_.back().result = check->examine(*ladder);
    }
  }

  /// Whether the steps of its ladder can be made without harm to this process, as check_declaration tells.
  [[nodiscard]] bool can_be_made() const {
    const auto make = [this](const LineSender&) {
      for (const Settings& settings : usable_ladder(entry_)) (void)entry_.make(settings)->options();
    };
    return run_isolated(make, {.stage_seconds = {kEndSeconds}, .memory_mb = kMemory}).kind ==
           ChildEnd::Kind::finished;
  }

  /// Empty after an interrupt.
  [[nodiscard]] std::optional<LadderRecords> run_ladder(const Scene& scene) const {
    LadderRecords ladder{.entry = entry_, .ladder = {}, .records = {}};
    if (!can_be_made()) return ladder;
    ladder.ladder = usable_ladder(entry_);
    std::vector<Case> cases;
    for (const Settings& settings : ladder.ladder) cases.push_back(make_case(scene, 0, {&entry_, settings}));
    Runner runner(Limits{.timeout = quest_.timeout, .memory_mb = kMemory, .repetitions = 1});
    for (const Job& job : runner.make_jobs(scene, cases)) {
      const auto record = runner.run(scene, job, {.timed = false});
      if (!record) return std::nullopt;
      ladder.records.push_back(*record);
    }
    if (ladder.records.size() < ladder.ladder.size()) return std::nullopt;
    return ladder;
  }

  [[nodiscard]] std::vector<CheckFinding> in_order_of_checks() const {
    std::vector<CheckFinding> ordered;
    for (const std::string& name : check_names()) {
      std::copy_if(findings_.begin(), findings_.end(), std::back_inserter(ordered),
                   [&](const CheckFinding& finding) { return finding.check == name; });
    }
    return ordered;
  }

  const MethodEntry& entry_;
  const ConformanceQuest& quest_;
  const ConformanceNews& news_;
  std::vector<CheckFinding> findings_ = {};
};

}  // namespace

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const MethodCheck& check : method_checks()) names.emplace_back(check.name);
  for (const SceneCheck& check : scene_checks()) names.emplace_back(check.name);
  for (const LadderCheck& check : ladder_checks()) names.emplace_back(check.name);
  return names;
}

std::vector<CheckFinding> check_method(const MethodEntry& entry, const ConformanceQuest& quest,
                                       const ConformanceNews& news) {
  const std::vector<std::string> names = check_names();
  if (std::none_of(names.begin(), names.end(),
                   [&](const std::string& name) { return filter_matches(quest.checks, name); }))
    throw NothingMatched(
        fmt::format("checks = {} (matches none of {})", quest.checks, fmt::join(names, ", ")));
  return Examination(entry, quest, news).run();
}

bool any_failed(const std::vector<CheckFinding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const CheckFinding& finding) {
    return finding.result.outcome == CheckOutcome::failed;
  });
}

}  // namespace signorini
