#include "harness/report/formats/record_csv.hpp"

#include <fmt/format.h>

#include <cmath>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/work_precision.hpp"
#include "harness/table.hpp"

namespace signorini {

namespace {

std::string number(const Measure& value) { return value ? fmt::format("{:.9e}", *value) : ""; }
std::string number(const std::optional<long>& value) { return value ? std::to_string(*value) : ""; }
std::string yes_no(const std::optional<bool>& value) { return value ? (*value ? "true" : "false") : ""; }

/// Why cells of a row are empty, or what is to be said about it.
std::string csv_reason(const Record& record) {
  if (!answered(record)) return fmt::format("{}: {}", status_name(record.status), record.message);
  std::string text;
  const auto add = [&](const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  };
  if (record.status == Status::inaccurate) add(record.message);
  if (record.certificate.status != CertificateStatus::certified)
    add("uncertified: " + record.certificate.reason);
  if (!record.seconds)
    add("not timed: " + (record.not_timed.empty() ? "no times recorded" : record.not_timed));
  if (!record.certificate.reference_reason.empty())
    add("no reference: " + record.certificate.reference_reason);
  add("other empty cells: the notion does not exist for this run");
  return text;
}

std::vector<Cell> csv_row(const Record& r) {
  const auto seconds = [&](double Seconds::*which) {
    return r.seconds ? number(Measure((*r.seconds).*which)) : "";
  };
  const Work& work = r.work.counts;
  return {r.case_id,
          r.scene,
          r.scene_law ? law_text(*r.scene_law) : "",
          r.method,
          resolution_of(r),
          r.law ? law_text(*r.law) : "",
          yes_no(r.law_matches_scene),
          std::string(status_name(r.status)),
          number(r.period),
          number(r.errors.x_l2),
          number(r.errors.x_max),
          number(r.errors.u_l2),
          number(r.errors.velocity_l2),
          number(r.errors.impulse),
          number(r.errors.x_l2_scene),
          number(r.certificate.error_bar),
          number(r.physics.penetration),
          number(r.physics.complementarity),
          number(r.physics.energy_defect),
          number(r.physics.contact_ratio),
          seconds(&Seconds::min),
          seconds(&Seconds::median),
          seconds(&Seconds::mad),
          seconds(&Seconds::setup),
          seconds(&Seconds::solve),
          number(work.unknowns),
          number(work.iterations),
          number(work.pivots),
          number(work.rhs_evaluations),
          number(work.factorisations),
          number(r.work.peak_memory_bytes),
          number(r.condition),
          std::string(certificate_name(r.certificate.status)),
          r.certificate.orbit.value_or(""),
          yes_no(r.certificate.same_orbit),
          yes_no(r.certificate.stable),
          number(r.certificate.return_distance),
          csv_reason(r)};
}

std::string_view standing_name(Standing standing) {
  switch (standing) {
    case Standing::competes:
      return "competes";
    case Standing::another_law:
      return "another-law";
    case Standing::not_applicable:
      return "not-applicable";
  }
  return "";
}

}  // namespace

std::string csv_report(const Evaluation& evaluation) {
  Table table{{"case",
               "scene",
               "scene_law",
               "method",
               "resolution",
               "law",
               "law_matches_scene",
               "status",
               "period",
               "x_l2",
               "x_max",
               "u_l2",
               "velocity_l2",
               "impulse",
               "x_l2_scene",
               "error_bar",
               "penetration",
               "complementarity",
               "energy_defect",
               "contact_ratio",
               "seconds_min",
               "seconds_median",
               "seconds_mad",
               "seconds_setup",
               "seconds_solve",
               "unknowns",
               "iterations",
               "pivots",
               "rhs_evaluations",
               "factorisations",
               "peak_memory_bytes",
               "condition",
               "certificate",
               "orbit",
               "same_orbit",
               "stable",
               "return_distance",
               "reason"},
              {}};
  for (const Record& record : evaluation.records()) table.rows.push_back(csv_row(record));
  return to_csv(table);
}

std::string measures_csv(const Evaluation& evaluation) {
  Table table{{"scene", "contestant", "law", "standing", "runs", "solved"}, {}};
  for (const double error : kErrorLevels) table.header.push_back(fmt::format("seconds_to_{:.0e}", error));
  for (const Ladder& ladder : evaluation.ladders()) {
    const Record& first = *ladder.rungs.front().record;
    std::vector<Cell> row{ladder.scene,
                          ladder.contestant,
                          first.law ? law_text(*first.law) : "not recorded",
                          std::string(standing_name(ladder.standing)),
                          std::to_string(ladder.rungs.size()),
                          std::to_string(credited_rungs(ladder))};
    for (const double error : kErrorLevels) {
      const double seconds = cost_to_error(ladder, time_axis(), error).cost;
      row.emplace_back(std::isfinite(seconds) ? fmt::format("{:.9e}", seconds) : "inf");
    }
    table.rows.push_back(std::move(row));
  }
  return to_csv(table);
}

}  // namespace signorini
