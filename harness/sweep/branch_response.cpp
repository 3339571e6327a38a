#include "harness/sweep/branch_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/orbits/orbit_search.hpp"
#include "harness/sweep/branch_json.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "problems/scene/varied_scene.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

Json steps_json(const MethodResponse& response) {
  Json points = Json::array();
  for (const SweepPoint& step : response.steps) {
    points.push_back({{"omega", step.frequency},
                      {"order", response.order},
                      {"amplitude", step.amplitude},
                      {"x_max", step.x_max},
                      {"status", status_name(step.status)},
                      {"stable", step.stable ? Json(*step.stable) : Json()}});
    if (step.status != Status::converged && !step.message.empty()) points.back()["message"] = step.message;
  }
  Json json{{"method", response.method},
            {"points", points},
            {"special", Json::array()},
            {"began", "first frequency"},
            {"ended", "last frequency"}};
  if (!response.other_law.empty()) json["other_law"] = response.other_law;
  return json;
}

std::vector<Cell> row_of(const std::string& method, std::size_t branch, const SolutionPoint& point,
                         const std::string& mark) {
  std::vector<Cell> row{method,
                        number_cell(static_cast<double>(branch)),
                        number_cell(point.parameter),
                        number_cell(point.order),
                        number_cell(point.impacts),
                        largest_cell(point.x_max),
                        largest_cell(point.amplitude),
                        describe(point.stability),
                        mark};
  if (point.energy) row.push_back(number_cell(other_than_parameter(point)));
  return row;
}

// Points at values asked for stand without what is between them.
void add_rows(Table& table, const std::string& method, std::size_t number, const Branch& branch,
              bool at_values) {
  auto special = at_values ? branch.special.end() : branch.special.begin();
  for (std::size_t i = 0; i <= branch.points.size(); ++i) {
    for (; special != branch.special.end() && special->after == i; ++special)
      table.rows.push_back(row_of(method, number, special->point, describe(special->kind)));
    if (i == branch.points.size()) break;
    const bool last = i + 1 == branch.points.size();
    const std::string mark = i == 0 ? "begins: " + branch.began : last ? "ends: " + branch.ended : "";
    table.rows.push_back(row_of(method, number, branch.points[i], at_values ? "" : mark));
  }
}

}  // namespace

ParametrisedScene over_place(const SceneSource& source, const std::string& place, double from, double to) {
  require_interval("from", from, "to", to);
  const auto scene = std::make_shared<const VariedScene>(source, place);
  for (const double end : {from, to}) (void)scene->at(end);  // refuses what is no scene
  return {.parameter = place, .from = from, .to = to, .at = [scene](double value) {
            return scene->unchecked(value);
          }};
}

int default_orders(const Problem& problem, const MethodChoice& method) {
  const bool small = problem.size() <= 10 && highest_load_harmonic(problem) > 0;
  return small && method.entry->exact ? 6 : CurveLimits{}.max_order;
}

bool has_curve(const MethodChoice& method) { return method.make()->curve() != nullptr; }

namespace {

void require_curve(const ParametrisedScene& scene, const MethodChoice& method, const CurveMethod* curve) {
  const Support follows =
      curve == nullptr ? Support{false, "it has no curve of its own"} : curve->follows(scene);
  if (follows.ok) return;
  if (scene.parameter == kEnergy && method.entry->exact)
    throw UsageError(fmt::format(
        "parameter = {} (must be that of motions that keep it, without damping, loss at impacts and periodic "
        "load: {})",
        kEnergy, follows.reason));
  const std::string other =
      scene.parameter == kFrequency ? "be followed with --natural here" : "follow " + scene.parameter;
  throw UsageError(fmt::format("methods = {} (must {}: {})", method.label(), other, follows.reason));
}

}  // namespace

void require_curve(const ParametrisedScene& scene, const MethodChoice& method) {
  require_curve(scene, method, method.make()->curve());
}

std::optional<BranchDiagram> branches_of(const ParametrisedScene& scene, const MethodChoice& method,
                                         const CurveLimits& limits) {
  const std::unique_ptr<Method> made = method.make();
  const CurveMethod* const curve = made->curve();
  if (curve == nullptr) return std::nullopt;
  require_curve(scene, method, curve);
  CurveLimits asked = limits;
  asked.stopped = [&] { return interrupted() || (limits.stopped && limits.stopped()); };
  return curve->follow(scene, asked);
}

std::vector<KnownMotion> searched_motions(const ParametrisedScene& scene, int values, int max_order,
                                          double timeout) {
  const Deadline deadline = Deadline::after(timeout);
  std::vector<KnownMotion> found;
  for (int i = 0; i < values; ++i) {
    const double left = deadline.left() / (values - i);
    if (left <= 0.0 || interrupted()) break;
    // No fraction of the interval that its ends or a resonance would make a special one.
    const double value = scene.from + (i + 0.47) / values * (scene.to - scene.from);
    const Problem problem = scene.at(value);
    if (highest_load_harmonic(problem) == 0) break;
    for (const FoundOrbit& one :
         find_all_orbits(problem, {.starts = 24, .subharmonics = max_order, .timeout = left}).orbits)
      found.push_back({value, one.certified.motion});
  }
  return found;
}

std::vector<ParameterRange> missing(const MethodResponse& response) {
  const std::vector<Branch>& branches = response.diagram.branches;
  // Modes have frequencies where they have them, and none between.
  if (response.diagram.unfinished.empty() && of_free_motions(response.diagram)) return {};
  if (!response.asked || response.at_values || branches.empty()) return {};
  std::vector<ParameterRange> held;
  for (const Branch& branch : branches)
    if (!branch.points.empty()) held.push_back(range_of(branch));
  return uncovered(std::move(held), response.asked->low, response.asked->high);
}

std::string incompleteness(const MethodResponse& response) {
  const std::vector<ParameterRange> left_out = missing(response);
  if (left_out.empty()) return {};
  std::string parts;
  for (const ParameterRange& part : left_out)
    parts += fmt::format("{}from {:.6g} to {:.6g}", parts.empty() ? "" : ", ", part.low, part.high);
  const std::string& reason = response.diagram.unfinished;
  const char* const option = reason.starts_with("limit of")
                                 ? " (--max-branches goes on; --attractors 4 tells what the machine does "
                                   "there)"
                             : reason == "the time is up" ? " (--total-time goes on)"
                             : reason.empty()             ? " (--search looks for more beginnings)"
                                                          : "";
  return fmt::format("{}: INCOMPLETE: no motion {}: {}{}", name_with_law(response), parts,
                     reason.empty() ? "no branch that was found goes there" : reason, option);
}

std::string name_with_law(const MethodResponse& response) {
  return response.method + (response.other_law.empty() ? "" : ", " + response.other_law);
}

Json to_json(const std::vector<MethodResponse>& responses) {
  Json branches = Json::array(), notes = Json::array(), incomplete = Json::array();
  std::string unfinished, parameter(kFrequency);
  for (const MethodResponse& response : responses) {
    for (const Branch& branch : response.diagram.branches)
      branches.push_back(to_json(branch, response.method, response.other_law));
    for (const std::string& note : response.diagram.notes) notes.push_back(note);
    if (!response.steps.empty()) branches.push_back(steps_json(response));
    if (unfinished.empty()) unfinished = response.diagram.unfinished;
    parameter = response.parameter;
    for (const ParameterRange& part : missing(response))
      incomplete.push_back({{"method", response.method},
                            {"from", part.low},
                            {"to", part.high},
                            {"reason", response.diagram.unfinished}});
  }
  return {{"parameter", parameter},
          {"branches", branches},
          {"unfinished", unfinished},
          {"notes", notes},
          {"incomplete", incomplete}};
}

bool of_free_motions(const BranchDiagram& diagram) {
  return std::ranges::any_of(diagram.branches, [](const Branch& branch) {
    return !branch.points.empty() && branch.points.front().energy.has_value();
  });
}

std::string parameter_title(const std::string& parameter) {
  return parameter == kFrequency ? "omega [rad/s]" : parameter == kEnergy ? "energy [J]" : parameter;
}

double other_than_parameter(const SolutionPoint& point) {
  return point.parameter == *point.energy ? point.frequency : *point.energy;
}

Branch points_at(const Branch& branch, const std::vector<double>& values) {
  constexpr double kSame = 1e-10;  // of the largest value on the branch
  double scale = 0.0;
  for (const SolutionPoint& point : branch.points) scale = std::max(scale, std::abs(point.parameter));
  const auto asked_for = [&](const SolutionPoint& point) {
    return std::any_of(values.begin(), values.end(),
                       [&](double value) { return std::abs(point.parameter - value) <= kSame * scale; });
  };
  Branch result = branch;
  std::erase_if(result.points, [&](const SolutionPoint& point) { return !asked_for(point); });
  for (SpecialPoint& special : result.special) {
    const auto before = static_cast<std::ptrdiff_t>(special.after);
    special.after = static_cast<std::size_t>(
        std::count_if(branch.points.begin(), branch.points.begin() + before, asked_for));
  }
  return result;
}

Table branch_table(const std::vector<MethodResponse>& responses, std::size_t first) {
  Table table;
  const std::string parameter = responses.empty() ? std::string(kFrequency) : responses.front().parameter;
  table.header = {"method",        "branch",    parameter_title(parameter),
                  "order",         "impacts",   "x max [m]",
                  "amplitude [m]", "stability", "mark"};
  if (std::ranges::any_of(responses, of_free_motions, &MethodResponse::diagram))
    table.header.push_back(parameter == kEnergy ? "omega [rad/s]" : "energy [J]");
  for (const MethodResponse& response : responses) {
    const std::string name = name_with_law(response);
    for (std::size_t i = 0; i < response.diagram.branches.size(); ++i)
      add_rows(table, name, first + i, response.diagram.branches[i], response.at_values);
    for (const SweepPoint& step : response.steps)
      table.rows.push_back({name, number_cell(0.0), number_cell(step.frequency), number_cell(response.order),
                            "-", largest_cell(step.x_max), largest_cell(step.amplitude), stability_cell(step),
                            std::string(status_name(step.status))});
  }
  for (std::vector<Cell>& row : table.rows) row.resize(table.header.size(), Cell("-"));
  return table;
}

}  // namespace signorini
