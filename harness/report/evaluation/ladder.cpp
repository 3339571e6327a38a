#include "harness/report/evaluation/ladder.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

#include "harness/plan/selection.hpp"

namespace signorini {

namespace {

std::optional<double> as_double(const std::optional<long>& count) {
  if (!count) return std::nullopt;
  return static_cast<double>(*count);
}

bool is_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && end == text.c_str() + text.size();
}

Standing standing_of(const std::vector<Rung>& rungs) {
  const auto other = [](const Rung& rung) { return rung.record->law_matches_scene == false; };
  if (std::any_of(rungs.begin(), rungs.end(), other)) return Standing::another_law;
  const auto refuses = [](const Rung& rung) { return rung.record->status == Status::not_applicable; };
  return std::all_of(rungs.begin(), rungs.end(), refuses) ? Standing::not_applicable : Standing::competes;
}

}  // namespace

const CostAxis& time_axis() {
  static const CostAxis axis{"time", "s", [](const Record& record) -> std::optional<double> {
                               if (!record.seconds) return std::nullopt;
                               return record.seconds->median;
                             }};
  return axis;
}

std::span<const CostAxis> work_axes() {
  static const std::array<CostAxis, 5> axes{
      CostAxis{"pivots", "", [](const Record& r) { return as_double(r.work.counts.pivots); }},
      CostAxis{"iterations", "", [](const Record& r) { return as_double(r.work.counts.iterations); }},
      CostAxis{"right-hand sides", "",
               [](const Record& r) { return as_double(r.work.counts.rhs_evaluations); }},
      CostAxis{"factorisations", "", [](const Record& r) { return as_double(r.work.counts.factorisations); }},
      CostAxis{"unknowns", "", [](const Record& r) { return as_double(r.work.counts.unknowns); }}};
  return axes;
}

std::string resolution_of(const Record& record) {
  const std::size_t slash = record.case_id.find('/');
  return slash == std::string::npos ? record.method : record.case_id.substr(slash + 1);
}

std::vector<std::string> settings_of(const Record& record) {
  const std::string resolution = resolution_of(record);
  const std::size_t open = resolution.find('[');
  std::vector<std::string> settings;
  if (open == std::string::npos) return settings;
  const std::size_t close = resolution.rfind(']');
  for (std::size_t begin = open + 1; begin < close;) {
    const std::size_t end = std::min(resolution.find(',', begin), close);
    settings.push_back(resolution.substr(begin, end - begin));
    begin = end + 1;
  }
  return settings;
}

bool is_numeric(const std::string& setting) { return is_number(setting.substr(setting.find('=') + 1)); }

std::string contestant_of(const Record& record) {
  const std::string resolution = resolution_of(record);
  std::string words;
  for (const std::string& setting : settings_of(record)) {
    const bool warm = setting.starts_with(std::string(kStartSetting) + "=");
    if (warm || !is_numeric(setting)) words += (words.empty() ? "" : ",") + setting;
  }
  return resolution.substr(0, resolution.find('[')) + (words.empty() ? "" : "[" + words + "]");
}

Rung rung_of(const Record& record) {
  Rung rung{.record = &record};
  const Certificate& certificate = record.certificate;
  const Measure error = record.errors.x_l2 ? record.errors.x_l2 : record.errors.u_l2;
  if (record.status != Status::converged || certificate.status != CertificateStatus::certified ||
      certificate.same_orbit == false || !error) {
    return rung;
  }
  const double floor = measurable_error(record);
  rung.bounded = *error < floor;
  rung.error = std::max(*error, floor);
  return rung;
}

std::size_t credited_rungs(const Ladder& ladder) {
  return static_cast<std::size_t>(std::count_if(ladder.rungs.begin(), ladder.rungs.end(),
                                                [](const Rung& rung) { return rung.error.has_value(); }));
}

std::vector<Ladder> ladders_of(const std::vector<Record>& records) {
  std::vector<Ladder> ladders;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  for (const Record& record : records) {
    const std::string contestant = contestant_of(record);
    const auto [place, fresh] = places.try_emplace({record.scene, contestant}, ladders.size());
    if (fresh) ladders.push_back({.scene = record.scene, .contestant = contestant});
    ladders[place->second].rungs.push_back(rung_of(record));
  }
  for (Ladder& ladder : ladders) ladder.standing = standing_of(ladder.rungs);
  return ladders;
}

}  // namespace signorini
