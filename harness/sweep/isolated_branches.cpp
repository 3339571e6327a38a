#include "harness/sweep/isolated_branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>
#include <vector>

#include "harness/failure.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_check.hpp"
#include "harness/run/applicability.hpp"
#include "harness/sweep/branch_json.hpp"
#include "harness/text/json.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// In the child: a line for each branch, then one with what else there is of the diagram, or with why the
/// method cannot be asked.
void send_branches(const FollowCurves& follow, CurveLimits limits, const LineSender& send) {
  std::size_t sent = 0;
  limits.take = [&](const Branch& branch) {
    send(json_line(to_json(branch, "")));
    ++sent;
  };
  const auto refuse = [&](const std::exception& error) { send(json_line(Json{{"refused", error.what()}})); };
  try {
    const BranchDiagram diagram = follow(limits);
    while (sent < diagram.branches.size()) limits.take(diagram.branches[sent]);  // of a method that does not
    send(json_line(Json{{"unfinished", diagram.unfinished}, {"notes", diagram.notes}}));
  } catch (const UsageError& error) {
    refuse(error);
  } catch (const SceneError& error) {
    refuse(error);
  }
}

/// In the parent: what has arrived.
class Received {
 public:
  explicit Received(const TakeBranch& take) : take_(take) {}

  void line(const std::string& text) {
    const Json json = parse_json(text);
    if (json.contains("points")) {
      take_branch(json);
    } else if (json.contains("refused")) {
      refused_ = json.at("refused").get<std::string>();
    } else {
      // A method's own words go to the terminal.
      diagram_.unfinished = as_message(json.at("unfinished").get<std::string>());
      for (const Json& note : json.at("notes")) diagram_.notes.push_back(as_message(note.get<std::string>()));
    }
  }

  /// \throws UsageError
  IsolatedBranches all(const std::string& method, const ChildEnd& end) {
    if (!refused_.empty()) throw UsageError(refused_);
    IsolatedBranches result{.diagram = std::move(diagram_)};
    const bool whole = end.kind == ChildEnd::Kind::finished || end.kind == ChildEnd::Kind::interrupted;
    if (whole && bad_branch_.empty()) return result;
    result.failure = as_message(fmt::format("{}: {}", method, whole ? bad_branch_ : describe(end)));
    result.diagram.unfinished = result.failure;
    return result;
  }

 private:
  /// One that is none is left out: a method may say anything.
  void take_branch(const Json& json) {
    try {
      diagram_.branches.push_back(branch_from_json(json));
    } catch (const BadRecord& error) {
      bad_branch_ = fmt::format("invalid branch: {}", error.what());
      return;
    }
    if (take_) take_(diagram_.branches.back());
  }

  const TakeBranch& take_;
  BranchDiagram diagram_;
  std::string refused_, bad_branch_;
};

}  // namespace

IsolatedBranches isolated_branches(const std::string& method, const CurveLimits& limits,
                                   const FollowCurves& follow) {
  constexpr double kForever = 1e8;  // [s]: clocks count that far
  Received received(limits.take);
  ChildEnd last;
  run_isolated_together(
      {[&](const LineSender& send) { send_branches(follow, limits, send); }},
      {.stage_seconds = {enforced(std::clamp(limits.deadline.left(), 0.0, kForever)) + kQuickSeconds},
       .memory_mb = Limits{}.memory_mb},
      1, [&](std::size_t, const ChildEnd& end) { last = end; },
      [&](std::size_t, const std::string& line) { received.line(line); });
  return received.all(method, last);
}

std::optional<IsolatedBranches> isolated_branches(
    const ParametrisedScene& scene, const MethodChoice& method, const CurveLimits& limits,
    const std::function<std::vector<KnownMotion>()>& beginnings) {
  if (!has_curve(method)) return std::nullopt;
  return isolated_branches(method.label(), limits, [&](const CurveLimits& given) {
    CurveLimits asked = given;
    if (beginnings) std::ranges::move(beginnings(), std::back_inserter(asked.begin_at));
    return branches_of(scene, method, asked).value();
  });
}

std::string law_remark_of(const Scene& scene, const MethodChoice& method) {
  const Case asked{.choice = method};
  const Case* const list = &asked;
  Record record;
  record.scene_law = as_represented(scene.problem.law());
  for (const Applicability& answer : ask_applicability(scene, std::span(&list, 1), Limits{}.memory_mb)) {
    record.law = answer.law;
    if (record.law) record.law_matches_scene = law_matches(*record.law, scene.problem.law());
  }
  return law_remark(record);
}

}  // namespace signorini
