#include "harness/commands/sweep/sweep_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/text/columns.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini {

namespace {

/// Options of branches by arc length.
void add_branch_options(const Command& command, SweepArguments& arguments) {
  command.option(
      "--parameter", arguments.parameter,
      "by arc length: the number to follow, by its place in the scene file, such as contact[0].gap; "
      "energy: that of free motions [J]");
  command.option(
      "--max-order,--orders", arguments.max_order,
      "by arc length: longest period searched [forcing periods]; default 6 for exact-orbit with at most ten "
      "coordinates, else 2",
      {.range = {1, 64}});
  command.option("--max-branches", arguments.branches.max_branches, "by arc length: branches in all",
                 {.range = {1, 10000}});
  command.option("--max-points", arguments.branches.max_points, "by arc length: points of a branch",
                 {.range = {2, 1000000}});
  command.option("--total-time", arguments.total_time, "by arc length: processor time of all branches [s]",
                 {.complaint = positive_seconds});
  command.option(
      "--search", arguments.searches,
      "by arc length, of exact-orbit: begin also at all orbits that `signorini orbits` finds at so "
      "many values inside, for isolated branches",
      {.range = {0, 100}});
  command.flag(
      "--bifurcation", arguments.bifurcation,
      "with --plot, by arc length: a bifurcation diagram, the displacement at t = 0 of every forcing period");
}

void add_attractor_options(const Command& command, SweepArguments& arguments) {
  command.option(
      "--attractors", arguments.attractors.starts,
      "number of initial states, rest and random ones, that are integrated in time at each value: prints the "
      "motions reached, their period in forcing periods or that they are irregular, and the share of the "
      "starts. With --methods exact-orbit branches begin at these motions too, and those on no branch are "
      "listed",
      {.range = {1, 10000}});
  command.option("--jobs", arguments.attractors.jobs, "with --attractors: values computed at the same time",
                 {.range = {1, 1024}});
}

void add_special_point_options(const Command& command, SweepArguments& arguments) {
  command.option("--follow", arguments.follow,
                 "with --methods exact-orbit: curves of these special points over the frequency and a second "
                 "number: fold, period-doubling, neimark-sacker, phase-resonance, grazing or contact-change");
  command.option("--second", arguments.second.place,
                 "with --follow: the second number, by its place in the scene file, or load-factor: that of "
                 "all that varies in the load");
  command.option("--second-from", arguments.second.from, "where curves begin");
  command.option("--second-to", arguments.second.to, "where they end");
  command.flag("--backbone", arguments.backbone,
               "the modes of a damped scene over their amplitude, with frequency, damping ratio and "
               "stability: --follow phase-resonance --second load-factor from 0.01 to 1");
}

}  // namespace

void add_sweep_options(const Command& command, SweepArguments& arguments) {
  command.option("scene", arguments.scene, "a scene of the catalogue, or a scene file", {.required = true});
  command.option("--method", arguments.method, "method name; see `signorini list methods`");
  command.option("--methods", arguments.methods,
                 "A:B: branches of several methods, by arc length where a method has its own curve "
                 "(exact-orbit, harmonic balance, hat functions), others by steps");
  command.flag("--natural", arguments.natural, "with --methods: steps for all of them");
  add_branch_options(command, arguments);
  command.option("--set", arguments.settings, "key=value: an option of the method; may be repeated",
                 {.type_name = "KEY=VALUE", .one_word = true});
  command.option("--from", arguments.from, "first frequency of the load [rad/s], or value of --parameter");
  command.option("--to", arguments.to, "last one, above or below");
  command.option("--at", arguments.range.at,
                 "w1,w2,...: points exactly there, on every branch; or steps to these frequencies",
                 {.one_word = true, .separated_by = ','});
  command.flag("--hz", arguments.hertz, "--from, --to and --at are in Hz");
  add_attractor_options(command, arguments);
  add_special_point_options(command, arguments);
  command.option("--points", arguments.range.points, "number of frequencies, both ends included",
                 {.range = {2, 1000000}});
  command.flag("--log", arguments.range.logarithmic, "equal ratios instead of equal steps");
  command.flag("--down,--back", arguments.range.back,
               "also sweep back from --to to --from, beginning at the last result: where both differ, "
               "motions coexist");
  command.flag("--certify", arguments.limits.certified,
               "look for the orbit behind each answer: whether there is one, and whether it is stable");
  command.option("--timeout", arguments.limits.timeout,
                 "processor time of one solve, with --attractors of all starts at one value [s]",
                 {.complaint = positive_seconds});
  command.option("--format", arguments.format,
                 "text: where branches begin, change and end; md, csv, json: every point; jsonl: one JSON "
                 "object per branch or step; csv and jsonl as they come",
                 {.one_of = {"text", "md", "csv", "json", "jsonl"}});
  add_plot_option(command, arguments.plot, "amplitude over frequency");
  add_column_option(command, arguments.column, "the picture");
  command.option("--out", arguments.out,
                 "keep what is computed in this folder as it comes: manifest.json, branches.jsonl");
  command.flag("--resume", arguments.resume,
               "with --out: methods that the folder has whole are not computed again");
}

SweepRange interval(const SweepArguments& arguments) {
  if (arguments.hertz && arguments.parameter != kFrequency)
    throw UsageError(fmt::format("hz (must be left out with --parameter {})", arguments.parameter));
  const double unit = arguments.hertz ? 2.0 * std::numbers::pi : 1.0;
  SweepRange range = arguments.range;
  for (double& value : range.at) value *= unit;
  if (range.at.empty() && !(arguments.from && arguments.to))
    throw UsageError("--from and --to are required without --at");
  range.from = arguments.from ? *arguments.from * unit : std::ranges::min(range.at);
  range.to = arguments.to ? *arguments.to * unit : std::ranges::max(range.at);
  const auto [low, high] = std::minmax(range.from, range.to);
  for (const double value : range.at)
    if (!(value >= low && value <= high))
      throw UsageError(fmt::format("at = {} (must be between --from and --to)", value));
  return range;
}

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

void complete_free_motions(SweepArguments& arguments) {
  const bool no_interval =
      arguments.parameter == kFrequency && !arguments.from && !arguments.to && arguments.range.at.empty();
  if (!arguments.method.empty() || arguments.natural || arguments.attractors.starts > 0) return;
  if (!no_interval && !arguments.methods.empty()) return;
  if (arguments.parameter == kEnergy) arguments.methods = exact_method().name;  // it alone follows energies
  const Problem problem = read_scene(find_scene(arguments.scene)).problem;
  if (highest_load_harmonic(problem) > 0) return;
  if (const std::string obstacle = continuation_obstacle(problem); !obstacle.empty()) {
    if (!arguments.methods.empty()) return;
    throw UsageError(
        fmt::format("scene = {} (must be one that is followed, or have --method or --methods: {})",
                    problem.name, obstacle));
  }
  if (arguments.methods.empty()) arguments.methods = exact_method().name;
  const auto band = no_interval ? free_motion_band(problem) : std::nullopt;
  if (no_interval && !band)
    throw UsageError("--from and --to are required without contacts or springs that hold the scene");
  if (!band) return;
  arguments.from = band->low;
  arguments.to = band->high;
  arguments.hertz = false;
}

void complete_backbone(SweepArguments& arguments) {
  if (!arguments.backbone) return;
  if (!arguments.follow.empty() || !arguments.method.empty() || arguments.attractors.starts > 0)
    throw UsageError("backbone (must stand without --follow, --method and --attractors)");
  arguments.follow = describe(SpecialKind::phase_resonance);
  if (arguments.methods.empty()) arguments.methods = exact_method().name;
  if (arguments.second.place.empty()) arguments.second.place = kLoadFactor;
  if (arguments.second.place == kLoadFactor && arguments.second.from == SecondParameter{}.from)
    arguments.second.from = 0.01 * arguments.second.to;  // most motions reach no stop
  if (arguments.from || arguments.to) return;
  const ParameterRange band = backbone_band(find_scene(arguments.scene));
  arguments.from = band.low;
  arguments.to = band.high;
  arguments.hertz = false;
}

std::vector<double> attractor_values(const SweepArguments& arguments) {
  const SweepRange& range = arguments.range;
  if (arguments.parameter == kFrequency) return sweep_frequencies(range);
  if (!range.at.empty()) return range.at;
  if (range.from == range.to) throw UsageError("--from and --to must be different");
  std::vector<double> values;
  for (int i = 0; i < range.points; ++i)
    values.push_back(range.from + (range.to - range.from) * i / (range.points - 1));
  return values;
}

std::string table_text(const SweepArguments& arguments, const Table& table) {
  return arguments.format == "csv"  ? to_csv(table)
         : arguments.format == "md" ? to_markdown(table)
                                    : to_columns(table);
}

nlohmann::ordered_json question_of(const SweepArguments& arguments, const Scene& scene) {
  const SweepRange& range = arguments.range;
  const CurveLimits& branches = arguments.branches;
  return {{"scene", scene.problem.name},
          {"sha256", scene.sha256},
          {"parameter", arguments.parameter},
          {"from", range.from},
          {"to", range.to},
          {"at", range.at},
          {"natural", arguments.natural},
          {"points", range.points},
          {"log", range.logarithmic},
          {"down", range.back},
          {"certify", arguments.limits.certified},
          {"timeout", arguments.limits.timeout},
          {"max-order", arguments.max_order ? nlohmann::ordered_json(*arguments.max_order)
                                            : nlohmann::ordered_json("as it costs little")},
          {"max-branches", branches.max_branches},
          {"max-points", branches.max_points},
          {"total-time", arguments.total_time},
          {"search", arguments.searches},
          {"bifurcation", arguments.bifurcation}};
}

}  // namespace signorini
