#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "harness/commands/command_line.hpp"
#include "harness/commands/sweep/sweep_arguments.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/progress.hpp"
#include "harness/sweep/bifurcation_response.hpp"
#include "harness/sweep/isolated_branches.hpp"
#include "harness/text/json.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

// Whether a limit ended a curve, and not the interval or the mathematics.
bool is_cut(const Branch& curve) {
  return curve.ended == "the time is up" || curve.ended.starts_with("limit of ");
}

// What the curves depend on but methods and code.
nlohmann::ordered_json question_of_curves(const SweepArguments& arguments, const Scene& scene) {
  nlohmann::ordered_json question = question_of(arguments, scene);
  question["follow"] = arguments.follow;
  question["second"] = arguments.second.place;
  question["second-from"] = arguments.second.from;
  question["second-to"] = arguments.second.to;
  return question;
}

// What the folder has kept of the curves, or what the method makes of them now.
MethodResponse curves_of(const SweepArguments& arguments, const Scene& scene) {
  const MethodChoice method{&find_method(arguments.methods), parse_settings(arguments.settings)};
  (void)has_curve(method);  // refuses options that are none
  const SweepRange& range = arguments.range;
  std::optional<ResponseFolder> folder = folder_of(arguments, question_of_curves(arguments, scene));
  const auto follow = [&](MethodResponse& response) {
    CurveLimits limits = arguments.branches;
    limits.max_order = arguments.max_order.value_or(limits.max_order);
    limits.deadline = Deadline::after(arguments.total_time);
    if (folder) limits.take = [&](const Branch& curve) { folder->add(response, curve); };
    const Waiting waiting("following curves of " + response.method);
    IsolatedBranches found = isolated_branches(response.method, limits, [&](const CurveLimits& asked) {
      return bifurcation_response(find_scene(arguments.scene), range.from, range.to, arguments.second,
                                  arguments.follow, method, asked);
    });
    response.diagram = std::move(found.diagram);
    response.failure = std::move(found.failure);
  };
  const auto [low, high] = std::minmax(range.from, range.to);
  return kept_or_followed(folder, method,
                          {.method = method.label(), .asked = ParameterRange{.low = low, .high = high}},
                          follow, [](const MethodResponse& /*kept*/) {});
}

void print(const SweepArguments& arguments, const BranchDiagram& curves) {
  const std::string &kind = arguments.follow, &second = arguments.second.place;
  if (arguments.format == "json" || arguments.format == "jsonl")
    fmt::print("{}\n", json_line(bifurcation_json(curves, kind, second)));
  else
    fmt::print("{}", table_text(arguments, bifurcation_table(curves, kind, second)));
  if (!curves.unfinished.empty()) fmt::print(stderr, "{}\n", curves.unfinished);
}

}  // namespace

int sweep_special_points(const SweepArguments& arguments) {
  if (arguments.methods.empty() || arguments.natural || arguments.parameter != kFrequency)
    throw UsageError(fmt::format("follow = {} (must go with --methods, over the frequency by arc length)",
                                 arguments.follow));
  if (arguments.second.place.empty())
    throw UsageError("follow needs --second, --second-from and --second-to");
  if (!arguments.range.at.empty() || arguments.bifurcation)
    throw UsageError("--at and --bifurcation (must be left out with --follow)");
  const Scene scene = read_scene(find_scene(arguments.scene));
  watch_interrupts();
  const MethodResponse response = curves_of(arguments, scene);
  const BranchDiagram& curves = response.diagram;
  print(arguments, curves);
  draw(arguments, {response}, scene.problem.name);
  if (interrupted()) return kInterrupted;
  if (curves.branches.empty() || !response.failure.empty()) return kUnexpectedFailure;
  const auto cut = std::ranges::count_if(curves.branches, is_cut);
  if (cut == 0) return kDone;
  fmt::print(stderr, "INCOMPLETE: {} of {} curves end at a limit (--total-time and --max-points go on)\n",
             cut, curves.branches.size());
  return kIncomplete;
}

}  // namespace signorini
