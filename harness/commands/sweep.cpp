#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/progress.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/sweep/frequency_response.hpp"

namespace signorini {

namespace {

struct SweepArguments {
  std::string scene, method;
  std::vector<std::string> settings;
  SweepRange range;
  SweepLimits limits;
  std::string format = "md";
};

void print(const SweepArguments& arguments, const std::vector<SweepPoint>& points) {
  if (arguments.format == "json") {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SweepPoint& point : points) list.push_back(to_json(point));
    fmt::print("{}\n", json_line(list));
    return;
  }
  const Table table = response_table(points, arguments.limits.certified);
  fmt::print("{}", arguments.format == "csv" ? to_csv(table) : to_markdown(table));
}

int sweep(const SweepArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  const MethodChoice method{&find_method(arguments.method), parse_settings(arguments.settings)};
  const std::size_t ways = arguments.range.back ? 2 : 1;
  (void)make_case(scene, 0, method);  // a bad option is told before anything else
  if (method.start()) throw UsageError("set = start (must be left out: each solve starts from the last)");
  const std::size_t points = sweep_frequencies(arguments.range).size() * ways;
  watch_interrupts();
  std::vector<SweepPoint> found;
  {
    Progress progress(points);
    progress.begin(scene.problem.name);
    found =
        frequency_response(scene, method, arguments.range, arguments.limits, [&](const SweepPoint& point) {
          progress.advance();
          progress.begin(fmt::format("{:.6g} rad/s", point.frequency));
        });
  }
  print(arguments, found);
  if (interrupted()) {
    fmt::print(stderr, "interrupted after {} of {} points\n", found.size(), points);
    return kInterrupted;
  }
  const bool all = std::all_of(found.begin(), found.end(),
                               [](const SweepPoint& point) { return point.status == Status::converged; });
  return all ? kDone : kUnexpectedFailure;
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("sweep",
                                     "Frequency response: one method on one scene at one frequency after "
                                     "another, each solve from the answer before. "
                                     "Exit code 1 if one did not converge.");
  const auto arguments = std::make_shared<SweepArguments>();
  command->add_option("scene", arguments->scene, "a scene of the catalogue, or a scene file")->required();
  command->add_option("--method", arguments->method, "method name; see `signorini list methods`")->required();
  command->add_option("--set", arguments->settings, "key=value: an option of the method; may be repeated")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--from", arguments->range.from, "first frequency of the load [rad/s]")->required();
  command->add_option("--to", arguments->range.to, "last one, above or below [rad/s]")->required();
  command->add_option("--points", arguments->range.points, "frequencies, both ends included")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  command->add_flag("--log", arguments->range.logarithmic, "equal ratios instead of equal steps");
  command->add_flag("--down,--back", arguments->range.back,
                    "and back again from the last answer: where the ways differ, several motions coexist");
  command->add_flag("--certify", arguments->limits.certified,
                    "look for the orbit behind each answer: whether there is one, and whether it is stable");
  command->add_option("--timeout", arguments->limits.timeout, "wall time of one solve [s]")
      ->check(positive_seconds)
      ->capture_default_str();
  command->add_option("--format", arguments->format, "md, csv or json")
      ->check(CLI::IsMember({"md", "csv", "json"}))
      ->capture_default_str();
  command->callback([arguments, &exit_code] { exit_code = sweep(*arguments); });
}

}  // namespace signorini
