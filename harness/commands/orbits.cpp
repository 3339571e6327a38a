#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "harness/commands/command_line.hpp"
#include "harness/interrupt.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/plan/case_name.hpp"
#include "harness/plots/orbit_plot.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/progress.hpp"
#include "harness/summary/motion_summary.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

struct OrbitsArguments {
  std::string scene;
  OrbitSearchOptions options;
  std::optional<int> subharmonics;
  bool json = false;
  std::string plot;
  Column column = Column::own;
};

/// "fourier-lipschitz, hat-lcp": the methods, whatever their options.
std::string method_names(const std::vector<std::string>& labels) {
  std::vector<std::string> names;
  for (const std::string& label : labels) {
    const std::string name = parse_method_label(label).method;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return joined(names, ", ");
}

Cell orbit_number(double value) { return {fmt::format("{:.6g}", value), value}; }

Table orbit_table(const std::vector<FoundOrbit>& orbits) {
  Table table;
  table.header = {"orbit", "order", "impacts", "phases", "amplitude [m]", "multiplier", "stability", "found"};
  for (const FoundOrbit& orbit : orbits) {
    const std::optional<double> multiplier = orbit.largest_multiplier();
    const std::string stability = stability_word(orbit.certified.stable, orbit.certified.undefined);
    table.rows.push_back({orbit.fingerprint + (orbit.from_rest ? " *" : ""), orbit_number(orbit.order),
                          orbit_number(orbit.impacts()), orbit_number(orbit.contact_phases()),
                          orbit_number(orbit.amplitude), multiplier ? orbit_number(*multiplier) : Cell("-"),
                          stability.empty() ? "-" : stability, orbit_number(orbit.starts)});
  }
  return table;
}

/// What does not fit into the table, a line per orbit of which there is something to say.
std::string orbit_notes(const std::vector<FoundOrbit>& orbits) {
  std::string text;
  const auto note = [&](const std::string& line) {
    for (const std::string& part : wrapped_lines(line, kTerminalWidth)) text += part + "\n";
  };
  if (std::ranges::any_of(orbits, &FoundOrbit::from_rest)) note("* the motion reached from rest");
  for (const FoundOrbit& orbit : orbits) {
    if (orbit.certified.source.find("chatter") != std::string::npos)
      note(orbit.fingerprint + ": after these impacts complete chatter, infinitely many");
    if (!orbit.certified.undefined.empty())
      note(fmt::format("{}: stability undefined: {}", orbit.fingerprint, orbit.certified.undefined));
    if (!orbit.cold.empty())
      note(orbit.fingerprint + " is also found without an initial motion by " + method_names(orbit.cold));
  }
  return text;
}

/// Half of largest less least displacement, between the samples of the search too.
double exact_amplitude(const Problem& problem, const Trajectory& motion) {
  const MotionSummary summary = summarise_motion(problem, as_represented(problem.law()), motion,
                                                 sample_motion(problem, motion), {.harmonics = 0});
  double largest = 0.0;
  for (const DisplacementSummary& one : summary.x) largest = std::max(largest, one.amplitude);
  return largest;
}

void print_remarks(const SceneOrbits& found, const OrbitSearchOptions& options, const std::string& scene) {
  int failed = 0;
  for (const auto& [reason, count] : found.failures) failed += count;
  fmt::print(stderr, "{} searches, {} of them without an exact motion\n", found.searches, failed);
  for (const auto& [reason, count] : found.failures) fmt::print(stderr, "  {1}: {0}\n", count, reason);
  for (const auto& [how, names] : found.losses)
    fmt::print(stderr, "  lost: {} x {} ({})\n", names.size(), how, joined(names, ", "));
  if (found.expired)
    fmt::print(stderr, "the time limit of {:g} s cut the search short: there may be more\n", options.timeout);
  if (found.interrupted) fmt::print(stderr, "interrupted: there may be more\n");
  if (std::ranges::none_of(found.orbits,
                           [](const FoundOrbit& orbit) { return orbit.certified.stable.value_or(true); }))
    fmt::print(stderr,
               "no stable motion of order <= {} was found among {} starts: signorini motion {} tells what "
               "happens instead\n",
               options.subharmonics, found.searches, scene);
}

int list_orbits(const OrbitsArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  if (!arguments.plot.empty()) require_contact_to_draw(scene.problem);
  OrbitSearchOptions options = arguments.options;
  options.subharmonics = arguments.subharmonics.value_or(default_subharmonics(scene.problem));
  watch_interrupts();
  SceneOrbits found = [&] {
    const Waiting waiting("searching orbits of " + scene.problem.name);
    return find_all_orbits(scene.problem, options);
  }();
  for (FoundOrbit& orbit : found.orbits)
    orbit.amplitude = exact_amplitude(scene.problem, *orbit.certified.motion);
  if (arguments.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const FoundOrbit& orbit : found.orbits) list.push_back(to_json(orbit));
    fmt::print("{}\n", json_text(list));
  } else if (!found.orbits.empty()) {
    fmt::print("{}{}", to_columns(orbit_table(found.orbits)), orbit_notes(found.orbits));
  }
  print_remarks(found, options, arguments.scene);
  if (!arguments.plot.empty() && !found.orbits.empty())
    write_plot(arguments.plot, orbit_plot(scene.problem, found.orbits, arguments.column));
  if (found.interrupted) return kInterrupted;
  if (!found.orbits.empty()) return kDone;
  fmt::print(stderr, "no certified orbit\n");
  return kUnexpectedFailure;
}

}  // namespace

void add_search_options(const Command& command, OrbitSearchOptions& options,
                        std::optional<int>& subharmonics) {
  command.option("--starts", options.starts, "random states to start from, at each order",
                 {.range = {0, 100000}});
  command.option("--subharmonics", subharmonics,
                 "search periods of 1 to this many forcing periods; if absent 3, or the scene's own if more",
                 {.range = {1, 64}});
  command.option("--seed", options.seed, "of the random states");
  command.option("--timeout", options.timeout,
                 "processor time of the search of one scene, its two processes together [s]",
                 {.complaint = positive_seconds});
}

void add_orbits_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "orbits", list_orbits,
      "Searches the coexisting periodic motions of a scene, stable or not, each exact to rounding; "
      "exit code 1 if none is found.");
  command.option("scene", arguments->scene, "a scene of the catalogue, or a scene file", {.required = true});
  add_search_options(command, arguments->options, arguments->subharmonics);
  command.flag("--json", arguments->json, "print the orbits as a JSON array, events included");
  add_plot_option(command, arguments->plot,
                  "the portrait of each orbit, the first 12, with multipliers and shares of starts");
  add_column_option(command, arguments->column, "the picture");
}

}  // namespace signorini
