#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/commands/command_line.hpp"
#include "harness/commands/sweep/sweep_arguments.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
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

std::optional<ResponseFolder> folder_of(const SweepArguments& arguments,
                                        const nlohmann::ordered_json& question) {
  if (!arguments.out) return std::nullopt;
  return std::optional<ResponseFolder>(std::in_place, *arguments.out, question, arguments.words,
                                       arguments.resume);
}

MethodResponse kept_or_followed(std::optional<ResponseFolder>& folder, const MethodChoice& method,
                                MethodResponse response, const UseResponse& follow,
                                const UseResponse& replay) {
  const std::string key = response_key(method);
  if (auto kept = folder ? folder->complete(response.method, key) : std::nullopt) {
    response.diagram = std::move(kept->diagram);
    response.steps = std::move(kept->steps);
    replay(response);
    return response;
  }
  follow(response);
  if (folder && !interrupted() && response.failure.empty()) folder->finish(response, key);
  return response;
}

void draw(const SweepArguments& arguments, const std::vector<MethodResponse>& responses,
          const std::string& scene, const std::vector<AttractorsAt>& attractors) {
  if (arguments.plot.empty()) return;
  const auto ordinate = arguments.bifurcation ? ResponseOrdinate::once_a_period : ResponseOrdinate::amplitude;
  write_plot(arguments.plot,
             response_plot(scene, responses, ordinate, arguments.column, attractors, arguments.parameter));
}

namespace {

// The exit code after an interrupt, with what --resume would do.
int end_interrupted(const SweepArguments& arguments) {
  if (arguments.out)
    fmt::print(stderr, "interrupted; the same command with --resume --out {} does the rest\n",
               *arguments.out);
  return kInterrupted;
}

// Where the answers of one command go as they come.
struct Sweep {
  const SweepArguments& arguments;
  const Scene& scene;
  std::optional<ResponseFolder> folder;
  ResponseStream stream;
};

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
  for (const std::string& line : shortcomings(response, {})) fmt::print(stderr, "{}\n", line);
}

// Points of one method, each solved from the one before, kept and printed as it comes.
void follow_steps(Sweep& sweep, const MethodChoice& method, MethodResponse& response) {
  const SweepArguments& arguments = sweep.arguments;
  const Scene& scene = sweep.scene;
  (void)make_case(scene, 0, method);  // a bad option is told before anything else
  if (method.start()) throw UsageError("set = start (must be left out: each solve starts from the last)");
  const std::size_t points = sweep_frequencies(arguments.range).size() * (arguments.range.back ? 2 : 1);
  Progress progress(points);
  progress.begin(scene.problem.name);
  response.steps =
      frequency_response(scene, method, arguments.range, arguments.limits, [&](const SweepPoint& point) {
        if (sweep.folder) sweep.folder->add(response, point);
        sweep.stream.step(response, point);
        progress.advance();
        progress.begin(fmt::format("{:.6g} rad/s", point.frequency));
      });
  if (interrupted()) fmt::print(stderr, "interrupted after {} of {} points\n", response.steps.size(), points);
}

bool all_converged(const std::vector<SweepPoint>& points) {
  return std::ranges::all_of(
      points, [](Status s) { return s == Status::converged; }, &SweepPoint::status);
}

// The response of a method, kept and printed as it comes: what the folder has kept of it as it would have
// come.
MethodResponse respond(Sweep& sweep, const MethodChoice& method, const UseResponse& follow) {
  const SweepRange& range = sweep.arguments.range;
  MethodResponse blank{
      .method = method.label(),
      .other_law = law_remark_of(sweep.scene, method),
      .order = sweep.scene.problem.subharmonic,
      .parameter = sweep.arguments.parameter,
      .at_values = !range.at.empty(),
      .asked = ParameterRange{.low = std::min(range.from, range.to), .high = std::max(range.from, range.to)}};
  return kept_or_followed(sweep.folder, method, std::move(blank), follow, [&](const MethodResponse& kept) {
    for (const Branch& branch : kept.diagram.branches) sweep.stream.branch(kept, branch);
    for (const SweepPoint& step : kept.steps) sweep.stream.step(kept, step);
  });
}

int sweep_steps(const SweepArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  const MethodChoice method{&find_method(arguments.method), parse_settings(arguments.settings)};
  Sweep sweep{arguments, scene, folder_of(arguments, question_of(arguments, scene)),
              ResponseStream(arguments.format == "jsonl" ? "jsonl" : "", {})};
  watch_interrupts();
  MethodResponse response =
      respond(sweep, method, [&](MethodResponse& made) { follow_steps(sweep, method, made); });
  response.asked.reset();  // it is drawn over the frequencies that were solved
  print_steps(arguments, response);
  draw(arguments, {response}, scene.problem.name);
  if (interrupted()) return end_interrupted(arguments);
  return all_converged(response.steps) ? kDone : kUnexpectedFailure;
}

std::string unit_of(const SweepArguments& arguments) {
  return arguments.parameter == kFrequency ? "rad/s" : "of " + arguments.parameter;
}

// Notes of what the machine does where exact orbits have no motion, in what is left of the time.
void tell_of_gaps(const Sweep& sweep, const ParametrisedScene& varied, const Deadline& deadline,
                  MethodResponse& response) {
  constexpr double kEnough = 10.0;  // s
  const Problem& problem = sweep.scene.problem;
  if (interrupted() || highest_load_harmonic(problem) == 0 || !flow_obstacle(problem).empty()) return;
  for (std::string& line : motions_from_rest(varied, missing(response), unit_of(sweep.arguments),
                                             std::min(kEnough, deadline.left())))
    response.diagram.notes.push_back(std::move(line));
}

// What one method makes of the response, kept and printed as it comes where the format allows.
void follow_response(Sweep& sweep, const ParametrisedScene& varied, const MethodChoice& method,
                     MethodResponse& response) {
  const SweepArguments& arguments = sweep.arguments;
  const std::vector<double>& values = arguments.range.at;
  CurveLimits limits = arguments.branches;
  limits.max_order = arguments.max_order.value_or(default_orders(sweep.scene.problem, method));
  if (!method.entry->exact) limits.begin_at.clear(), limits.at.clear();
  limits.at.insert(limits.at.end(), values.begin(), values.end());
  limits.deadline = Deadline::after(arguments.total_time);
  if (arguments.bifurcation) limits.phases = 1;
  limits.take = [&](const Branch& branch) {
    const Branch shown = values.empty() ? branch : points_at(branch, values);
    if (sweep.folder) sweep.folder->add(response, shown);
    sweep.stream.branch(response, shown);
  };
  std::optional<IsolatedBranches> own;
  if (!arguments.natural) {
    std::optional<Waiting> waiting;  // unless lines come meanwhile
    if (!sweep.stream.prints()) waiting.emplace("following branches of " + response.method);
    own = isolated_branches(varied, method, limits, [&] {  // begun at orbits that half of the time finds, too
      return searched_motions(varied, arguments.searches, limits.max_order, 0.5 * arguments.total_time);
    });
  }
  if (!own) return follow_steps(sweep, method, response);
  response.diagram = std::move(own->diagram);
  response.failure = std::move(own->failure);
  for (Branch& branch : response.diagram.branches) {
    if (!values.empty()) branch = points_at(branch, values);
  }
  if (method.entry->exact && arguments.parameter != kEnergy)
    tell_of_gaps(sweep, varied, limits.deadline, response);
}

void print(const SweepArguments& arguments, const std::vector<MethodResponse>& responses) {
  if (arguments.format == "json") {
    fmt::print("{}\n", json_line(to_json(responses)));
    return;
  }
  if (arguments.format == "md") fmt::print("{}", to_markdown(branch_table(responses)));
  if (arguments.format == "text") fmt::print("{}", sweep_text(responses));
  std::fflush(stdout);  // before what is said of it, where both go into one file
  for (const MethodResponse& response : responses) {
    for (const std::string& note : response.diagram.notes) fmt::print(stderr, "{}\n", note);
    for (const std::string& line : shortcomings(response, arguments.range.at))
      fmt::print(stderr, "{}\n", line);
  }
}

// The methods that are asked for. \throws UsageError where one cannot follow its curve here
std::vector<MethodChoice> chosen_methods(const SweepArguments& arguments, const ParametrisedScene& varied) {
  std::vector<MethodChoice> methods;
  for (const std::string& name : split(arguments.methods, ':'))
    methods.push_back({&find_method(name), parse_settings(arguments.settings)});
  for (const MethodChoice& method : methods) {
    if (!arguments.natural && (arguments.parameter != kFrequency || has_curve(method)))
      require_curve(varied, method);
  }
  return methods;
}

// Branches of several methods, by arc length where a method has a curve of its own. \param all  whether each
// has one
std::vector<MethodResponse> branches_of_methods(const std::vector<MethodChoice>& methods,
                                                const SweepArguments& arguments, const Scene& scene,
                                                const ParametrisedScene& varied, bool& all) {
  Sweep sweep{arguments, scene, folder_of(arguments, question_of(arguments, scene)),
              ResponseStream(arguments.format, {.method = {},
                                                .order = scene.problem.subharmonic,
                                                .parameter = arguments.parameter,
                                                .at_values = !arguments.range.at.empty()})};
  watch_interrupts();
  std::vector<MethodResponse> responses;
  all = true;
  for (const MethodChoice& method : methods) {
    const MethodResponse& response = responses.emplace_back(
        respond(sweep, method, [&](MethodResponse& made) { follow_response(sweep, varied, method, made); }));
    all = all && response.failure.empty() &&
          (response.steps.empty() ? !response.diagram.branches.empty() : all_converged(response.steps));
    if (interrupted()) break;
  }
  sweep.stream.end();
  return responses;
}

int sweep_branches(const SweepArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  const ParametrisedScene varied = parametrised(arguments, scene);
  bool all = true;
  const std::vector<MethodResponse> responses =
      branches_of_methods(chosen_methods(arguments, varied), arguments, scene, varied, all);
  print(arguments, responses);
  draw(arguments, responses, scene.problem.name);
  if (interrupted()) return end_interrupted(arguments);
  if (!all) return kUnexpectedFailure;
  const bool complete =
      std::ranges::all_of(responses, [](const MethodResponse& one) { return missing(one).empty(); });
  return complete ? kDone : kIncomplete;
}

std::vector<AttractorsAt> followed_starts(const SweepArguments& arguments, const Scene& scene,
                                          const ParametrisedScene& varied,
                                          const std::vector<double>& values) {
  AttractorOptions options = arguments.attractors;
  options.timeout = arguments.limits.timeout;
  Progress progress(values.size());
  progress.begin(scene.problem.name);
  return attractors_over(varied, values, options, [&] {
    progress.advance();
    progress.begin(scene.problem.name);
  });
}

// Branches of the methods, those of exact orbits begun at the attractors too, and what they leave out of
// these.
struct AttractorBranches {
  std::vector<MethodResponse> responses = {};
  bool all = true;  // methods have branches
  std::vector<std::string> off = {};
};

AttractorBranches branches_at(std::vector<AttractorsAt>& found, const std::vector<MethodChoice>& methods,
                              const SweepArguments& arguments, const Scene& scene,
                              const ParametrisedScene& varied, const std::vector<double>& values) {
  SweepArguments silent = arguments;
  silent.format = "json";  // what comes is printed at the end
  const MethodChoice exact{.entry = &exact_method()};
  const int orders = arguments.max_order.value_or(default_orders(scene.problem, exact));
  silent.branches.begin_at = motions_of(varied, found, orders);
  silent.branches.at = values;
  AttractorBranches result;
  result.responses = branches_of_methods(methods, silent, scene, varied, result.all);
  for (const MethodResponse& response : result.responses) {
    if (parse_method_label(response.method).method != exact.entry->name) continue;
    result.off = off_branches(found, response.diagram.branches, unit_of(arguments), orders);
  }
  return result;
}

void print_attractors(const SweepArguments& arguments, const AttractorBranches& branches,
                      const std::vector<AttractorsAt>& found) {
  if (arguments.format == "json" || arguments.format == "jsonl") {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const AttractorsAt& at : found) list.push_back(to_json(at));
    if (arguments.format == "jsonl") {
      for (const auto& at : list) fmt::print("{}\n", json_line(at));
      return;
    }
    nlohmann::ordered_json json = to_json(branches.responses);
    json["parameter"] = arguments.parameter;
    json["attractors"] = list;
    json["off_branches"] = branches.off;
    fmt::print("{}\n", json_line(json));
    return;
  }
  if (arguments.format == "text" && !branches.responses.empty()) print(arguments, branches.responses);
  const std::string title = arguments.parameter == kFrequency ? "frequency [rad/s]" : arguments.parameter;
  fmt::print("{}", table_text(arguments, attractor_table(found, title)));
  for (const std::string& line : branches.off) fmt::print(stderr, "{}\n", line);
}

// Where trajectories go, over the branches of methods if there are any.
int sweep_attractors(const SweepArguments& arguments) {
  if (!arguments.method.empty() || arguments.natural || arguments.out || !arguments.follow.empty())
    throw UsageError("--method, --natural, --out and --follow (must be left out with --attractors)");
  if (arguments.parameter == kEnergy)
    throw UsageError(
        fmt::format("parameter = {} (must be a number of the scene with --attractors)", kEnergy));
  const Scene scene = read_scene(find_scene(arguments.scene));
  if (const std::string obstacle = flow_obstacle(scene.problem); !obstacle.empty())
    throw UsageError(fmt::format("scene = {} (must be one that is followed through time: {})",
                                 scene.problem.name, obstacle));
  const ParametrisedScene varied = parametrised(arguments, scene);
  const std::vector<double> values = attractor_values(arguments);
  std::vector<MethodChoice> methods;  // refused, if they are, before starts are followed
  if (!arguments.methods.empty()) methods = chosen_methods(arguments, varied);
  watch_interrupts();
  std::vector<AttractorsAt> found = followed_starts(arguments, scene, varied, values);
  AttractorBranches branches;
  if (!methods.empty()) branches = branches_at(found, methods, arguments, scene, varied, values);
  print_attractors(arguments, branches, found);
  draw(arguments, branches.responses, scene.problem.name, found);
  if (interrupted()) return kInterrupted;
  const bool told = std::ranges::all_of(found, [](const AttractorsAt& at) { return at.failure.empty(); });
  return !(branches.all && told) ? kUnexpectedFailure : branches.off.empty() ? kDone : kIncomplete;
}

int sweep(const SweepArguments& given) {
  SweepArguments arguments = given;
  complete_backbone(arguments);
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

void add_sweep_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "sweep", sweep,
      "The response over the frequency or another number of the scene, and its picture. "
      "--methods follows branches of one or several methods by arc length, through folds and "
      "grazings; a method that cannot do this is solved in frequency steps. --method solves "
      "one method in frequency steps, each from the result before. Exit code 1 if a solve did "
      "not converge, or no branch was found; 6 if parts or attractors are missing.");
  arguments->words = command.words();
  add_sweep_options(command, *arguments);
}

}  // namespace signorini
