// Scene by scene, and record by record.

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <variant>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/resolution_study.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// Time of the cheapest run that reaches an error, and that run.
Cell reached_cell(const Evaluation& evaluation, const ResolutionStudy& study, double error) {
  const CurvePoint point = cost_to_error(study, time_axis(), error);
  if (point.run != nullptr)
    return {time_text(point.cost), point.cost, evaluation.place_of(*point.run->result)};
  return {reaching_run(study, error) != nullptr ? "not timed" : "not reached", kNeverReached};
}

std::vector<Cell> study_row(const Evaluation& evaluation, const ResolutionStudy& study) {
  const CaseResult& first = *study.runs.front().result;
  const std::string law = first.law != nullptr ? law_text(*first.law) : in_place(first.outcome.status);
  OutcomeCounts counts;
  for (const ScoredRun& run : study.runs) counts.add(run.result->outcome);
  std::string motions = stability_text(counts.stable, counts.unstable, counts.certified);
  if (evaluation.is_contact_free(study.scene)) motions += ", a motion without contact solves it";
  std::vector<Cell> row{study.scene, study.configuration, law,
                        count_cell(solved_runs(study), std::ssize(study.runs)), std::move(motions)};
  for (const double error : kErrorLevels) row.push_back(reached_cell(evaluation, study, error));
  return row;
}

/// Fills the table of a section with the studies of the scene's law, or of others.
Section with_studies(const Evaluation& evaluation, bool another_law, Section section) {
  section.table.header = {"scene", "method", "represents", "solved", "stability"};
  for (const double error : kErrorLevels) section.table.header.push_back(fmt::format("{:.0e}", error));
  Rows rows(section, "all are in measures.csv");
  for (const ResolutionStudy& study : evaluation.studies()) {
    if ((study.eligibility == Eligibility::another_law) == another_law)
      rows.add([&] { return study_row(evaluation, study); });
  }
  rows.close();
  return section;
}

/// The law that the method represents, marked where it is not the scene's.
std::string represented_text(const Record& record) {
  if (!record.law) return in_place(record);
  return law_text(*record.law) + (has_another_law(outcome_of(record)) ? " ≠ scene" : "");
}

/// Two digits of a measure that not every answer has.
Cell measure_cell(const Record& record, const Measure& measure, const std::string& missing = "-") {
  return claim_of(record) ? number_cell(measure, "{:.1e}", missing) : Cell(in_place(record), kNeverReached);
}

/// The error of the contact force where it is a function, marked; else that of force and impulses, in records
/// of earlier versions of the impulse alone.
Cell force_error_cell(const Record& record) {
  const Errors& errors = record.errors;
  const Measure& error = errors.force_l2 ? errors.force_l2 : errors.force ? errors.force : errors.impulse;
  if (!claim_of(record) || !error) return measure_cell(record, error);
  return {bounded_text(*error, record) + (record.errors.force_l2 ? " (L2)" : ""), *error};
}

/// "0.5", or "0.79 to 0.81": the coefficients that the impacts show where the scene has a law of impact.
Cell restitution_cell(const Record& record) {
  if (!claim_of(record)) return {in_place(record), kNeverReached};
  const std::vector<double>& found = record.physics.effective_restitution;
  const bool impacts = record.scene_law && std::holds_alternative<Restitution>(*record.scene_law);
  if (!impacts || found.empty()) return {"-", kNeverReached};
  const auto [least, largest] = std::ranges::minmax(found);
  const std::string low = fmt::format("{:.2f}", least), high = fmt::format("{:.2f}", largest);
  return {low == high ? low : low + " to " + high, least};
}

/// Median time of a converged run; a wrong answer has no time. Else the status or the reason.
Cell median_time_cell(const Record& record) {
  if (record.status != Status::converged) return {in_place(record), kNeverReached};
  if (!record.seconds)
    return {record.not_timed.empty() ? "not timed" : "not timed: " + record.not_timed, kNeverReached};
  const Seconds& seconds = *record.seconds;
  const char* const remark = seconds.unsteady == true   ? " (unsteady)"
                             : seconds.unstable == true ? " (unstable)"
                                                        : "";
  return {time_text(seconds.median) + remark + (seconds.load.value_or(0.0) > 1.0 ? " (loaded)" : ""),
          seconds.median};
}

/// Of a converged run, the first set-up and solve of a process.
Cell first_cell(const Record& record) {
  if (record.status != Status::converged) return {in_place(record), kNeverReached};
  return time_cell(record.seconds ? record.seconds->first : Measure());
}

/// "12 p, 3 it, 186 points": pivots, iterations and points of a curve.
std::string work_text(const Record& record) {
  const Work& work = record.work.counts;
  std::vector<std::string> counts;
  for (const auto& [count, unit] :
       {std::pair{work.pivots, "p"}, std::pair{work.iterations, "it"}, std::pair{work.points, "points"}})
    if (count) counts.push_back(fmt::format("{} {}", *count, unit));
  if (!counts.empty()) return joined(counts, ", ");
  return claim_of(record) ? "not counted" : in_place(record);
}

std::vector<Cell> case_row(const Evaluation& evaluation, const CaseResult& result) {
  const Record record = evaluation.record_of(result);
  return {
      record.scene,
      record.scene_law ? law_text(*record.scene_law) : "not recorded",
      resolution_of(record),
      represented_text(record),
      std::string(status_name(record.status)),
      Cell(error_text(record), bounded_error(result).value_or(kNeverReached), evaluation.place_of(result)),
      measure_cell(record, record.errors.x_l2_scene),
      force_error_cell(record),
      measure_cell(record, record.physics.penetration),
      measure_cell(record, record.physics.complementarity),
      restitution_cell(record),
      measure_cell(record, record.physics.energy_defect, "not defined"),
      median_time_cell(record),
      first_cell(record),
      work_text(record),
      orbit_text(record)};
}

/// Why a run did not converge or is not certified.
std::string remark(const Record& record) {
  const std::string& why = claim_of(record) == Claim::unproven ? record.certificate.reason : record.message;
  return why.empty() ? "no message" : why;
}

}  // namespace

Sections scene_sections(const Evaluation& evaluation) {
  return {with_studies(evaluation, false,
                       {.id = "scenes",
                        .kind = SectionKind::scenes,
                        .title = "Time to error, scene by scene",
                        .text = "The time of the cheapest run whose error is at most that of the column. "
                                "Solved: resolutions whose answer is certified."})};
}

Sections other_law_sections(const Evaluation& evaluation) {
  return {with_studies(evaluation, true,
                       {.id = "other-laws",
                        .kind = SectionKind::scenes,
                        .title = "Methods that represent another law",
                        .text = "They solve another problem than the scene states: errors are those against "
                                "the motion under their own law; they are in no ranking."})};
}

Sections case_sections(const Evaluation& evaluation) {
  Section section{.id = "cases",
                  .kind = SectionKind::cases,
                  .title = "Every case",
                  .note = R"(error of x: relative L2 distance to the certified orbit of the law that
the method represents; `<`: below ten error bars of that orbit. `≠ scene`: the method represents another impact
law than the scene states; then `off the scene's motion` is the same distance to the motion from rest under the
scene's own law. error of force: of force and impulses with their instants, the worst contact, relative to the orbit's
largest; of the force itself in the mean square (L2) where it is a function of time. Times to an error ask for x, the
worst contact and the force. penetration and complementarity are relative
to the amplitude. restitution: speed after over speed before the impacts, as the answer shows it, least to largest.
time: set-up and solve, the fastest repetition within a round, the median over rounds;
unstable where rounds deviate by more than 5 % in the median, unsteady where they differ by more than 25 % however
often they are taken, loaded where other programs took time from them. first: set-up and solve as the first of a process,
the median over rounds. p: pivots, it:
iterations (event-driven: periods marched or Newton steps), points: of the curve that was followed to the answer.
orbit: same as reached from rest under the represented
law, or another one; stable where all Floquet multipliers lie inside the unit circle, unstable where one lies outside;
without contact where it touches nothing. The orbits are exact ones,
polished from each answer and followed by CVODE for a period; where there is none, they come from the event-driven
method by shooting at tolerance 1e-12. These two methods are judged by related computations: exact-orbit by a second
evaluation of its orbit, and by CVODE to about 1e-10.)"};
  section.table.header = split(
      "scene|law|method|represents|status|error of x|off the scene's motion|error of "
      "force|penetration|complementarity|restitution|energy defect|time|first|pivots, iterations|orbit",
      '|');
  Rows rows(section, "all are in table.csv");
  for (const CaseResult& result : evaluation.results())
    rows.add([&] { return case_row(evaluation, result); });
  rows.close();
  return {std::move(section)};
}

Sections remark_sections(const Evaluation& evaluation) {
  Section section{.id = "otherwise", .kind = SectionKind::remarks, .title = "Failures and other outcomes"};
  section.table.header = {"case", "status", "why"};
  Rows rows(section, "all are in table.csv");
  for (const CaseResult& result : evaluation.results()) {
    const std::optional<Claim> claim = claim_of(result.outcome);
    if (claim == Claim::certified) continue;
    rows.add([&] {
      const std::string status =
          claim == Claim::unproven ? "uncertified" : std::string(status_name(result.outcome.status));
      return std::vector<Cell>{result.case_id, status, remark(evaluation.record_of(result))};
    });
  }
  rows.close();
  return {std::move(section)};
}

}  // namespace signorini
