#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/plots/motion_plot.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/progress.hpp"
#include "harness/records/record_json.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/run/runner.hpp"
#include "harness/terminal/solve_output.hpp"
#include "harness/terminal/terminal.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

struct SolveArguments {
  std::string scene;
  std::string method;
  std::vector<std::string> settings;
  std::string start;
  int samples = 0;
  std::optional<double> timeout = {}, certificate = {}, reference = {};  // [s]
  bool json = false;
  bool verbose = false;
  int harmonics = SummaryRequest{}.harmonics;
  std::vector<int> dofs;
  std::string plot;
  Column column = Column::own;
};

/// The motion to start from. \throws UsageError where it is none for the scene and the method
std::shared_ptr<const Trajectory> start_of(const SolveArguments& arguments, const Scene& scene,
                                           const Case& planned_case) {
  if (arguments.start.empty()) return nullptr;
  std::shared_ptr<const Trajectory> start = start_from_file(arguments.start);
  if (planned_case.choice.start())
    throw UsageError("set = start (must be left out: --start names the motion to start from)");
  if (start->contact_count() != scene.problem.contact_count()) {
    throw UsageError(fmt::format("start = {} (must have {} contacts as the scene has, not {})",
                                 arguments.start, scene.problem.contact_count(), start->contact_count()));
  }
  return start;
}

void require_coordinates(const std::vector<int>& dofs, int size) {
  for (const int dof : dofs) {
    if (dof < 0 || dof >= size)
      throw UsageError(fmt::format("dofs = {} (must be coordinates of the scene, 0 to {})", dof, size - 1));
  }
}

/// What following a motion through time costs grows with the coordinates [s].
double certificate_seconds(const Problem& problem) { return std::clamp(1.0 * problem.size(), 10.0, 120.0); }

/// Prints what the method says once the harness has judged it, for whether the motion is stable stands in the
/// first lines; a terminal sees meanwhile for how long. What an interrupt leaves unjudged is printed, too.
int solve(const SolveArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  const std::vector cases{
      make_case(scene, 0, {&find_method(arguments.method), parse_settings(arguments.settings)})};
  require_coordinates(arguments.dofs, scene.problem.size());
  if (!arguments.plot.empty()) require_contact_to_draw(scene.problem);
  SolveExtras extras{.start = start_of(arguments, scene, cases.front()),
                     .samples = arguments.samples,
                     .summary = SummaryRequest{.harmonics = arguments.harmonics, .dofs = arguments.dofs}};
  watch_interrupts();
  Runner runner({.timeout = arguments.timeout.value_or(Limits{}.timeout),
                 .repetitions = 1,
                 .certificate_timeout = arguments.certificate.value_or(certificate_seconds(scene.problem)),
                 .reference_timeout = arguments.reference.value_or(0.0)});
  if (!arguments.plot.empty()) runner.keep_waveforms(2e-4);  // below what is seen on a page
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  if (interrupted()) return kInterrupted;
  std::optional<Waiting> waiting(std::in_place, "solving by " + arguments.method);
  std::optional<Record> unjudged;
  if (!arguments.json)
    extras.on_answer = [&](const Record& answer) {
      waiting.reset();
      unjudged = answer;
      waiting.emplace("looking for the orbit behind the answer");
    };
  runner.compute_references(scene, jobs);
  std::optional<Record> record = runner.run(scene, jobs.front(), extras);
  waiting.reset();
  const SolveOutput output{arguments.verbose, takes_colour(STDOUT_FILENO)};
  if (!record) {
    if (unjudged) fmt::print("{}", answer_text(*unjudged, output));
    return kInterrupted;
  }
  const std::optional<Waveforms> waveforms = std::exchange(record->waveforms, std::nullopt);
  if (arguments.json) {
    fmt::print("{}\n", json_line(to_json(*record)));
  } else {
    fmt::print("{}{}", answer_text(*record, output), judgement_text(*record, output));
  }
  if (waveforms) write_plot(arguments.plot, motion_plot(scene, *record, *waveforms, arguments.column));
  return record->status == Status::converged ? kDone : kUnexpectedFailure;
}

}  // namespace

void add_solve_command(const Command& program) {
  const auto [command, arguments] = program.command(
      "solve", solve, "One periodic motion, its stability and its error, by one method on one scene.");
  command.option("scene", arguments->scene, "a scene of the catalogue, or a scene file", {.required = true});
  command.option("--method", arguments->method, "method name; see `signorini list methods`",
                 {.required = true});
  command.option("--set", arguments->settings, "key=value: an option of the method; may be repeated",
                 {.type_name = "KEY=VALUE", .one_word = true});
  // A record is one JSON object: at 65,536 instants some 5 MB for each contact.
  command.option("--samples", arguments->samples, "add the motion at this many instants of its period",
                 {.range = {1, 1 << 16}});
  command.option("--dofs", arguments->dofs,
                 "coordinates whose motion is wanted too, separated by commas, the first is 0",
                 {.type_name = "I,J", .one_word = true, .separated_by = ','});
  command.option("--harmonics", arguments->harmonics,
                 "print amplitude and phase of this many harmonics of the motion's period",
                 {.range = {0, 1000}});
  command.option("--start", arguments->start,
                 "start from the motion in a file that solve --json --samples wrote");
  command.option(
      "--timeout", arguments->timeout,
      "processor time of the method [s], 30 if it is not given; the wall time may be ten times as long",
      {.complaint = positive_seconds});
  command.option(
      "--certificate", arguments->certificate,
      "processor time of the search for an exact motion near the result [s], 0 for none; if it is not "
      "given a second for each coordinate of the scene, at least 10 and at most 120",
      {.interval = {0.0, 86400.0}});
  command.option(
      "--reference", arguments->reference,
      "integrate from rest, for at most this processor time [s], 60 if no time is given, to tell whether "
      "the motion ends on the same orbit; without this only the orbits of results/references tell",
      {.alone_means = "60", .interval = {0.0, 86400.0}});
  command.flag("--json", arguments->json, "print the record as JSON");
  command.flag("--verbose", arguments->verbose,
               "print every contact, impact and phase of contact, and what the solver counted");
  add_plot_option(command, arguments->plot, "displacement, velocity, impulse and phase portrait");
  add_column_option(command, arguments->column, "the picture");
}

}  // namespace signorini
