#include "harness/sweep/bifurcation_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/plan/scene_choice.hpp"
#include "harness/sweep/branch_json.hpp"
#include "harness/sweep/frequency_response.hpp"
#include "harness/text/words.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "methods/orbit/family/orbit_family.hpp"
#include "problems/scene/varied_scene.hpp"

namespace signorini {

namespace {

constexpr SpecialKind kFollowedKinds[] = {SpecialKind::fold,           SpecialKind::period_doubling,
                                          SpecialKind::neimark_sacker, SpecialKind::phase_resonance,
                                          SpecialKind::grazing,        SpecialKind::contact_change};

SpecialKind followed_kind(const std::string& name) {
  std::vector<std::string> names;
  for (const SpecialKind kind : kFollowedKinds)
    if (names.emplace_back(describe(kind)) == name) return kind;
  throw UsageError(fmt::format("follow = {} (must be {})", name, joined(names, ", ")));
}

// What is constant in the load stays, as weights do.
Problem with_load_factor(Problem problem, double factor) {
  for (ForceTerm& term : problem.force) {
    if (term.harmonic == 0) continue;
    term.cos *= factor;
    term.sin *= factor;
  }
  for (FrameTerm& term : problem.frame) {
    term.cos *= factor;
    term.sin *= factor;
  }
  return problem;
}

// The scene at values of the second number.
std::function<Problem(double)> varied(const SceneSource& source, const SecondParameter& second) {
  if (second.place == kLoadFactor) {
    for (const auto& [name, value] :
         {std::pair("second-from", second.from), std::pair("second-to", second.to)}) {
      if (!(value > 0.0)) throw UsageError(fmt::format("{} = {} (must be above 0)", name, value));
    }
    return [problem = read_scene(source).problem](double value) { return with_load_factor(problem, value); };
  }
  const auto scene = std::make_shared<const VariedScene>(source, second.place);
  for (const double end : {second.from, second.to}) (void)scene->at(end);  // refuses what is no scene
  return [scene](double value) { return scene->unchecked(value); };
}

ScenePlane plane_of(const SceneSource& source, double from, double to, const SecondParameter& second) {
  require_frequency("from", from);
  require_frequency("to", to);
  if (second.place == kFrequency)
    throw UsageError(fmt::format("second = {} (must be another number than the frequency)", second.place));
  require_interval("second-from", second.from, "second-to", second.to);
  return {.at = [scene = varied(source, second), from,
                 to](double value) { return over_frequency(scene(value), from, to); },
          .second = second.place,
          .from = second.from,
          .to = second.to};
}

}  // namespace

BranchDiagram bifurcation_response(const SceneSource& source, double from, double to,
                                   const SecondParameter& second, const std::string& kind,
                                   const MethodChoice& method, const CurveLimits& limits) {
  const SpecialKind followed = followed_kind(kind);
  const ScenePlane plane = plane_of(source, from, to, second);
  require_curve(plane.at(second.from), method);
  CurveLimits asked = limits;
  asked.stopped = interrupted;
  auto curves = method.make()->curve()->follow_bifurcations(plane, followed, asked);
  if (!curves)
    throw UsageError(fmt::format("methods = {} (must follow special points over two numbers, as {} does)",
                                 method.label(), exact_method().name));
  return *std::move(curves);
}

ParameterRange backbone_band(const SceneSource& source) {
  const Problem problem = read_scene(source).problem;
  if (const std::string obstacle = continuation_obstacle(problem); !obstacle.empty())
    throw UsageError(fmt::format("scene = {} (must be one that is followed: {})", problem.name, obstacle));
  const auto band = free_motion_band(with_load_factor(problem, 0.0));
  if (!band) throw UsageError("--from and --to are required without contacts or springs that hold the scene");
  return *band;
}

nlohmann::ordered_json bifurcation_json(const BranchDiagram& curves, const std::string& kind,
                                        const std::string& second) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Branch& curve : curves.branches) {
    Json points = Json::array();
    for (const SolutionPoint& one : curve.points) {
      Json point = to_json(one);
      if (followed_kind(kind) != SpecialKind::phase_resonance) {  // of a change of stability it is rounding
        point.erase("stable");
        point.erase("stability");
      }
      points.push_back(std::move(point));
    }
    list.push_back({{"kind", kind},
                    {"sequence", curve.sequence},
                    {"points", points},
                    {"began", curve.began},
                    {"ended", curve.ended}});
  }
  return {{"parameter", kFrequency}, {"second", second}, {"curves", list}, {"unfinished", curves.unfinished}};
}

Table bifurcation_table(const BranchDiagram& curves, const std::string& kind, const std::string& second) {
  Table table;
  table.header = {"curve",   "kind",      "omega [rad/s]", second, "order",
                  "impacts", "x max [m]", "amplitude [m]", "mark"};
  const bool damped = followed_kind(kind) == SpecialKind::phase_resonance;
  for (const char* title : {"damping ratio", "stability"})
    if (damped) table.header.insert(table.header.end() - 1, title);
  for (std::size_t c = 0; c < curves.branches.size(); ++c) {
    const Branch& curve = curves.branches[c];
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const SolutionPoint& point = curve.points[i];
      const bool first = i == 0, last = i + 1 == curve.points.size();
      std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{
          number_cell(static_cast<double>(c)), kind, number_cell(point.frequency),
          number_cell(point.second.value_or(std::nan(""))), number_cell(point.order),
          number_cell(point.impacts), largest_cell(point.x_max), largest_cell(point.amplitude),
          last    ? "ends: " + curve.ended
          : first ? "begins: " + curve.began
                  : std::string()});
      if (!damped) continue;
      row.insert(row.end() - 1, {number_cell(point.damping_ratio), Cell(describe(point.stability))});
    }
  }
  return table;
}

}  // namespace signorini
