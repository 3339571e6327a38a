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

/// The words of exchanges.
template <>
struct EnumNames<Verdict> {
  /// In order.
  static constexpr std::array<std::string_view, 2> values{"converged", "not-converged"};
};

/// What a command prints of a solve.
struct AnswerMessage {
  Verdict verdict = Verdict::not_converged;
  std::string message = {};
  std::optional<double> period = {}, residual = {}, condition = {}, seconds = {};
  Work work = {};
  std::optional<TrajectorySamples> trajectory = {};
  std::optional<std::vector<ContactEvent>> events = {};
};

/// The keys of docs/plugins.md.
void visit_fields(Either<AnswerMessage> auto& answer, auto&& field) {
  field(required("verdict"), answer.verdict);
  field(Field{"message"}, answer.message);
  field(Field{"period", "s"}, answer.period);
  field(Field{"residual"}, answer.residual);
  field(Field{"condition"}, answer.condition);
  field(Field{"work"}, answer.work);
  field(Field{"trajectory"}, answer.trajectory);
  field(Field{"events"}, answer.events);
  field(Field{"seconds", "s"}, answer.seconds);
}

namespace {

using Json = nlohmann::ordered_json;
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

/// The instants are redundant, but an answer on others would be misread.
void require_equidistant(const std::vector<double>& t, double period) {
  constexpr double kShare = 1e-6;  // of the period
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double due = static_cast<double>(i) * period / static_cast<double>(t.size());
    if (!(std::abs(t[i] - due) <= kShare * period))
      refuse(fmt::format("trajectory.t[{}] = {} (must be i period / N = {})", i, t[i], due));
  }
}

/// The motion, where there is one. \throws BadRecord, SolveFailure
std::shared_ptr<const Trajectory> motion_of(AnswerMessage& answer, double period) {
  if (!answer.trajectory) return nullptr;
  require_equidistant(answer.trajectory->t, period);
  answer.trajectory->events = std::move(answer.events);  // never those of a motion that it may have copied
  return trajectory_of(period, *answer.trajectory);
}

/// \throws BadRecord, SolveFailure
Solution solution_of(AnswerMessage answer, double period) {
  Solution solution{.verdict = answer.verdict, .message = one_line(answer.message, 400)};
  if (solution.message.empty()) solution.message = "the command gave no message";
  solution.residual = answer.residual;
  solution.condition = answer.condition;
  solution.work = answer.work;
  solution.trajectory = motion_of(answer, answer.period.value_or(period));
  return solution;
}

/// Counts of work: those of a record, none of them negative. \throws BadRecord, SolveFailure
void require_counts(const Json& work) {
  require_known_keys<Work>(work, "work.");
  for (const auto& [key, value] : work.items()) {
    if (!value.is_number() || value.get<double>() < 0.0)
      refuse(fmt::format("work.{} = {} (must be 0 or more)", key, one_line(json_text(value))));
  }
}

/// \throws BadRecord, SolveFailure, or an exception of the JSON library
AnswerMessage read_message(const Json& json) {
  require_known_keys<AnswerMessage>(json);
  if (json.contains("work")) require_counts(json["work"]);
  AnswerMessage answer;
  const bool lists_none = json.contains("events") && json["events"].empty();  // null, too
  if (json.contains("trajectory") && !lists_none) {
    read_fields(json, answer);
  } else {  // of no motion there is neither period nor event, whatever these keys hold
    Json rest = json;
    rest.erase("events");
    if (!json.contains("trajectory")) rest.erase("period");
    read_fields(rest, answer);
    if (lists_none) answer.events.emplace();
  }
  if (!(answer.seconds.value_or(0.0) >= 0.0))
    refuse(fmt::format("seconds = {} (must be 0 or more)", *answer.seconds));
  return answer;
}

}  // namespace

Json command_request(const Problem& problem, const std::vector<OptionEcho>& options) {
  RecordedOptions values;
  for (const OptionEcho& option : options) values.emplace_back(option.name, option.value);
  return {{"schema", 1},
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
    refuse(one_line(error.what(), 400));
  }
}

}  // namespace

CommandAnswer read_command_answer(const std::string& output, double period) {
  return read_answer(output, [&](const Json& json) {
    AnswerMessage answer = read_message(json);
    const std::optional<double> seconds = answer.seconds;
    return CommandAnswer{.solution = solution_of(std::move(answer), period), .seconds = seconds};
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
