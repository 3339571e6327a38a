#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/records/record_json.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/run/trial.hpp"
#include "harness/text/json.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kExchangeSchema = 1;
/// Instants at which a motion to start from is handed over.
constexpr int kStartSamples = 1024;
/// What every scene is called: answers are found, not looked up.
constexpr const char* kUnnamed = "scene";

/// Entries as three lists: a million of them is no object each.
Json write_matrix(const SparseMatrix& matrix) {
  std::vector<int> rows, columns;
  std::vector<double> values;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
      rows.push_back(static_cast<int>(entry.row()));
      columns.push_back(static_cast<int>(entry.col()));
      values.push_back(entry.value());
    }
  }
  return {{"row", rows}, {"column", columns}, {"value", values}};
}

Json write_force(const Problem& problem) {
  Json force = Json::array();
  for (const ForceTerm& term : problem.force) {
    const std::complex<double> amplitude = force_amplitude(term, problem.frequency);
    Json written{{"dof", term.dof},
                 {"harmonic", term.harmonic},
                 {"cos", amplitude.real()},
                 {"sin", term.harmonic == 0 ? term.sin : -amplitude.imag()}};
    if (term.omega_power > 0) written["omega_power"] = term.omega_power;
    force.push_back(std::move(written));
  }
  return force;
}

Json write_problem(const Problem& problem) {
  Json contacts = Json::array();
  for (const Contact& contact : problem.contacts)
    contacts.push_back(
        {{"normal", contact.normal}, {"gap", contact.gap}, {"law", contact_law_json(contact.law)}});
  Json written{{"name", kUnnamed},
               {"size", problem.size()},
               {"mass", write_matrix(problem.mass())},
               {"damping", write_matrix(problem.damping())},
               {"stiffness", write_matrix(problem.stiffness())},
               {"frequency", problem.frequency},
               {"subharmonic", problem.subharmonic},
               {"period", problem.period()},
               {"force", write_force(problem)},
               {"contacts", std::move(contacts)},
               {"law", JsonForm<RepresentedLaw>::write(as_represented(problem.law()))}};
  if (const SpeedTerms* speed = problem.structure->speed.get()) {
    written["gyroscopic_per_speed"] = write_matrix(speed->gyroscopic);
    written["circulatory_per_speed"] = write_matrix(speed->circulatory);
  }
  return written;
}

[[noreturn]] void refuse(const std::string& what) {
  throw SolveFailure(Status::invalid_output, "the command's answer: " + what);
}

void allow_only(const Json& json) {
  constexpr std::array<std::string_view, 9> kKeys{"verdict", "message",    "period", "residual", "condition",
                                                  "work",    "trajectory", "events", "seconds"};
  for (const auto& [key, value] : json.items()) {
    if (std::ranges::find(kKeys, key) == kKeys.end())
      refuse(fmt::format("{} = unknown (must be one of {})", one_line(key), fmt::join(kKeys, ", ")));
  }
}

Verdict read_verdict(const Json& json) {
  const std::string word = json.at("verdict");
  if (word == "converged") return Verdict::converged;
  if (word != "not-converged")
    refuse(fmt::format("verdict = {} (must be converged or not-converged)", one_line(word)));
  return Verdict::not_converged;
}

/// The instants are redundant, but an answer on others would be misread.
void require_equidistant(const std::vector<double>& t, double period) {
  constexpr double kShare = 1e-6;  // of the period
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double due = static_cast<double>(i) * period / static_cast<double>(t.size());
    if (!(std::abs(t[i] - due) <= kShare * period))
      refuse(fmt::format("trajectory.t[{}] = {} (must be i period / N = {})", i, t[i], due));
  }
}

std::vector<ContactEvent> read_events(const Json& json) {
  std::vector<ContactEvent> events;
  for (const Json& item : json) {
    const auto kind =
        enum_from_name<ContactEvent::Kind>("events.kind", one_line(item.at("kind").get<std::string>()));
    ContactEvent event{.kind = kind,
                       .contact = whole_number<int>("events.contact", item.at("contact")),
                       .time = item.at("time")};
    if (item.contains("impulse")) event.impulse = item["impulse"].get<double>();
    if (item.contains("push")) event.push = item["push"].get<double>();
    events.push_back(event);
  }
  return events;
}

/// The motion with its events, if the command lists them.
std::shared_ptr<const Trajectory> read_motion(const Json& json, double period) {
  TrajectorySamples samples;
  read_fields(json.at("trajectory"), samples);
  samples.events.reset();  // a command lists its own beside the trajectory
  require_equidistant(samples.t, period);
  const auto motion = trajectory_of(period, samples);
  if (!json.contains("events")) return motion;
  SampledTrajectory::Data data = motion->data();
  data.events = read_events(json["events"]);
  try {
    return std::make_shared<SampledTrajectory>(std::move(data));
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
}

/// Counts of work: those of a record, none of them negative.
Work read_work(const Json& json) {
  WorkDone work;
  const Json known = write_fields(WorkDone{.counts = {0, 0, 0, 0, 0, 0}});
  for (const auto& [key, value] : json.items()) {
    if (!known.contains(key)) refuse(fmt::format("work.{} = unknown", one_line(key)));
    if (!value.is_number() || value.get<double>() < 0.0)
      refuse(fmt::format("work.{} = {} (must be 0 or more)", key, one_line(json_text(value))));
  }
  read_fields(json, work);
  return work.counts;
}

Solution read_solution(const Json& json, double period) {
  allow_only(json);
  Solution solution{.verdict = read_verdict(json)};
  if (json.contains("message")) solution.message = one_line(json["message"].get<std::string>(), 400);
  if (solution.message.empty()) solution.message = "the command gave no message";
  if (json.contains("residual")) solution.residual = json["residual"].get<double>();
  if (json.contains("condition")) solution.condition = json["condition"].get<double>();
  if (json.contains("work")) solution.work = read_work(json["work"]);
  if (!json.contains("trajectory")) return solution;
  if (json.contains("period")) period = json["period"].get<double>();
  solution.trajectory = read_motion(json, period);
  return solution;
}

std::optional<double> read_seconds(const Json& json) {
  if (!json.contains("seconds")) return std::nullopt;
  const double seconds = json["seconds"];
  if (!(seconds >= 0.0)) refuse(fmt::format("seconds = {} (must be 0 or more)", seconds));
  return seconds;
}

}  // namespace

Json command_request(const Problem& problem, const std::vector<OptionEcho>& options) {
  RecordedOptions values;
  for (const OptionEcho& option : options) values.emplace_back(option.name, option.value);
  return {{"schema", kExchangeSchema},
          {"problem", write_problem(problem)},
          {"options", JsonForm<RecordedOptions>::write(values)}};
}

void take_frequency(Json& request, const Problem& problem) {
  Json& written = request.at("problem");
  written["frequency"] = problem.frequency;
  written["period"] = problem.period();
  written["force"] = write_force(problem);
}

std::string command_input(Json request, const Start& start) {
  if (start.guess) {
    TrajectorySamples samples = samples_of(*start.guess, kStartSamples);
    samples.events.reset();  // of another motion than the command's answer, into which they may be copied
    request["start"] = {{"period", start.guess->period()}, {"trajectory", write_fields(samples)}};
  }
  if (!start.deadline.endless()) request["seconds"] = start.deadline.left();
  return json_text(request) + "\n";
}

namespace {

/// What `read` makes of the answer. \throws SolveFailure
template <class Read>
auto read_answer(const std::string& output, const Read& read) {
  try {
    const Json json = parse_json(output);
    if (!json.is_object()) refuse("no JSON object");
    return read(json);
  } catch (const nlohmann::json::exception& error) {
    const std::string what = error.what();  // "[json.exception...] key 'verdict' not found"
    refuse(one_line(what.substr(what.find("] ") + 2), 200));
  } catch (const BadRecord& error) {
    refuse(error.what());
  }
}

}  // namespace

CommandAnswer read_command_answer(const std::string& output, double period) {
  return read_answer(output, [&](const Json& json) {
    return CommandAnswer{.solution = read_solution(json, period), .seconds = read_seconds(json)};
  });
}

BranchDiagram read_command_curve(const std::string& output, const ParametrisedScene& scene, int contacts,
                                 const CurveLimits& limits) {
  return read_answer(output, [&](const Json& json) {
    const ExchangedCurve curve = curve_from_json(json);
    BranchDiagram diagram = diagram_of(curve, scene, contacts, limits);
    diagram.seconds = curve.seconds;
    return diagram;
  });
}

}  // namespace signorini
