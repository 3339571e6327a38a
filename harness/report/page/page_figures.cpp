#include "harness/report/page/page_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "harness/plan/plan.hpp"
#include "harness/report/document/cells.hpp"
#include "harness/report/figures/drawn_waveform.hpp"
#include "harness/report/figures/kept_motions.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/schematic/svg.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/scene_layout.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// With as many digits as a figure shows.
double rounded(double value) { return std::stod(fmt::format("{:.4g}", value)); }

Json rounded(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(rounded(value));
  return list;
}

std::string label_of_study(const ResolutionStudy& study) {
  const Record& record = *study.runs.front().record;
  if (study.eligibility != Eligibility::another_law || !record.law) return study.configuration;
  return fmt::format("{} ({})", study.configuration, law_text(*record.law));
}

/// A study's part of work_precision_data; null without a run that has both error and time.
Json study_data(const Evaluation& evaluation, const ResolutionStudy& study) {
  Json marks = Json::array(), curve = Json::array();
  std::vector<const ScoredRun*> marked;
  for (const ScoredRun& run : study.runs) {
    const std::optional<double> seconds = time_axis().cost(*run.record);
    if (!run.error || !seconds) continue;
    marked.push_back(&run);
    marks.push_back({rounded(*seconds), rounded(*run.error), evaluation.place_of(*run.record),
                     run.bounded ? 1 : 0, resolution_of(*run.record)});
  }
  if (marked.empty()) return {};
  for (const CurvePoint& point : pareto_curve(study, time_axis())) {
    const auto found = std::ranges::find(marked, point.run->record, &ScoredRun::record);
    if (found != marked.end()) curve.push_back(found - marked.begin());
  }
  return {{"c", evaluation.place_of(study.configuration)},
          {"label", label_of_study(study)},
          {"marks", std::move(marks)},
          {"curve", std::move(curve)}};
}

Json signals(const Waveform& motion, std::size_t place) {
  return {{"t", rounded(motion.t)},
          {"x", rounded(motion.x[place])},
          {"v", rounded(motion.velocity[place])},
          {"f", rounded(motion.force[place])},
          {"p", rounded(motion.impulse[place])}};
}

}  // namespace

Json work_precision_data(const Evaluation& evaluation, const std::string& scene) {
  Json own = Json::array(), other = Json::array();
  double floor = 0.0;
  for (const ResolutionStudy& study : evaluation.studies()) {
    if (study.scene != scene) continue;
    const bool another_law = study.eligibility == Eligibility::another_law;
    Json data = study_data(evaluation, study);
    if (data.is_null()) continue;
    for (const ScoredRun& run : study.runs)
      if (run.error && !another_law) floor = std::max(floor, measurable_error(*run.record));
    (another_law ? other : own).push_back(std::move(data));
  }
  if (own.empty() && other.empty()) return {};
  return {{"floor", rounded(floor)}, {"own", std::move(own)}, {"other", std::move(other)}};
}

Json motion_data(const Evaluation& evaluation, const std::string& scene) {
  const KeptMotions kept = kept_motions(evaluation, scene);
  if (kept.answers.empty()) return {};
  Json answers = Json::array();
  for (const auto& [record, place, motion] : kept.answers) {
    Json answer{{"c", evaluation.place_of(configuration_of(*record))},
                {"record", evaluation.place_of(*record)},
                {"label", resolution_of(*record)}};
    answer.update(signals(motion, place));
    answers.push_back(std::move(answer));
  }
  Json data{{"contact", kept.contact},
            {"orbit", signals(kept.orbit(), kept.place)},
            {"answers", std::move(answers)}};
  if (const std::optional<double> stop = stop_position(*kept.leader, kept.place))
    data["stop"] = rounded(*stop);
  return data;
}

Json schematic_data(const Evaluation& evaluation, const std::string& scene) {
  const auto record = std::ranges::find(evaluation.records(), scene, &Record::scene);
  // A name of the catalogue, and no path: records may come from anywhere.
  const bool is_name =
      std::ranges::all_of(
          scene, [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '@' || c == '.'; }) &&
      !scene.ends_with(".toml");
  if (record == evaluation.records().end() || !is_name || record->coordinates.value_or(0) > kMostDrawn)
    return {};
  try {
    const SceneSource source = find_scene(scene);
    const Scene found = read_scene(source);
    if (found.sha256 != record->scene_sha256) return {};
    return svg_of(schematic(found.problem, load_layout(source)));
  } catch (const SceneError&) {
    return {};
  }
}

Json profile_data(const Evaluation& evaluation, std::size_t number) {
  const RankingGroup& group = evaluation.groups()[number];
  Json panels = Json::array();
  for (const double error : kProfileErrors) {
    const PerformanceProfile profile = performance_profile(costs_to_error(group, time_axis(), error));
    Json curves = Json::array();
    for (std::size_t c = 0; c < group.configurations.size(); ++c) {
      if (profile.ratios[c].empty()) continue;
      Json steps = Json::array();
      for (const double ratio : profile.ratios[c])
        steps.push_back({rounded(ratio), rounded(profile.share(c, ratio))});
      curves.push_back({{"c", evaluation.place_of(group.configurations[c])},
                        {"label", group.configurations[c]},
                        {"steps", std::move(steps)}});
    }
    panels.push_back({{"error", error}, {"curves", std::move(curves)}});
  }
  return panels;
}

}  // namespace signorini
