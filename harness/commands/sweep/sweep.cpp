#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/commands/sweep/sweep_arguments.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/plots/response_plot.hpp"
#include "harness/progress.hpp"
#include "harness/sweep/branch_response.hpp"
#include "harness/sweep/frequency_response.hpp"
#include "harness/sweep/isolated_branches.hpp"
#include "harness/sweep/response_folder.hpp"
#include "harness/sweep/response_stream.hpp"
#include "harness/terminal/sweep_output.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "methods/structure/bases/condensation.hpp"

namespace signorini {

namespace {

// The folder of --out, if there is one. \throws UsageError
std::optional<ResponseFolder> folder_of(const SweepArguments& arguments, const Scene& scene) {
  if (!arguments.out) return std::nullopt;
  return std::optional<ResponseFolder>(std::in_place, *arguments.out, question_of(arguments, scene),
                                       arguments.words, arguments.resume);
}

void tell_interrupted(const SweepArguments& arguments) {
  if (arguments.out)
    fmt::print(stderr, "interrupted; the same command with --resume --out {} does the rest\n",
               *arguments.out);
}

void print_steps(const SweepArguments& arguments, const MethodResponse& response) {
  if (arguments.format == "jsonl") return;  // each as it came
  if (arguments.format == "json") {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SweepPoint& point : response.steps) {
      list.push_back(to_json(point));
      if (!response.other_law.empty()) list.back()["other_law"] = response.other_law;
    }
    fmt::print("{}\n", json_line(list));
    return;
  }
  fmt::print("{}", table_text(arguments, response_table(response.steps, arguments.limits.certified,
                                                        response.other_law)));
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
  std::optional<ResponseFolder> folder = folder_of(arguments, scene);
  const std::string label = method.label(), key = response_key(method);
  watch_interrupts();
  ResponseStream stream(arguments.format, {});
  MethodResponse response{.method = label, .other_law = law_remark_of(scene, method)};
  const TakePoint print_line = [&](const SweepPoint& point) {
    if (arguments.format == "jsonl") stream.step(response, point);
  };
  const std::optional<MethodResponse> kept = folder ? folder->complete(label, key) : std::nullopt;
  response.steps = kept ? kept->steps : steps(arguments, scene, method, [&](const SweepPoint& point) {
    if (folder) folder->add(response, point);
    print_line(point);
  });
  if (kept) std::for_each(response.steps.begin(), response.steps.end(), print_line);
  if (folder && !kept && !interrupted()) folder->finish(response, key);
  print_steps(arguments, response);
  if (!arguments.plot.empty())
    write_plot(arguments.plot,
               response_plot(scene.problem.name, {response}, ResponseOrdinate::amplitude, arguments.column));
  if (interrupted()) {
    tell_interrupted(arguments);
    return kInterrupted;
  }
  return all_converged(response.steps) ? kDone : kUnexpectedFailure;
}

// The scene with the number asked for left free. \throws UsageError
ParametrisedScene parametrised(const SweepArguments& arguments, const Scene& scene) {
  const SweepRange& range = arguments.range;
  const bool followed = !arguments.natural && !arguments.methods.empty();
  if (!range.at.empty() && range.from == range.to && followed)
    throw UsageError("--from and --to are required with a single value of --at by arc length");
  if (arguments.parameter == kFrequency) {
    (void)sweep_frequencies(range);  // refuses a range that is none
    return over_frequency(scene.problem, range.from, range.to);
  }
  if (arguments.parameter == kEnergy) {
    const Problem& problem = scene.problem;
    if (!(range.from > 0.0 && range.to > 0.0) || range.from == range.to)
      throw UsageError("--from and --to must be different energies above 0");
    return {.parameter = arguments.parameter, .from = range.from, .to = range.to, .at = [problem](double) {
              return problem;
            }};
  }
  if (arguments.natural)
    throw UsageError(
        fmt::format("parameter = {} (must be {} with --natural)", arguments.parameter, kFrequency));
  return over_place(find_scene(arguments.scene), arguments.parameter, range.from, range.to);
}

// An empty response of a method.
MethodResponse blank_response(const SweepArguments& arguments, const Scene& scene,
                              const MethodChoice& method) {
  return {.method = method.label(),
          .other_law = law_remark_of(scene, method),
          .order = scene.problem.subharmonic,
          .parameter = arguments.parameter,
          .at_values = !arguments.range.at.empty(),
          .asked = ParameterRange{.low = std::min(arguments.range.from, arguments.range.to),
                                  .high = std::max(arguments.range.from, arguments.range.to)}};
}

// Prints what a folder has kept as it would have come.
void replay(const MethodResponse& response, ResponseStream& stream) {
  for (const Branch& branch : response.diagram.branches) stream.branch(response, branch);
  for (const SweepPoint& step : response.steps) stream.step(response, step);
}

// Motions at which branches begin too, of as many searches as are asked for.
std::vector<KnownMotion> searched(const SweepArguments& arguments, const ParametrisedScene& varied) {
  constexpr double kShareOfSearches = 0.5;  // of the time
  if (arguments.searches == 0) return {};
  return searched_motions(varied, arguments.searches, arguments.branches.max_order,
                          kShareOfSearches * arguments.total_time);
}

// What one method makes of the response, kept and printed as it comes where the format allows.
MethodResponse response_of(const SweepArguments& arguments, const Scene& scene,
                           const ParametrisedScene& varied, const MethodChoice& method,
                           ResponseStream& stream, ResponseFolder* folder) {
  const std::vector<double>& values = arguments.range.at;
  MethodResponse response = blank_response(arguments, scene, method);
  CurveLimits limits = arguments.branches;
  limits.at = values;
  limits.deadline = Deadline::after(arguments.total_time);
  if (arguments.bifurcation) limits.phases = 1;
  limits.take = [&](const Branch& branch) {
    const Branch shown = values.empty() ? branch : points_at(branch, values);
    if (folder != nullptr) folder->add(response, shown);
    stream.branch(response, shown);
  };
  std::optional<IsolatedBranches> own;
  if (!arguments.natural) {
    std::optional<Waiting> waiting;  // unless lines come meanwhile
    if (!stream.prints()) waiting.emplace("following branches of " + response.method);
    own = isolated_branches(varied, method, limits, [&] { return searched(arguments, varied); });
  }
  if (!own) {
    response.steps = steps(arguments, scene, method, [&](const SweepPoint& point) {
      if (folder != nullptr) folder->add(response, point);
      stream.step(response, point);
    });
    return response;
  }
  response.diagram = std::move(own->diagram);
  response.failure = std::move(own->failure);
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
  if (arguments.format == "text") fmt::print("{}", sweep_text(responses));
  for (const MethodResponse& response : responses) {
    for (const std::string& note : response.diagram.notes) fmt::print(stderr, "{}\n", note);
    const std::string left_out = incompleteness(response);
    if (!left_out.empty())
      fmt::print(stderr, "{}\n", left_out);
    else if (!response.diagram.unfinished.empty())
      fmt::print(stderr, "{}\n", response.diagram.unfinished);
  }
}

// What the folder has kept of a method, or what it makes of the response now.
MethodResponse kept_or_computed(const SweepArguments& arguments, const Scene& scene,
                                const ParametrisedScene& varied, const MethodChoice& method,
                                ResponseStream& stream, std::optional<ResponseFolder>& folder) {
  const std::string key = response_key(method);
  if (auto kept = folder ? folder->complete(method.label(), key) : std::nullopt) {
    MethodResponse response = blank_response(arguments, scene, method);
    response.diagram = std::move(kept->diagram);
    response.steps = std::move(kept->steps);
    replay(response, stream);
    return response;
  }
  MethodResponse response =
      response_of(arguments, scene, varied, method, stream, folder ? &*folder : nullptr);
  if (folder && !interrupted() && response.failure.empty()) folder->finish(response, key);
  return response;
}

// Branches of several methods, by arc length where a method has a curve of its own. \param all  whether each
// has one
std::vector<MethodResponse> branches_of_methods(const SweepArguments& arguments, const Scene& scene,
                                                const ParametrisedScene& varied, bool& all) {
  std::vector<MethodChoice> methods;
  for (const std::string& name : split(arguments.methods, ':'))
    methods.push_back({&find_method(name), parse_settings(arguments.settings)});
  for (const MethodChoice& method : methods) {
    if (!arguments.natural && (arguments.parameter != kFrequency || has_curve(method)))
      require_curve(varied, method);
  }
  std::optional<ResponseFolder> folder = folder_of(arguments, scene);
  watch_interrupts();
  ResponseStream stream(arguments.format, {.method = {},
                                           .order = scene.problem.subharmonic,
                                           .parameter = arguments.parameter,
                                           .at_values = !arguments.range.at.empty()});
  std::vector<MethodResponse> responses;
  all = true;
  for (const MethodChoice& method : methods) {
    responses.push_back(kept_or_computed(arguments, scene, varied, method, stream, folder));
    const MethodResponse& response = responses.back();
    all = all && response.failure.empty() &&
          (response.steps.empty() ? !response.diagram.branches.empty() : all_converged(response.steps));
    if (interrupted()) break;
  }
  stream.end();
  return responses;
}

int sweep_branches(const SweepArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  bool all = true;
  const std::vector<MethodResponse> responses =
      branches_of_methods(arguments, scene, parametrised(arguments, scene), all);
  print(arguments, responses);
  if (!arguments.plot.empty()) {
    const auto ordinate =
        arguments.bifurcation ? ResponseOrdinate::once_a_period : ResponseOrdinate::amplitude;
    write_plot(arguments.plot, response_plot(scene.problem.name, responses, ordinate, arguments.column));
  }
  if (interrupted()) {
    tell_interrupted(arguments);
    return kInterrupted;
  }
  if (!all) return kUnexpectedFailure;
  const bool complete =
      std::ranges::all_of(responses, [](const MethodResponse& one) { return missing(one).empty(); });
  return complete ? kDone : kIncomplete;
}

void print_attractors(const SweepArguments& arguments, const std::vector<MethodResponse>& responses,
                      const std::vector<AttractorsAt>& found) {
  if (arguments.format == "json" || arguments.format == "jsonl") {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const AttractorsAt& at : found) list.push_back(to_json(at));
    if (arguments.format == "jsonl") {
      for (const auto& at : list) fmt::print("{}\n", json_line(at));
      return;
    }
    nlohmann::ordered_json json = to_json(responses);
    json["parameter"] = arguments.parameter;
    json["attractors"] = list;
    fmt::print("{}\n", json_line(json));
    return;
  }
  if (arguments.format == "text" && !responses.empty()) print(arguments, responses);
  const std::string title = arguments.parameter == kFrequency ? "frequency [rad/s]" : arguments.parameter;
  fmt::print("{}", table_text(arguments, attractor_table(found, title)));
}

// Where trajectories go, over the branches of methods if there are any.
int sweep_attractors(const SweepArguments& arguments) {
  if (!arguments.method.empty() || arguments.natural || arguments.out || !arguments.follow.empty())
    throw UsageError("--method, --natural, --out and --follow (must be left out with --attractors)");
  const Scene scene = read_scene(find_scene(arguments.scene));
  if (const std::string obstacle = flow_obstacle(scene.problem); !obstacle.empty())
    throw UsageError(fmt::format("scene = {} (must be one that is followed through time: {})",
                                 scene.problem.name, obstacle));
  const ParametrisedScene varied = parametrised(arguments, scene);
  const std::vector<double> values = attractor_values(arguments);
  SweepArguments silent = arguments;
  silent.format = "json";  // what comes is printed at the end
  bool all = true;
  std::vector<MethodResponse> responses;
  if (!arguments.methods.empty()) responses = branches_of_methods(silent, scene, varied, all);
  watch_interrupts();
  AttractorOptions options = arguments.attractors;
  options.timeout = arguments.limits.timeout;
  std::vector<AttractorsAt> found;
  {
    Progress progress(values.size());
    progress.begin(scene.problem.name);
    found = attractors_over(varied, values, options, [&] {
      progress.advance();
      progress.begin(scene.problem.name);
    });
  }
  print_attractors(arguments, responses, found);
  if (!arguments.plot.empty()) {
    const auto ordinate =
        arguments.bifurcation ? ResponseOrdinate::once_a_period : ResponseOrdinate::amplitude;
    write_plot(arguments.plot, response_plot(scene.problem.name, responses, ordinate, arguments.column, found,
                                             arguments.parameter));
  }
  if (interrupted()) return kInterrupted;
  const bool told = std::ranges::all_of(found, [](const AttractorsAt& at) { return at.failure.empty(); });
  return all && told ? kDone : kUnexpectedFailure;
}

// Free motions have an interval of their own, and one method follows them.
void complete_free_motions(SweepArguments& arguments) {
  const bool no_interval =
      arguments.parameter == kFrequency && !arguments.from && !arguments.to && arguments.range.at.empty();
  if (!arguments.method.empty() || arguments.natural || arguments.attractors.starts > 0) return;
  if (!no_interval && !arguments.methods.empty()) return;
  const Problem problem = read_scene(find_scene(arguments.scene)).problem;
  if (highest_load_harmonic(problem) > 0 || !continuation_obstacle(problem).empty()) return;
  if (arguments.methods.empty()) arguments.methods = exact_method().name;
  const auto band = no_interval ? free_motion_band(problem) : std::nullopt;
  if (!band) return;
  arguments.from = band->low;
  arguments.to = band->high;
  arguments.hertz = false;
}

int sweep(SweepArguments arguments) {
  complete_free_motions(arguments);
  arguments.range = interval(arguments);
  if (arguments.attractors.starts == 0 && arguments.method.empty() == arguments.methods.empty())
    throw UsageError("one of --method and --methods is required");
  if (!arguments.method.empty() && arguments.parameter != kFrequency)
    throw UsageError(
        fmt::format("parameter = {} (must be {} with --method)", arguments.parameter, kFrequency));
  const bool curves = (!arguments.methods.empty() && !arguments.natural) || arguments.attractors.starts > 0;
  if (arguments.bifurcation && (!curves || arguments.plot.empty()))
    throw UsageError("bifurcation (must go with --methods by arc length or --attractors, and --plot)");
  if (arguments.resume && !arguments.out) throw UsageError("resume (must go with --out)");
  if (arguments.attractors.starts > 0) return sweep_attractors(arguments);
  if (!arguments.follow.empty()) return sweep_special_points(arguments);
  return arguments.methods.empty() ? sweep_steps(arguments) : sweep_branches(arguments);
}

}  // namespace

void add_sweep_command(const Command& program, int& exit_code, const std::vector<std::string>& words) {
  const Command command =
      program.command("sweep",
                      "The response over the frequency or another number of the scene, and its picture. "
                      "With --methods the branches of several methods, by arc length through folds and "
                      "grazings where a method has its own; with --method one method at one frequency "
                      "after another, each solve from the answer before. Exit code 1 if a solve did not "
                      "converge, or no branch was found.");
  const auto arguments = std::make_shared<SweepArguments>();
  arguments->words = words;
  add_sweep_options(command, *arguments);
  command.on_run([arguments, &exit_code] { exit_code = sweep(*arguments); });
}

}  // namespace signorini
