#include "harness/sweep/branch_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/orbits/orbit_search.hpp"
#include "harness/sweep/branch_json.hpp"
#include "methods/curve_method.hpp"
#include "methods/orbit/continuation/one_impact_orbits.hpp"
#include "methods/orbit/exact_trajectory.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"
#include "problems/scene/varied_scene.hpp"

namespace signorini {

namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

Clock::duration seconds_of(double time) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time));
}

Clock::time_point deadline_of(const BranchLimits& limits) {
  return Clock::now() + seconds_of(limits.timeout);
}

// The answer of exact-orbit at a value of the parameter, if there is one.
std::optional<SequencedOrbit> found_orbit(const OrbitFamily& family, double parameter,
                                          Clock::time_point deadline) {
  const Problem problem = family.scene().at(parameter);
  const auto method = find_method(kFollowedByArcLength).make({});
  if (!method->supports(problem).ok || prefers_reduction(problem)) return std::nullopt;
  const Solution solution = method->prepare(problem)->solve({.guess = {}, .deadline = deadline});
  const auto orbit = std::dynamic_pointer_cast<const ExactTrajectory>(solution.trajectory);
  if (solution.verdict != Verdict::converged || !orbit) return std::nullopt;
  return sequenced(family, orbit->orbit(), orbit->period(), problem.frequency, parameter);
}

// The share `i` of `count` of the interval: no fraction that its ends or a resonance would make a special
// one.
double value_inside(const ParametrisedScene& scene, int i, int count) {
  return scene.from + (i + 0.47) / count * (scene.to - scene.from);
}

// All orbits that a search finds at values spread over the interval.
void add_searched(const OrbitFamily& family, const BranchLimits& limits, Clock::time_point deadline,
                  std::vector<SequencedOrbit>& seeds) {
  constexpr int kStarts = 24;
  for (int i = 0; i < limits.searches && family.driven(); ++i) {
    const std::chrono::duration<double> left = (deadline - Clock::now()) / (limits.searches - i);
    if (left.count() <= 0.0 || interrupted()) break;
    const double value = value_inside(family.scene(), i, limits.searches);
    const Problem problem = family.scene().at(value);
    if (prefers_reduction(problem)) continue;  // whose orbits are those of a reduced structure
    const SceneOrbits found = find_all_orbits(
        problem, {.starts = kStarts, .subharmonics = limits.max_order, .timeout = left.count()});
    for (const FoundOrbit& one : found.orbits) {
      if (one.order > limits.max_order) continue;
      if (const auto orbit = std::dynamic_pointer_cast<const ExactTrajectory>(one.certified.motion))
        seeds.push_back(sequenced(family, orbit->orbit(), orbit->period(), problem.frequency, value));
    }
  }
}

// Orbits on the branches: contact-free motions, answers of exact-orbit, as many as a tenth of the time
// allows, orbits of one impact, and those of searches. All but the first find isolated branches too.
std::vector<SequencedOrbit> seeds_of(OrbitFamily& family, const BranchLimits& limits,
                                     Clock::time_point deadline) {
  constexpr int kValues = 11;
  const ParametrisedScene& scene = family.scene();
  std::vector<SequencedOrbit> seeds;
  for (const double end : {scene.from, scene.to}) {
    if (!family.driven()) break;  // at rest
    if (auto free = contact_free_orbit(family, end)) seeds.push_back(std::move(*free));
  }
  const Clock::time_point enough = deadline - seconds_of(0.9 * limits.timeout);
  for (int i = -2; i < kValues && family.driven(); ++i) {
    if (i >= 0 && Clock::now() > enough) break;
    const double value = i == -2 ? scene.from : i == -1 ? scene.to : value_inside(scene, i, kValues);
    if (auto found = found_orbit(family, value, deadline)) seeds.push_back(std::move(*found));
  }
  const int contacts = scene.at(scene.from).contact_count();
  for (int i = 0; i < kValues && Clock::now() < deadline; ++i) {
    const double value = value_inside(scene, i, kValues);
    for (int order = 1; order <= (family.driven() ? limits.max_order : 1); ++order) {
      for (int contact = 0; contact < contacts; ++contact) {
        for (SequencedOrbit& orbit : one_impact_orbits(family, value, contact, order))
          seeds.push_back(std::move(orbit));
      }
    }
  }
  add_searched(family, limits, deadline - seconds_of(0.5 * limits.timeout), seeds);
  return seeds;
}

Json steps_json(const MethodResponse& response) {
  Json points = Json::array();
  for (const SweepPoint& step : response.steps) {
    points.push_back({{"omega", step.frequency},
                      {"order", response.order},
                      {"amplitude", step.amplitude},
                      {"x_max", step.x_max},
                      {"status", status_name(step.status)},
                      {"stable", step.stable ? Json(*step.stable) : Json()}});
  }
  return {{"method", response.method},
          {"points", points},
          {"special", Json::array()},
          {"began", "first frequency"},
          {"ended", "last frequency"}};
}

Cell number_of(double value) { return {fmt::format("{:.10g}", value), value}; }

Cell largest_cell(const std::vector<double>& values) {
  if (values.empty()) return "-";
  return number_of(*std::max_element(values.begin(), values.end()));
}

std::vector<Cell> row_of(const std::string& method, std::size_t branch, const BranchPoint& point,
                         const std::string& mark) {
  return {method,
          number_of(static_cast<double>(branch)),
          number_of(point.parameter),
          number_of(point.order),
          number_of(point.impacts),
          largest_cell(point.x_max),
          largest_cell(point.amplitude),
          describe(point.stability),
          mark};
}

// The points of a branch at values asked for.
void add_points(Table& table, const std::string& method, std::size_t number_of_branch, const Branch& branch) {
  for (const BranchPoint& point : branch.points)
    table.rows.push_back(row_of(method, number_of_branch, point, ""));
}

void add_rows(Table& table, const std::string& method, std::size_t number_of_branch, const Branch& branch) {
  auto special = branch.special.begin();
  for (std::size_t i = 0; i <= branch.points.size(); ++i) {
    for (; special != branch.special.end() && special->after == i; ++special)
      table.rows.push_back(row_of(method, number_of_branch, special->point, describe(special->kind)));
    if (i == branch.points.size()) break;
    const bool first = i == 0, last = i + 1 == branch.points.size();
    table.rows.push_back(row_of(method, number_of_branch, branch.points[i],
                                first  ? "begins: " + branch.began
                                : last ? "ends: " + branch.ended
                                       : ""));
  }
}

}  // namespace

ParametrisedScene over_place(const SceneSource& source, const std::string& place, double from, double to) {
  for (const auto& [name, value] : {std::pair("from", from), std::pair("to", to)}) {
    if (!std::isfinite(value)) throw UsageError(fmt::format("{} = {} (must be finite)", name, value));
  }
  if (from == to) throw UsageError(fmt::format("to = {} (must differ from `from`)", to));
  const auto scene = std::make_shared<const VariedScene>(source, place);
  for (const double end : {from, to}) (void)scene->at(end);  // refuses what is no scene
  return {.parameter = place, .from = from, .to = to, .at = [scene](double value) {
            return scene->unchecked(value);
          }};
}

BranchDiagram exact_branches(const ParametrisedScene& scene, const BranchLimits& limits) {
  const Problem middle = scene.at(scene.middle());
  if (const std::string obstacle = continuation_obstacle(middle); !obstacle.empty())
    throw UsageError(fmt::format("methods = {} (must be followed with --natural here: {})",
                                 kFollowedByArcLength, obstacle));
  const Clock::time_point deadline = deadline_of(limits);
  OrbitFamily family(scene);
  return trace_diagram(family, seeds_of(family, limits, deadline),
                       {.curve = {.largest_step = limits.largest_step,
                                  .max_points = limits.max_points,
                                  .phases = limits.phases,
                                  .at = limits.at,
                                  .expired = [deadline] { return interrupted() || Clock::now() > deadline; }},
                        .max_order = limits.max_order,
                        .max_branches = limits.max_branches,
                        .take = limits.take});
}

std::optional<BranchDiagram> own_branches(const ParametrisedScene& scene, const MethodChoice& method,
                                          const BranchLimits& limits) {
  const std::unique_ptr<Method> made = method.make();
  const auto* curve = dynamic_cast<const CurveMethod*>(made.get());
  if (curve == nullptr) return std::nullopt;
  for (const double end : {scene.from, scene.to}) {
    const Support support = made->supports(scene.at(end));
    if (!support.ok)
      throw UsageError(
          fmt::format("methods = {} (must apply to the scene: {})", method.label(), support.reason));
  }
  return curve->follow(scene.at(scene.from), scene.from, scene.to,
                       {.max_order = limits.max_order,
                        .max_branches = limits.max_branches,
                        .max_points = limits.max_points,
                        .phases = limits.phases,
                        .at = limits.at,
                        .take = limits.take,
                        .deadline = deadline_of(limits)});
}

std::optional<BranchDiagram> branches_of(const ParametrisedScene& scene, const MethodChoice& method,
                                         const BranchLimits& limits) {
  if (method.entry->name == kFollowedByArcLength) return exact_branches(scene, limits);
  return own_branches(scene, method, limits);
}

Json to_json(const std::vector<MethodResponse>& responses) {
  Json branches = Json::array(), notes = Json::array();
  std::string unfinished, parameter(kFrequency);
  for (const MethodResponse& response : responses) {
    for (const Branch& branch : response.diagram.branches)
      branches.push_back(to_json(branch, response.method));
    for (const std::string& note : response.diagram.notes) notes.push_back(note);
    if (!response.steps.empty()) branches.push_back(steps_json(response));
    if (unfinished.empty()) unfinished = response.diagram.unfinished;
    parameter = response.parameter;
  }
  return {{"parameter", parameter}, {"branches", branches}, {"unfinished", unfinished}, {"notes", notes}};
}

Branch points_at(const Branch& branch, const std::vector<double>& values) {
  const auto asked_for = [&](const BranchPoint& point) {
    constexpr double kSame = 1e-10;  // of the value
    return std::any_of(values.begin(), values.end(), [&](double value) {
      return std::abs(point.parameter - value) <= kSame * std::abs(value);
    });
  };
  Branch result = branch;
  std::erase_if(result.points, [&](const BranchPoint& point) { return !asked_for(point); });
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
  table.header = {"method",        "branch",    parameter == kFrequency ? "omega [rad/s]" : parameter,
                  "order",         "impacts",   "x max [m]",
                  "amplitude [m]", "stability", "mark"};
  for (const MethodResponse& response : responses) {
    const auto& add = response.at_values ? add_points : add_rows;
    for (std::size_t i = 0; i < response.diagram.branches.size(); ++i)
      add(table, response.method, first + i, response.diagram.branches[i]);
    for (const SweepPoint& step : response.steps) {
      table.rows.push_back({response.method, number_of(0), number_of(step.frequency),
                            number_of(response.order), "-", largest_cell(step.x_max),
                            largest_cell(step.amplitude),
                            !step.stable   ? "-"
                            : *step.stable ? "stable"
                                           : "unstable",
                            std::string(status_name(step.status))});
    }
  }
  return table;
}

}  // namespace signorini
