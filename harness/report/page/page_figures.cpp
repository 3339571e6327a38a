#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "harness/plan/plan.hpp"
#include "harness/report/figures/drawn_waveform.hpp"
#include "harness/report/page/page_parts.hpp"
#include "harness/schematic/drawing.hpp"
#include "harness/schematic/schematic.hpp"
#include "harness/text/words.hpp"
#include "problems/scene/scene_file.hpp"
#include "problems/scene/scene_layout.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// Of a profile over more scenes than this, steps below its share of them are drawn with the next one: they
/// are less than a pixel.
constexpr std::size_t kManySteps = 2000;

constexpr int kDigits = 4;  // of numbers that a figure shows

/// A study's part of work_precision_data; null without a run that has both error and time.
Json study_data(const Evaluation& evaluation, const ResolutionStudy& study) {
  Json marks = Json::array(), curve = Json::array();
  std::vector<const ScoredRun*> marked;
  for (const ScoredRun& run : study.runs) {
    const std::optional<double> seconds = time_axis().cost(*run.result);
    if (!run.error || !seconds) continue;
    marked.push_back(&run);
    marks.push_back({rounded(*seconds, kDigits), rounded(*run.error, kDigits),
                     evaluation.place_of(*run.result), run.bounded ? 1 : 0, run.result->choice->resolution});
  }
  if (marked.empty()) return {};
  for (const CurvePoint& point : pareto_curve(study, time_axis())) {
    const auto found = std::ranges::find(marked, point.run->result, &ScoredRun::result);
    if (found != marked.end()) curve.push_back(found - marked.begin());
  }
  return {{"c", evaluation.place_of(study.configuration)},
          {"label", label_of(study)},
          {"marks", std::move(marks)},
          {"curve", std::move(curve)}};
}

Json signals(const Waveform& motion, std::size_t place) {
  return {{"t", rounded(motion.t, kDigits)},
          {"x", rounded(motion.x[place], kDigits)},
          {"v", rounded(motion.velocity[place], kDigits)},
          {"f", rounded(motion.force[place], kDigits)},
          {"p", rounded(motion.impulse[place], kDigits)}};
}

}  // namespace

Json work_precision_data(const Evaluation& evaluation, const std::string& scene) {
  Json own = Json::array(), other = Json::array();
  double floor = 0.0;
  for (const ResolutionStudy& study : evaluation.studies_of(scene)) {
    const bool another_law = study.eligibility == Eligibility::another_law;
    Json data = study_data(evaluation, study);
    if (data.is_null()) continue;
    for (const ScoredRun& run : study.runs)
      if (run.error && !another_law) floor = std::max(floor, run.result->measurable);
    (another_law ? other : own).push_back(std::move(data));
  }
  if (own.empty() && other.empty()) return {};
  return {{"floor", rounded(floor, kDigits)}, {"own", std::move(own)}, {"other", std::move(other)}};
}

Json motion_data(const Evaluation& evaluation, const std::string& scene) {
  const KeptMotions kept = kept_motions(evaluation, scene);
  if (kept.answers.empty()) return {};
  Json answers = Json::array();
  for (const auto& [result, place, motion] : kept.answers) {
    Json answer{{"c", evaluation.place_of(result->choice->configuration)},
                {"record", evaluation.place_of(*result)},
                {"label", result->choice->resolution}};
    answer.update(signals(motion, place));
    answers.push_back(std::move(answer));
  }
  Json data{{"contact", kept.contact},
            {"orbit", signals(kept.orbit(), kept.place)},
            {"answers", std::move(answers)}};
  if (const std::optional<double> stop = stop_position(*kept.leader, kept.place))
    data["stop"] = rounded(*stop, kDigits);
  return data;
}

Json schematic_data(const Evaluation& evaluation, const std::string& scene) {
  const std::span<const CaseResult> results = evaluation.results_of(scene);
  // A name of the catalogue, and no path: records may come from anywhere.
  const bool is_name =
      std::ranges::all_of(
          scene, [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '@' || c == '.'; }) &&
      !scene.ends_with(".toml");
  if (results.empty() || !is_name || results.front().scene->coordinates.value_or(0) > kMostDrawn) return {};
  try {
    const SceneSource source = find_scene(scene);
    // Before it is assembled: the record may name any scene, and say any number of coordinates.
    const SceneOutline outline = load_outline(source);
    if (outline.coordinates > kMostDrawn) return {};
    if (digest_of(source) != evaluation.record_of(results.front()).scene_sha256) return {};
    return svg_of(schematic(load_scene(source), outline.layout, outline.damped_stops));
  } catch (const SceneError&) {
    return {};
  }
}

Json profile_data(const Evaluation& evaluation, std::size_t number) {
  const RankingGroup& group = evaluation.groups()[number];
  Json panels = Json::array();
  for (const double error : kProfileErrors) {
    const PerformanceProfile profile = performance_profile(costs_to_error(group, time_axis(), error));
    const bool many = profile.scenes > kManySteps;
    Json curves = Json::array();
    for (std::size_t c = 0; c < group.configurations.size(); ++c) {
      if (profile.ratios[c].empty()) continue;
      Json steps = Json::array();
      double drawn = 0.0;
      for (const double ratio : profile.ratios[c]) {
        const double share = profile.share(c, ratio);
        if (many && share - drawn < 1.0 / kManySteps && ratio < profile.ratios[c].back()) continue;
        drawn = share;
        steps.push_back({rounded(ratio, kDigits), rounded(share, kDigits)});
      }
      curves.push_back({{"c", evaluation.place_of(group.configurations[c])},
                        {"label", group.configurations[c]},
                        {"steps", std::move(steps)}});
    }
    panels.push_back({{"error", error}, {"curves", std::move(curves)}});
  }
  return panels;
}

}  // namespace signorini
