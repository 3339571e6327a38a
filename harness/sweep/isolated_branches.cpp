#include "harness/sweep/isolated_branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "harness/failure.hpp"
#include "harness/isolation/freed_after.hpp"
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
  constexpr long kKept = 10000;  // ms: longer than a point of the largest structures takes
  const FreedAfter kept(kKept);
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

/// In the parent: a branch that has arrived; one that is none is left out. \return what is wrong with it, for
/// a method may say anything
std::string take_branch(const Json& json, const TakeBranch& take, BranchDiagram& diagram) {
  try {
    diagram.branches.push_back(branch_from_json(json));
  } catch (const BadRecord& error) {
    return fmt::format("invalid branch: {}", error.what());
  }
  if (take) take(diagram.branches.back());
  return {};
}

}  // namespace

IsolatedBranches isolated_branches(const std::string& method, const CurveLimits& limits,
                                   const FollowCurves& follow) {
  IsolatedBranches found;
  std::string refused, bad_branch;
  const auto receive = [&](std::size_t, const std::string& text) {
    const Json json = parse_json(text);
    if (json.contains("points")) {
      const std::string wrong = take_branch(json, limits.take, found.diagram);
      if (!wrong.empty()) bad_branch = wrong;
    } else if (json.contains("refused")) {
      refused = json.at("refused").get<std::string>();
    } else {
      // A method's own words go to the terminal.
      found.diagram.unfinished = as_message(json.at("unfinished").get<std::string>());
      for (const Json& note : json.at("notes"))
        found.diagram.notes.push_back(as_message(note.get<std::string>()));
    }
  };
  ChildEnd last;
  const double seconds = std::clamp(limits.deadline.left(), 0.0, 1e8);  // clocks count that far
  run_isolated_together(
      {[&](const LineSender& send) { send_branches(follow, limits, send); }},
      {.stage_seconds = {enforced(seconds) + kQuickSeconds}, .memory_mb = Limits{}.memory_mb}, 1,
      [&](std::size_t, const ChildEnd& end) { last = end; }, receive);
  if (!refused.empty()) throw UsageError(refused);
  const bool whole = last.kind == ChildEnd::Kind::finished || last.kind == ChildEnd::Kind::interrupted;
  if (whole && bad_branch.empty()) return found;
  found.failure = as_message(fmt::format("{}: {}", method, whole ? bad_branch : describe(last)));
  found.diagram.unfinished = found.failure;
  return found;
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
