#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string/split.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/plots/response_plot.hpp"
#include "harness/progress.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/sweep/bifurcation_response.hpp"
#include "harness/sweep/branch_response.hpp"
#include "harness/sweep/frequency_response.hpp"
#include "harness/sweep/response_stream.hpp"

namespace signorini {

namespace {

struct SweepArguments {
  std::string scene, method, methods;
  std::vector<std::string> settings;
  SweepRange range;
  SweepLimits limits;
  BranchLimits branches;
  std::string parameter{kFrequency};
  std::optional<double> from, to;
  bool natural = false;
  std::string follow;
  SecondParameter second;
  std::string format = "md";
  std::string plot;
  Column column = Column::own;
  bool bifurcation = false;
};

void print(const SweepArguments& arguments, const std::vector<SweepPoint>& points) {
  if (arguments.format == "jsonl") return;  // each as it came
  if (arguments.format == "json") {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SweepPoint& point : points) list.push_back(to_json(point));
    fmt::print("{}\n", json_line(list));
    return;
  }
  const Table table = response_table(points, arguments.limits.certified);
  fmt::print("{}", arguments.format == "csv" ? to_csv(table) : to_markdown(table));
}

// Points of one method, each solved from the one before.
std::vector<SweepPoint> steps(const SweepArguments& arguments, const Scene& scene, const MethodChoice& method,
                              const TakePoint& take) {
  (void)make_case(scene, 0, method);  // a bad option is told before anything else
  if (method.start()) throw UsageError("set = start (must be left out: each solve starts from the last)");
  const std::size_t points = sweep_frequencies(arguments.range).size() * (arguments.range.back ? 2 : 1);
  Progress progress(points);
  progress.begin(scene.problem.name);
  auto found =
      frequency_response(scene, method, arguments.range, arguments.limits, [&](const SweepPoint& point) {
        if (take) take(point);
        progress.advance();
        progress.begin(fmt::format("{:.6g} rad/s", point.frequency));
      });
  if (interrupted()) fmt::print(stderr, "interrupted after {} of {} points\n", found.size(), points);
  return found;
}

bool all_converged(const std::vector<SweepPoint>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const SweepPoint& point) { return point.status == Status::converged; });
}

int sweep_steps(const SweepArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  const MethodChoice method{&find_method(arguments.method), parse_settings(arguments.settings)};
  watch_interrupts();
  ResponseStream stream(arguments.format, {});
  const std::vector<SweepPoint> found = steps(arguments, scene, method, [&](const SweepPoint& point) {
    if (arguments.format == "jsonl") stream.step(method.label(), point);
  });
  print(arguments, found);
  if (!arguments.plot.empty())
    write_plot(arguments.plot, response_plot(scene.problem.name, {{.method = method.label(), .steps = found}},
                                             ResponseOrdinate::amplitude, arguments.column));
  if (interrupted()) return kInterrupted;
  return all_converged(found) ? kDone : kUnexpectedFailure;
}

// The scene with the number asked for left free. \throws UsageError
ParametrisedScene parametrised(const SweepArguments& arguments, const Scene& scene) {
  const SweepRange& range = arguments.range;
  if (!range.at.empty() && range.from == range.to && !arguments.natural)
    throw UsageError("--from and --to are required with a single value of --at by arc length");
  if (arguments.parameter == kFrequency) {
    (void)sweep_frequencies(range);  // refuses a range that is none
    return over_frequency(scene.problem, range.from, range.to);
  }
  if (arguments.natural || arguments.methods != kFollowedByArcLength)
    throw UsageError(fmt::format("parameter = {} (must be {}: only {} by arc length follows others)",
                                 arguments.parameter, kFrequency, kFollowedByArcLength));
  return over_place(find_scene(arguments.scene), arguments.parameter, range.from, range.to);
}

// What one method makes of the response, printed as it comes where the format allows.
MethodResponse response_of(const SweepArguments& arguments, const Scene& scene,
                           const ParametrisedScene& varied, const MethodChoice& method,
                           ResponseStream& stream) {
  const std::vector<double>& values = arguments.range.at;
  MethodResponse response{.method = method.label(),
                          .order = scene.problem.subharmonic,
                          .parameter = arguments.parameter,
                          .at_values = !values.empty()};
  BranchLimits limits = arguments.branches;
  limits.at = values;
  if (arguments.bifurcation) limits.phases = 1;
  limits.take = [&](const Branch& branch) {
    stream.branch(response.method, values.empty() ? branch : points_at(branch, values));
  };
  std::optional<BranchDiagram> own;
  if (!arguments.natural) {
    std::optional<Waiting> waiting;  // unless lines come meanwhile
    if (!stream.prints()) waiting.emplace("following branches of " + response.method);
    own = branches_of(varied, method, limits);
  }
  if (!own) {
    response.steps = steps(arguments, scene, method,
                           [&](const SweepPoint& point) { stream.step(response.method, point); });
    return response;
  }
  response.diagram = *std::move(own);
  for (Branch& branch : response.diagram.branches) {
    if (!values.empty()) branch = points_at(branch, values);
  }
  return response;
}

void print(const SweepArguments& arguments, const std::vector<MethodResponse>& responses) {
  if (arguments.format == "json") {
    fmt::print("{}\n", json_line(to_json(responses)));
    return;
  }
  if (arguments.format == "md") fmt::print("{}", to_markdown(branch_table(responses)));
  for (const MethodResponse& response : responses) {
    for (const std::string& note : response.diagram.notes) fmt::print(stderr, "{}\n", note);
    if (!response.diagram.unfinished.empty()) fmt::print(stderr, "{}\n", response.diagram.unfinished);
  }
}

// Branches of several methods, by arc length where a method has a curve of its own.
int sweep_branches(const SweepArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  std::vector<std::string> names;
  boost::algorithm::split(names, arguments.methods, [](char c) { return c == ':'; });
  std::vector<MethodChoice> methods;
  for (const std::string& name : names)
    methods.push_back({&find_method(name), parse_settings(arguments.settings)});
  const ParametrisedScene varied = parametrised(arguments, scene);
  watch_interrupts();
  ResponseStream stream(arguments.format, {.method = {},
                                           .order = scene.problem.subharmonic,
                                           .parameter = arguments.parameter,
                                           .at_values = !arguments.range.at.empty()});
  std::vector<MethodResponse> responses;
  bool all = true;
  for (const MethodChoice& method : methods) {
    responses.push_back(response_of(arguments, scene, varied, method, stream));
    const MethodResponse& response = responses.back();
    all =
        all && (response.steps.empty() ? !response.diagram.branches.empty() : all_converged(response.steps));
    if (interrupted()) break;
  }
  print(arguments, responses);
  if (!arguments.plot.empty()) {
    const auto ordinate =
        arguments.bifurcation ? ResponseOrdinate::once_a_period : ResponseOrdinate::amplitude;
    write_plot(arguments.plot, response_plot(scene.problem.name, responses, ordinate, arguments.column));
  }
  if (interrupted()) return kInterrupted;
  return all ? kDone : kUnexpectedFailure;
}

// Special points over the frequency and a second number.
int sweep_special_points(const SweepArguments& arguments) {
  if (arguments.methods != kFollowedByArcLength || arguments.natural || arguments.parameter != kFrequency)
    throw UsageError(fmt::format("follow = {} (must go with --methods {}, over the frequency by arc length)",
                                 arguments.follow, kFollowedByArcLength));
  if (arguments.second.place.empty())
    throw UsageError("follow needs --second, --second-from and --second-to");
  if (!arguments.range.at.empty() || !arguments.plot.empty())
    throw UsageError("--at and --plot (must be left out with --follow)");
  const BifurcationResponse response =
      bifurcation_response(find_scene(arguments.scene), arguments.range.from, arguments.range.to,
                           arguments.second, arguments.follow, arguments.branches);
  if (arguments.format == "json" || arguments.format == "jsonl") {
    fmt::print("{}\n", json_line(to_json(response)));
  } else {
    const Table table = bifurcation_table(response);
    fmt::print("{}", arguments.format == "csv" ? to_csv(table) : to_markdown(table));
  }
  if (!response.unfinished.empty()) fmt::print(stderr, "{}\n", response.unfinished);
  return response.curves.empty() ? kUnexpectedFailure : kDone;
}

// The interval, which points asked for may span. \throws UsageError
SweepRange interval(const SweepArguments& arguments) {
  SweepRange range = arguments.range;
  if (!range.at.empty()) {
    const auto [least, most] = std::minmax_element(range.at.begin(), range.at.end());
    range.from = arguments.from.value_or(*least);
    range.to = arguments.to.value_or(*most);
    const auto [low, high] = std::minmax(range.from, range.to);
    for (const double value : range.at) {
      if (!(value >= low && value <= high))
        throw UsageError(fmt::format("at = {} (must be between --from and --to)", value));
    }
    return range;
  }
  if (!arguments.from || !arguments.to) throw UsageError("--from and --to are required without --at");
  range.from = *arguments.from;
  range.to = *arguments.to;
  return range;
}

int sweep(SweepArguments arguments) {
  arguments.range = interval(arguments);
  if (arguments.method.empty() == arguments.methods.empty())
    throw UsageError("one of --method and --methods is required");
  if (!arguments.method.empty() && arguments.parameter != kFrequency)
    throw UsageError(
        fmt::format("parameter = {} (must be {} with --method)", arguments.parameter, kFrequency));
  if (arguments.bifurcation && (arguments.methods.empty() || arguments.natural || arguments.plot.empty()))
    throw UsageError("bifurcation (must go with --methods by arc length and --plot)");
  if (!arguments.follow.empty()) return sweep_special_points(arguments);
  return arguments.methods.empty() ? sweep_steps(arguments) : sweep_branches(arguments);
}

/// Options of branches by arc length.
void add_branch_options(CLI::App& command, SweepArguments& arguments) {
  command
      .add_option(
          "--parameter", arguments.parameter,
          "by arc length: the number to follow, by its place in the scene file, such as contact[0].gap")
      ->capture_default_str();
  command
      .add_option("--orders", arguments.branches.max_order, "by arc length: longest period [forcing periods]")
      ->check(CLI::Range(1, 12))
      ->capture_default_str();
  command.add_option("--max-branches", arguments.branches.max_branches, "by arc length: branches in all")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command.add_option("--max-points", arguments.branches.max_points, "by arc length: points of a branch")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  command
      .add_option("--total-time", arguments.branches.timeout, "by arc length: wall time of all branches [s]")
      ->check(positive_seconds)
      ->capture_default_str();
  command.add_flag(
      "--bifurcation", arguments.bifurcation,
      "with --plot, by arc length: a bifurcation diagram, the displacement at t = 0 of every forcing period");
}

void add_special_point_options(CLI::App& command, SweepArguments& arguments) {
  command.add_option("--follow", arguments.follow,
                     "with --methods exact-orbit: curves of these special points over the frequency and a "
                     "second number: fold, period-doubling, neimark-sacker, grazing or contact-change");
  command.add_option("--second", arguments.second.place,
                     "with --follow: the second number, by its place in the scene file");
  command.add_option("--second-from", arguments.second.from, "where curves begin");
  command.add_option("--second-to", arguments.second.to, "where they end");
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("sweep",
                         "Frequency response: one method on one scene at one frequency after "
                         "another, each solve from the answer before; or the branches of several "
                         "methods, by arc length through folds and grazings where a method has its own. "
                         "Exit code 1 if a solve did not converge, or no branch was found.");
  const auto arguments = std::make_shared<SweepArguments>();
  command->add_option("scene", arguments->scene, "a scene of the catalogue, or a scene file")->required();
  command->add_option("--method", arguments->method, "method name; see `signorini list methods`");
  command->add_option("--methods", arguments->methods,
                      "A:B: branches of several methods, by arc length where a method has its own curve "
                      "(exact-orbit, harmonic balance, hat functions), others by steps");
  command->add_flag("--natural", arguments->natural, "with --methods: steps for all of them");
  add_branch_options(*command, *arguments);
  command->add_option("--set", arguments->settings, "key=value: an option of the method; may be repeated")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--from", arguments->from,
                      "first frequency of the load [rad/s], or value of --parameter");
  command->add_option("--to", arguments->to, "last one, above or below");
  command
      ->add_option("--at", arguments->range.at,
                   "w1,w2,...: points exactly there, on every branch; or steps to these frequencies")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_special_point_options(*command, *arguments);
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
  command
      ->add_option("--format", arguments->format,
                   "md, csv, json, or jsonl: one JSON object per branch or step; csv and jsonl as they come")
      ->check(CLI::IsMember({"md", "csv", "json", "jsonl"}))
      ->capture_default_str();
  add_plot_option(*command, arguments->plot, "amplitude over frequency");
  add_column_option(*command, arguments->column, "the picture");
  command->callback([arguments, &exit_code] { exit_code = sweep(*arguments); });
}

}  // namespace signorini
