#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <map>
#include <sstream>
#include <type_traits>

#include "harness/records/json_fields.hpp"
#include "harness/records/record_json.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/case_result.hpp"
#include "harness/report/evaluation/resolution_study.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/table.hpp"

namespace signorini {

namespace {

/// Why cells of a row are empty, and other remarks on it; empty cells without a reason are of what does not
/// exist for this run.
std::string csv_reason(const Record& record) {
  if (!claim_of(record)) return fmt::format("{}: {}", status_name(record.status), record.message);
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
  return text;
}

/// The text of a field that has one: numbers, words, laws; empty where there is none.
struct FieldText {
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(double value) const { return fmt::format("{:.9e}", value); }
  std::string operator()(std::integral auto value) const { return std::to_string(value); }
  std::string operator()(const RepresentedLaw& law) const { return law_text(law); }
  template <class Enum>
  requires std::is_enum_v<Enum> std::string operator()(Enum value) const {
    return std::string(enum_name(value));
  }
  template <class T>
  requires std::invocable<FieldText, const T&> std::string operator()(const std::optional<T>& value) const {
    return value ? (*this)(*value) : std::string();
  }
};

/// Adds the texts of an object's fields by their path, "errors.x_l2". Lists and objects without a text of
/// their own, waveforms say, are left out.
template <class T>
void collect_texts(const std::string& path, const T& value, std::map<std::string, std::string>& texts) {
  if constexpr (Visited<T>) {
    visit_fields(value, [&](const Field& field, const auto& member) {
      collect_texts(path.empty() ? field.name : path + "." + field.name, member, texts);
    });
  } else if constexpr (std::invocable<FieldText, const T&>) {
    texts[path] = FieldText{}(value);
  } else if constexpr (requires {
                         typename T::value_type;
                         *value;
                         value.has_value();
                       }) {
    if constexpr (Visited<typename T::value_type>) {
      if (value) collect_texts(path, *value, texts);
    }
  }
}

/// Columns of table.csv in order: a title, and behind "=" the path of the field that it shows where that has
/// another name. Two of them are no fields: kResolution and kReason.
constexpr const char* kResolution = "resolution";
constexpr const char* kReason = "reason";
constexpr const char* kColumns = R"(case scene scene_law method resolution law law_matches_scene status period
x_l2=errors.x_l2 x_max=errors.x_max u_l2=errors.u_l2 velocity_l2=errors.velocity_l2 impulse=errors.impulse
force_l2=errors.force_l2 x_l2_scene=errors.x_l2_scene error_bar=certificate.error_bar
penetration=physics.penetration complementarity=physics.complementarity energy_defect=physics.energy_defect
contact_ratio=physics.contact_ratio seconds_min=seconds.min seconds_median=seconds.median
seconds_mad=seconds.mad seconds_setup=seconds.setup seconds_solve=seconds.solve unknowns=work.unknowns
iterations=work.iterations pivots=work.pivots rhs_evaluations=work.rhs_evaluations
factorisations=work.factorisations points=work.points peak_memory_bytes=work.peak_memory_bytes condition
certificate=certificate.status orbit=certificate.orbit same_orbit=certificate.same_orbit problem
stable=certificate.stable return_distance=certificate.return_distance x_worst=errors.x_worst force=errors.force
reason)";

struct CsvColumn {
  std::string title, field;
};

const std::vector<CsvColumn>& csv_columns() {
  static const std::vector<CsvColumn> columns = [] {
    std::vector<CsvColumn> found;
    std::istringstream words(kColumns);
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      found.push_back({word.substr(0, equals), word.substr(equals + 1)});  // npos + 1 is 0: the whole word
    }
    return found;
  }();
  return columns;
}

std::vector<Cell> csv_row(const Record& record) {
  std::map<std::string, std::string> texts;
  collect_texts("", record, texts);
  texts.emplace(kResolution, resolution_of(record));
  texts.emplace(kReason, csv_reason(record));
  std::vector<Cell> row;
  for (const CsvColumn& column : csv_columns()) row.emplace_back(texts[column.field]);
  return row;
}

}  // namespace

void csv_report(const Evaluation& evaluation, const TextSink& sink) {
  std::vector<Cell> header;
  for (const CsvColumn& column : csv_columns()) header.emplace_back(column.title);
  sink(csv_line(header));
  for (const CaseResult& result : evaluation.results()) sink(csv_line(csv_row(evaluation.record_of(result))));
}

void measures_csv(const Evaluation& evaluation, const TextSink& sink) {
  std::vector<Cell> header{"scene", "method", "law", "standing", "runs", "solved"};
  for (const double error : kErrorLevels) header.emplace_back(fmt::format("seconds_to_{:.0e}", error));
  sink(csv_line(header));
  for (const ResolutionStudy& study : evaluation.studies()) {
    const RepresentedLaw* law = study.runs.front().result->law;
    std::vector<Cell> row{study.scene,
                          study.configuration,
                          law != nullptr ? law_text(*law) : "not recorded",
                          std::string(enum_name(study.eligibility)),
                          count_cell(std::ssize(study.runs)),
                          count_cell(solved_runs(study))};
    for (const double error : kErrorLevels) {
      const double seconds = cost_to_error(study, time_axis(), error).cost;
      row.emplace_back(std::isfinite(seconds) ? fmt::format("{:.9e}", seconds) : "inf");
    }
    sink(csv_line(row));
  }
}

}  // namespace signorini
