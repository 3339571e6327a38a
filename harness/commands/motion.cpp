#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "harness/commands/command_line.hpp"
#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/interrupt.hpp"
#include "harness/judge/exact_certificate.hpp"
#include "harness/motion/followed_scene.hpp"
#include "harness/motion/long_motion.hpp"
#include "harness/orbits/orbit_candidate.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/plots/section_plot.hpp"
#include "harness/progress.hpp"
#include "harness/table.hpp"
#include "harness/text/columns.hpp"
#include "harness/text/json.hpp"
#include "harness/text/words.hpp"
#include "methods/structure/bases/condensation.hpp"
#include "problems/files/text_lines.hpp"
#include "problems/scene/scene_layout.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

struct MotionArguments {
  std::string scene;
  std::string states;  // the file of --from-state
  int starts = 0;
  unsigned seed = 1;
  LongMotionOptions options;
  double timeout = 60.0;  // [s]
  bool json = false;
  std::string plot, waveform;
  int first = 20;  // periods drawn and written [-]
  Column column = Column::own;
};

/// A state to start from, and what it is called.
struct NamedState {
  std::string name;
  FlowState state;
};

/// What became of a start.
struct Outcome {
  std::string start;
  FlowState from;
  LongMotion motion;
  std::optional<FoundOrbit> orbit = {};  ///< where it is periodic and its orbit is certified
  std::string no_orbit = {};             ///< why it is not certified where it is periodic
};

/// One state per line, displacements and then velocities of all coordinates, at t = 0; "#" begins a comment.
/// \throws UsageError that names the line
std::vector<NamedState> states_of_file(const std::string& file, const EventFlow& flow, const Problem& problem,
                                       const FollowedScene& followed) {
  std::vector<NamedState> states;
  std::istringstream lines(read_file(file));
  const int size = problem.size();
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> values;
    for (std::string word; words >> word;) {
      const std::optional<double> value = number_of<double>(word);
      if (!value)
        throw UsageError(fmt::format("from-state = {} (line {}: {} is no number)", file, number, word));
      values.push_back(*value);
    }
    if (values.empty()) continue;
    if (static_cast<int>(values.size()) != 2 * size) {
      throw UsageError(
          fmt::format("from-state = {} (line {} must hold {} numbers: {} displacements and as "
                      "many velocities, not {})",
                      file, number, 2 * size, size, values.size()));
    }
    const Eigen::Map<const Eigen::VectorXd> all(values.data(), 2L * size);
    const Eigen::VectorXd x = contact_directions(problem).transpose() * all.head(size);
    const State whole{.u = followed.coordinates(all.head(size)), .v = followed.coordinates(all.tail(size))};
    states.push_back({fmt::format("line {}", number), flow.place(0.0, flow.dynamics().with_mass(whole, x))});
  }
  if (states.empty()) throw UsageError(fmt::format("from-state = {} (must hold a state)", file));
  return states;
}

/// Rest or the states of a file, then random ones.
std::vector<NamedState> starts_of(const MotionArguments& arguments, const EventFlow& flow,
                                  const Problem& problem, const FollowedScene& followed) {
  std::vector<NamedState> states;
  if (arguments.states.empty()) {
    states.push_back({"rest", flow.place(0.0, flow.dynamics().at_rest())});
  } else {
    states = states_of_file(arguments.states, flow, problem, followed);
  }
  for (int i = 0; i < arguments.starts; ++i)
    states.push_back({fmt::format("random state {}", i), random_state(flow, arguments.seed, i)});
  return states;
}

/// Looks for the exact orbit of a periodic motion.
void certify(const Problem& problem, const Deadline& deadline, Outcome& outcome) {
  const LongMotion& motion = outcome.motion;
  if (motion.verdict != LongRun::periodic || problem.contacts.empty()) return;
  CertifiedOrbit certified =
      exact_orbits()(with_subharmonic(problem, motion.order), *motion.trajectory, {}, deadline);
  if (!certified.motion) {
    outcome.no_orbit = certified.reason;
    return;
  }
  outcome.orbit = describe_orbit(problem, motion.order, std::move(certified));
  outcome.orbit->starts = 1;
}

/// What is not there is null, as infinite numbers are.
template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

}  // namespace

// Found by the JSON library, which writes lists of these.
static void to_json(Json& json, const Estimate& estimate) {
  json = {{"value", estimate.value}, {"error", estimate.error}};
}

static void to_json(Json& json, const StopStatistics& stop) {
  json = {{"x_mean", stop.x_mean},
          {"x_rms", stop.x_rms},
          {"x_min", stop.x_min},
          {"x_max", stop.x_max},
          {"force_rms", or_null(stop.force_rms)},
          {"force_peak", or_null(stop.force_peak)},
          {"impulse_per_second", stop.impulse_per_second},
          {"impacts_per_second", stop.impacts_per_second},
          {"impulse_mean", or_null(stop.impulse_mean)},
          {"impulse_deviation", or_null(stop.impulse_deviation)},
          {"power", or_null(stop.power)}};
}

namespace {

Json outcome_json(const Outcome& outcome) {
  const LongMotion& motion = outcome.motion;
  const bool repeats = motion.order > 0;
  return {{"start", outcome.start},
          {"verdict", name_of(motion.verdict)},
          {"reason", motion.reason},
          {"order", repeats ? Json(motion.order) : Json()},
          {"orbit", outcome.orbit ? to_json(*outcome.orbit) : Json()},
          {"orbit_reason", outcome.no_orbit},
          {"settled_after", repeats ? Json(motion.settled_after) : Json()},
          {"measured", motion.measured},
          {"lyapunov", motion.lyapunov},
          {"contacts", motion.stops}};
}

/// The first start's, and all in `starts`.
Json motion_json(const Problem& problem, const std::vector<Outcome>& outcomes) {
  Json json{{"scene", problem.name}, {"forcing_period", problem.forcing_period()}};
  json.update(outcome_json(outcomes.front()));
  json.erase("start");
  json["starts"] = Json::array();
  for (const Outcome& outcome : outcomes) json["starts"].push_back(outcome_json(outcome));
  return json;
}

std::string text_of(const Estimate& estimate) {
  if (!std::isfinite(estimate.value)) return "deviations vanish";
  return fmt::format("{:.4g} +- {:.1g}", estimate.value, estimate.error);
}

/// A row for each contact.
Table stop_table(const std::vector<StopStatistics>& stops) {
  Table table{{"contact", "x [m]", "force RMS [N]", "impacts [1/s]", "impulse [N s]", "power [W]"}, {}};
  for (const StopStatistics& stop : stops) {
    table.rows.push_back(
        {std::to_string(table.rows.size()), fmt::format("{:.4g}..{:.4g}", stop.x_min, stop.x_max),
         stop.force_rms ? text_of(*stop.force_rms) : "impulses", text_of(stop.impacts_per_second),
         stop.impulse_mean ? fmt::format("{:.4g}", *stop.impulse_mean) : "-",
         stop.power ? text_of(*stop.power) : "-"});
  }
  return table;
}

std::string headline(const Outcome& outcome) {
  const LongMotion& motion = outcome.motion;
  std::string text = fmt::format("from {}: {}", outcome.start, name_of(motion.verdict));
  if (motion.order > 0)
    text += fmt::format(", order {}, after {} forcing periods", motion.order, motion.settled_after);
  if (outcome.orbit) text += fmt::format(", orbit {}", outcome.orbit->fingerprint);
  if (!outcome.no_orbit.empty()) text += fmt::format(", no certified orbit: {}", outcome.no_orbit);
  if (!motion.reason.empty()) text += fmt::format(" ({})", motion.reason);
  return text + "\n";
}

/// \param periods  that were to be measured
std::string details(const LongMotion& motion, int periods) {
  const bool cut = motion.order == 0 && motion.measured < periods;
  std::vector<std::string> exponents;
  for (const Estimate& exponent : motion.lyapunov) exponents.push_back(text_of(exponent));
  std::string text;
  if (!exponents.empty())
    text = fmt::format("Lyapunov exponents [1/s]: {} (over {} forcing periods{})\n", joined(exponents, ", "),
                       motion.measured, cut ? ", for which the time lasted" : "");
  if (!motion.stops.empty()) text += to_columns(stop_table(motion.stops));
  return text;
}

/// Instants, and x, x' and the force of each contact.
void write_waveform(const std::string& file, const Trajectory& motion, int periods) {
  constexpr int kPerPeriod = 256;
  const int count = kPerPeriod * periods;
  const Samples samples = motion.sample(count);
  Table table{.header = {"t [s]"}, .rows = {}};
  for (int j = 0; j < motion.contact_count(); ++j) {
    for (const char* name : {"x{} [m]", "velocity{} [m/s]", "force{} [N]"})
      table.header.push_back(fmt::format(fmt::runtime(name), j));
  }
  for (int i = 0; i < count; ++i) {
    std::vector<Cell> row{fmt::format("{:.17g}", motion.period() * i / count)};
    for (Eigen::Index j = 0; j < samples.x.cols(); ++j) {
      for (const double value : {samples.x(i, j), samples.velocity(i, j), samples.force(i, j)})
        row.emplace_back(fmt::format("{:.17g}", value));
    }
    table.rows.push_back(std::move(row));
  }
  write_whole(file, to_csv(table));
}

void write_files(const MotionArguments& arguments, const Problem& problem, const ContactDynamics& dynamics,
                 const Outcome& first) {
  if (arguments.plot.empty() && arguments.waveform.empty()) return;
  const auto motion = first_periods(dynamics, first.from, arguments.first);
  if (!arguments.waveform.empty()) write_waveform(arguments.waveform, *motion, arguments.first);
  if (!arguments.plot.empty())
    write_plot(arguments.plot, section_plot(problem, first.motion, *motion, arguments.column));
}

int tell_motion(const MotionArguments& arguments) {
  const SceneSource source = find_scene(arguments.scene);
  const Scene scene = read_scene(source);
  const Problem& problem = scene.problem;
  if (const std::string obstacle = flow_obstacle(problem); !obstacle.empty())
    throw UsageError(
        fmt::format("scene = {} (must be one that is followed through time: {})", problem.name, obstacle));
  watch_interrupts();
  const Deadline deadline = Deadline::after(arguments.timeout);
  const FollowedScene followed(problem);
  const EventFlow placing = placing_flow(followed.dynamics());
  const std::vector<NamedState> starts = starts_of(arguments, placing, problem, followed);
  const std::vector<DampedStop> damped = load_outline(source).damped_stops;
  std::vector<Outcome> outcomes;
  {
    const Waiting waiting("following " + problem.name);
    for (std::size_t i = 0; i < starts.size() && !interrupted(); ++i) {
      const double share = deadline.left() / static_cast<double>(starts.size() - i);
      const Deadline own = Deadline::after(std::max(0.0, share));
      outcomes.push_back(
          {starts[i].name, starts[i].state, followed.follow(starts[i].state, arguments.options, own)});
      // The face of a damped stop does no work: what its damper takes is not measured.
      std::vector<StopStatistics>& stops = outcomes.back().motion.stops;
      for (const DampedStop& stop : damped)
        if (!stops.empty()) stops[static_cast<std::size_t>(stop.contact)].power.reset();
      certify(followed.problem(), own, outcomes.back());
    }
  }
  if (interrupted() || outcomes.empty()) return kInterrupted;
  if (arguments.json) {
    fmt::print("{}\n", json_text(motion_json(problem, outcomes)));
  } else {
    for (const Outcome& outcome : outcomes) fmt::print("{}", headline(outcome));
    fmt::print("{}", details(outcomes.front().motion, arguments.options.periods));
  }
  write_files(arguments, problem, followed.dynamics(), outcomes.front());
  return outcomes.front().motion.verdict == LongRun::undecided ? kUnexpectedFailure : kDone;
}

}  // namespace

void add_motion_command(const Command& program) {
  constexpr int kMostPeriods = 10'000'000;
  const auto [command, arguments] = program.command(
      "motion", tell_motion,
      "Integrates in time, from rest or from given states, and tells what the motion settles to: periodic, "
      "quasi-periodic, irregular (chaos), at rest or unbounded. Prints Lyapunov exponents and statistics of "
      "the impacts. Exit code 1 if the kind stays undecided.");
  command.option("scene", arguments->scene, "a scene of the catalogue, or a scene file", {.required = true});
  command.option(
      "--from-state", arguments->states,
      "a file of states to start from in place of rest, one per line: displacements, then velocities "
      "of all coordinates at t = 0, faces of damped stops last; relative to stops and bases that move",
      {.type_name = "FILE"});
  command.option("--starts", arguments->starts, "further starts from random states", {.range = {0, 10000}});
  command.option("--seed", arguments->seed, "of the random states");
  command.option("--transient", arguments->options.transient,
                 "forcing periods in which the motion may settle, at most", {.range = {1, kMostPeriods}});
  command.option("--periods", arguments->options.periods,
                 "forcing periods over which a motion that does not settle is measured, at most",
                 {.range = {1, kMostPeriods}});
  command.option("--max-order", arguments->options.max_order,
                 "forcing periods after which a periodic motion repeats, at most; twice that where it "
                 "settles late",
                 {.range = {1, 64}});
  command.option("--exponents", arguments->options.exponents, "Lyapunov exponents, the largest ones, at most",
                 {.range = {1, 1000}});
  command.option("--timeout", arguments->timeout,
                 "processor time of all starts, the certificates of their orbits included [s]",
                 {.complaint = positive_seconds});
  command.flag("--json", arguments->json, "print a JSON object; see docs/records.md");
  command.option(
      "--waveform", arguments->waveform,
      "write x, velocity and force over the first periods of the first start as comma separated values",
      {.type_name = "FILE"});
  command.option("--first", arguments->first, "periods that --waveform writes and --plot draws",
                 {.range = {1, 10000}});
  add_plot_option(command, arguments->plot,
                  "the first periods of the first start, and its stroboscopic section");
  add_column_option(command, arguments->column, "the picture");
}

}  // namespace signorini
