#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/commands/command_line.hpp"
#include "harness/commands/sweep/sweep_arguments.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/sweep/bifurcation_response.hpp"
#include "harness/text/json.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

// Whether a limit ended a curve, and not the interval or the mathematics.
bool is_cut(const BifurcationCurve& curve) {
  return curve.ended == "the time is up" || curve.ended.starts_with("limit of ");
}

// In a process of its own: what is printed of special points over the frequency and a second number.
void send_special_points(const SweepArguments& arguments, const LineSender& send) {
  using Json = nlohmann::ordered_json;
  const auto refuse = [&](const std::exception& error) { send(json_line(Json{{"refused", error.what()}})); };
  try {
    const MethodChoice method{&find_method(arguments.methods), parse_settings(arguments.settings)};
    CurveLimits limits = arguments.branches;
    limits.max_order = arguments.max_order.value_or(limits.max_order);
    limits.deadline = Deadline::after(arguments.total_time);
    const std::string& second = arguments.second.place;
    const BifurcationCurves response =
        bifurcation_response(find_scene(arguments.scene), arguments.range.from, arguments.range.to,
                             arguments.second, arguments.follow, method, limits);
    const bool json = arguments.format == "json" || arguments.format == "jsonl";
    send(json_line(Json{{"text", json ? json_line(to_json(response, second)) + "\n"
                                      : table_text(arguments, bifurcation_table(response, second))},
                        {"unfinished", response.unfinished},
                        {"curves", response.curves.size()},
                        {"cut", std::ranges::count_if(response.curves, is_cut)}}));
  } catch (const UsageError& error) {
    refuse(error);
  } catch (const SceneError& error) {
    refuse(error);
  }
}

}  // namespace

int sweep_special_points(const SweepArguments& arguments) {
  if (arguments.methods.empty() || arguments.natural || arguments.parameter != kFrequency)
    throw UsageError(fmt::format("follow = {} (must go with --methods, over the frequency by arc length)",
                                 arguments.follow));
  if (arguments.second.place.empty())
    throw UsageError("follow needs --second, --second-from and --second-to");
  if (!arguments.range.at.empty() || !arguments.plot.empty() || arguments.out)
    throw UsageError("--at, --plot and --out (must be left out with --follow)");
  const ChildEnd end = run_isolated([&](const LineSender& send) { send_special_points(arguments, send); },
                                    {.stage_seconds = {4.0 * enforced(arguments.total_time) + kQuickSeconds},
                                     .memory_mb = Limits{}.memory_mb});
  if (end.lines.empty()) {
    fmt::print(stderr, "{}: {}\n", arguments.methods, describe(end));
    return interrupted() ? kInterrupted : kUnexpectedFailure;
  }
  const nlohmann::ordered_json found = parse_json(end.lines.front());
  if (found.contains("refused")) throw UsageError(found.at("refused").get<std::string>());
  fmt::print("{}", found.at("text").get<std::string>());
  if (const auto unfinished = found.at("unfinished").get<std::string>(); !unfinished.empty())
    fmt::print(stderr, "{}\n", unfinished);
  if (found.at("curves") == 0) return kUnexpectedFailure;
  if (found.at("cut") == 0) return kDone;
  fmt::print(stderr, "INCOMPLETE: {} of {} curves end at a limit (--total-time and --max-points go on)\n",
             found.at("cut").get<long>(), found.at("curves").get<long>());
  return kIncomplete;
}

}  // namespace signorini
