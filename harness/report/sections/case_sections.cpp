#include "harness/report/sections/case_sections.hpp"

#include <fmt/format.h>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/work_precision.hpp"

namespace signorini {

namespace {

Cell time_of(const Record& record, double Seconds::*which) {
  const bool timed = record.status == Status::converged && record.seconds;
  return {time_cell(record, which), timed ? (*record.seconds).*which : kNeverReached};
}

/// The value by which rows are sorted.
double error_value(const Record& record) {
  const Measure error = record.errors.x_l2 ? record.errors.x_l2 : record.errors.u_l2;
  return error ? std::max(*error, measurable_error(record)) : kNeverReached;
}

Cell measure_of(std::string text, const Measure& value) {
  return {std::move(text), value.value_or(kNeverReached)};
}

std::vector<Cell> case_row(const Evaluation& evaluation, const Record& record) {
  return {record.scene,
          record.scene_law ? law_text(*record.scene_law) : "not recorded",
          resolution_of(record),
          represented_text(record),
          std::string(status_name(record.status)),
          Cell(error_text(record), error_value(record), evaluation.place_of(record)),
          measure_of(energy_text(record), record.physics.energy_defect),
          time_of(record, &Seconds::min),
          time_of(record, &Seconds::median),
          work_text(record),
          orbit_text(record)};
}

constexpr std::string_view kLegend =
    R"(error of x: relative L2 distance to the certified orbit of the law that
the method represents; `<`: below ten error bars of that orbit. `≠ scene`: the method represents another impact
law than the scene states. time: set-up and solve, the fastest repetition within a round, over rounds;
unstable where rounds deviate by more than 5 % in the median. p: pivots, it:
iterations (event-driven: periods marched or Newton steps). orbit: same as reached from rest under the represented
law, or another one; unstable where a Floquet multiplier lies outside the unit circle. The orbits are exact ones,
polished from each answer and followed by CVODE for a period; where there is none, they come from the event-driven
method by shooting at tolerance 1e-12. Both methods are so judged by their own kin: exact-orbit by a second
evaluation of its orbit, and by CVODE to about 1e-10.)";

/// Why a run did not converge or is not certified; empty for the others.
std::string remark(const Record& record) {
  const bool uncertified = answered(record) && record.certificate.status != CertificateStatus::certified;
  if (record.status == Status::converged && !uncertified) return {};
  const std::string& why = record.status == Status::converged ? record.certificate.reason : record.message;
  return why.empty() ? "no message" : why;
}

}  // namespace

std::vector<Section> case_sections(const Evaluation& evaluation) {
  Section section{
      .id = "cases", .kind = SectionKind::cases, .title = "Every case", .note = std::string(kLegend)};
  section.table.header = {"scene",      "law",           "method",   "represents",  "status",
                          "error of x", "energy defect", "time min", "time median", "pivots, iterations",
                          "orbit"};
  for (const Record& record : evaluation.records())
    section.table.rows.push_back(case_row(evaluation, record));
  return {section};
}

std::vector<Section> remark_sections(const Evaluation& evaluation) {
  Section section{.id = "otherwise", .kind = SectionKind::remarks, .title = "What went otherwise"};
  section.table.header = {"case", "status", "why"};
  for (const Record& record : evaluation.records()) {
    const std::string why = remark(record);
    if (why.empty()) continue;
    const std::string_view status =
        record.status == Status::converged ? "uncertified" : status_name(record.status);
    section.table.rows.push_back({record.case_id, std::string(status), why});
  }
  return {section};
}

}  // namespace signorini
