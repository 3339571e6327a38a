#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/plots/motion_plot.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record_json.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

namespace {

struct SolveArguments {
  std::string scene;
  std::string method;
  std::vector<std::string> settings;
  std::string start;
  int samples = 0;
  double certificate = 1.0;              // [s]
  std::optional<double> reference = {};  // [s]
  bool json = false;
  std::string plot;
};

void print_measure(const char* name, const Measure& value) {
  if (value) fmt::print("{:<22}{:.3e}\n", name, *value);
}

/// What the method says.
void print_answer(const Record& record) {
  fmt::print("{}: {}{}{}\n", record.case_id, status_name(record.status), record.message.empty() ? "" : ": ",
             record.message);
  if (record.law) {
    fmt::print("{:<22}{}{}\n", "law", law_text(*record.law),
               record.law_matches_scene == false ? " (the scene: " + law_text(*record.scene_law) + ")" : "");
  }
  print_measure("period [s]", record.period);
  std::fflush(stdout);
}

/// What the harness says of it.
void print_judgement(const Record& record) {
  fmt::print("{:<22}{}\n", "orbit", orbit_text(record));
  fmt::print("{:<22}{}\n", "error of x", error_text(record));
  const Errors& errors = record.errors;
  for (const auto& [name, value] :
       {std::pair{"  largest", errors.x_max}, std::pair{"error of u", errors.u_l2},
        std::pair{"error of velocity", errors.velocity_l2}, std::pair{"error of impulse", errors.impulse}}) {
    if (value) fmt::print("{:<22}{}\n", name, bounded_text(*value, record));
  }
  print_measure("penetration", record.physics.penetration);
  print_measure("complementarity", record.physics.complementarity);
  print_measure("energy defect", record.physics.energy_defect);
  if (!record.physics.energy_reason.empty())
    fmt::print("{:<22}not defined: {}\n", "energy defect", record.physics.energy_reason);
  print_measure("contact ratio", record.physics.contact_ratio);
  if (!record.physics.effective_restitution.empty()) {
    fmt::print("{:<22}{:.4f}\n", "restitution found", fmt::join(record.physics.effective_restitution, ", "));
  }
  print_measure("condition estimate", record.condition);
  const Work& work = record.work.counts;
  for (const auto& [name, count] :
       {std::pair{"unknowns", work.unknowns}, std::pair{"iterations", work.iterations},
        std::pair{"pivots", work.pivots}}) {
    if (count) fmt::print("{:<22}{}\n", name, *count);
  }
  if (record.seconds) {
    fmt::print("{:<22}{} (set-up {}, solve {})\n", "time", time_text(record.seconds->median),
               time_text(record.seconds->setup), time_text(record.seconds->solve));
  }
}

int solve(const SolveArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  const std::vector cases{
      make_case(scene, 0, {&find_method(arguments.method), parse_settings(arguments.settings)})};
  SolveExtras extras{.samples = arguments.samples};
  std::optional<Record> answer;
  if (!arguments.json) {
    extras.on_answer = [&answer](const Record& record) {
      answer = record;
      print_answer(record);
    };
  }
  if (!arguments.start.empty()) extras.start = start_from_file(arguments.start);
  if (extras.start && cases.front().choice.start())
    throw UsageError("set = start (must be left out: --start names the motion to start from)");
  if (extras.start && extras.start->contact_count() != scene.problem.contact_count()) {
    throw UsageError(fmt::format("start = {} (must have {} contacts as the scene has, not {})",
                                 arguments.start, scene.problem.contact_count(),
                                 extras.start->contact_count()));
  }
  watch_interrupts();
  Runner runner({.repetitions = 1,
                 .certificate_timeout = arguments.certificate,
                 .reference_timeout = arguments.reference.value_or(0.0)});
  if (!arguments.plot.empty()) runner.keep_waveforms();
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  if (interrupted()) return kInterrupted;
  runner.compute_references(scene, jobs);
  std::optional<Record> record = runner.run(scene, jobs.front(), extras);
  if (!record) return kInterrupted;
  const std::optional<Waveforms> waveforms = std::exchange(record->waveforms, std::nullopt);
  if (arguments.json) {
    fmt::print("{}\n", json_line(to_json(*record)));
  } else {
    if (!answer) print_answer(*record);
    if (answer && answer->status != record->status)
      fmt::print("{:<22}{}: {}\n", "verdict", status_name(record->status), record->message);
    print_judgement(*record);
  }
  if (waveforms) write_plot(arguments.plot, motion_plot(scene, *record, *waveforms));
  return record->status == Status::converged ? kDone : kUnexpectedFailure;
}

// A record is one JSON object: at 65,536 instants some 5 MB for each contact.
constexpr int kMostSamples = 1 << 16;

}  // namespace

void add_solve_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("solve", "One run of one method on one scene, judged by the harness.");
  const auto arguments = std::make_shared<SolveArguments>();
  command->add_option("scene", arguments->scene, "a scene of the catalogue, or a scene file")->required();
  command->add_option("--method", arguments->method, "method name; see `signorini list methods`")->required();
  command->add_option("--set", arguments->settings, "key=value: an option of the method; may be repeated")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
  command->add_option("--samples", arguments->samples, "add the motion at this many instants of its period")
      ->check(CLI::Range(1, kMostSamples));
  command->add_option("--start", arguments->start,
                      "start from the motion in a file that solve --json --samples wrote");
  command
      ->add_option("--certificate", arguments->certificate,
                   "wall time of the search for the orbit behind the answer [s]")
      ->check(CLI::Range(0.0, 86400.0))
      ->capture_default_str();
  command
      ->add_option_function<double>(
          "--reference", [arguments](double seconds) { arguments->reference = seconds; },
          "march from rest for so long [s], 60 if no time is given, to tell whether that ends on the same "
          "orbit; without this only the orbits of results/references tell")
      ->check(CLI::Range(0.0, 86400.0))
      ->expected(0, 1)
      ->default_str("60")
      ->run_callback_for_default(false);
  command->add_flag("--json", arguments->json, "print the record as JSON");
  add_plot_option(*command, arguments->plot, "displacement, velocity, impulse and portrait of the answer");
  command->callback([arguments, &exit_code] { exit_code = solve(*arguments); });
}

}  // namespace signorini
