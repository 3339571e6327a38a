#include "harness/terminal/sweep_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "harness/report/document/lines.hpp"
#include "harness/text/columns.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"

namespace signorini {

namespace {

constexpr std::size_t kPointIndent = 32;  // columns of the numbers before the words of a line
constexpr std::size_t kEnergyColumn = 15;

/// "     3.855375        1.76251  fold"; of free motions the energy is a third number.
std::string point_line(const SolutionPoint& point, const std::string& words) {
  const double amplitude = point.amplitude.empty() ? 0.0 : *std::ranges::max_element(point.amplitude);
  const std::string numbers = fmt::format("{:>14.8g}{:>15.6g}", point.parameter, amplitude);
  if (!point.energy) return named_lines(numbers, kPointIndent, words, kTerminalWidth);
  return named_lines(numbers + fmt::format("{:>{}.8g}", other_than_parameter(point), kEnergyColumn),
                     kPointIndent + kEnergyColumn, words, kTerminalWidth);
}

/// "all stable", "30 stable, 36 unstable": how many points are what, which adds up to all of them.
std::string stability_counts(const std::vector<SolutionPoint>& points) {
  std::string text;
  const auto tell = [&](std::ptrdiff_t count, const std::string& word) {
    if (count == std::ssize(points)) {
      text = "all " + word;
    } else if (count > 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word);
    }
  };
  for (const OrbitStability stability :
       {OrbitStability::stable, OrbitStability::elliptic, OrbitStability::unstable, OrbitStability::unknown})
    tell(std::ranges::count(points, stability, &SolutionPoint::stability),
         stability == OrbitStability::unknown ? "of unknown stability" : describe(stability));
  const auto by_order = std::ranges::count_if(points, [](const SolutionPoint& point) {
    return point.stability == OrbitStability::undefined && !point.undefined.empty();
  });
  tell(by_order, "undefined by the order of simultaneous impacts");
  tell(std::ranges::count(points, OrbitStability::undefined, &SolutionPoint::stability) - by_order,
       "undefined where an impact grazes");
  return text;
}

/// Whether the branch ends at the special point for that reason, which is said once.
bool is_the_end(const SpecialPoint& special, const Branch& branch) {
  return special.after + 1 >= branch.points.size() && special.text == branch.ended;
}

std::string branch_text(std::size_t number, const Branch& branch) {
  if (branch.points.empty()) return {};
  const int order = branch.points.front().order;
  std::string text = fmt::format("branch {}{}: {}, {}\n", number,
                                 order == 1 ? "" : fmt::format(", motions of {} periods of the load", order),
                                 plural(std::ssize(branch.points), "point"), stability_counts(branch.points));
  text += point_line(branch.points.front(), "begins: " + branch.began);
  for (const SpecialPoint& special : branch.special) {
    if (is_the_end(special, branch)) continue;
    text +=
        point_line(special.point, describe(special.kind) + (special.text.empty() ? "" : ": " + special.text));
  }
  return text + point_line(branch.points.back(), "ends: " + branch.ended);
}

std::string branches_text(const MethodResponse& response) {
  const std::vector<Branch>& branches = response.diagram.branches;
  const bool over_energy = response.parameter == kEnergy;
  std::string text = fmt::format(
      "{}: {}\n{:>14}{:>15}{}\n", name_with_law(response),
      branches.size() == 1 ? "1 branch" : fmt::format("{} branches", branches.size()),
      parameter_title(response.parameter), "amplitude [m]",
      of_free_motions(response.diagram)
          ? fmt::format("{:>{}}", parameter_title(std::string(over_energy ? kFrequency : kEnergy)),
                        kEnergyColumn)
          : "");
  for (std::size_t i = 0; i < branches.size(); ++i) text += branch_text(i, branches[i]);
  return text;
}

/// Of points of steps without an answer, each reason once.
std::vector<std::string> failures(const std::vector<SweepPoint>& steps) {
  constexpr std::size_t kMostReasons = 6;  // told; more differ by their numbers alone
  std::vector<std::pair<std::string, std::size_t>> reasons;
  for (const SweepPoint& step : steps) {
    if (step.status == Status::converged) continue;
    const std::string text =
        fmt::format("{}{}{}", status_name(step.status), step.message.empty() ? "" : ": ", step.message);
    const auto known = std::ranges::find(reasons, text, &std::pair<std::string, std::size_t>::first);
    if (known != reasons.end())
      ++known->second;
    else
      reasons.emplace_back(text, 1);
  }
  std::vector<std::string> lines;
  for (const auto& [text, count] : reasons) {
    if (lines.size() == kMostReasons) break;
    lines.push_back(fmt::format("{} of {} {}", count, plural(std::ssize(steps), "point"), text));
  }
  if (reasons.size() > kMostReasons)
    lines.push_back(fmt::format("{} more (--format json has them all)",
                                plural(std::ssize(reasons) - std::ssize(lines), "reason")));
  return lines;
}

/// Values that no branch has a point at, in words.
std::string values_without_motion(const std::vector<Branch>& branches, const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    const auto has = [value](const Branch& branch) { return !points_at(branch, {value}).points.empty(); };
    if (std::ranges::none_of(branches, has)) text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", value);
  }
  return text;
}

}  // namespace

std::vector<std::string> shortcomings(const MethodResponse& response, const std::vector<double>& values) {
  const std::string name = name_with_law(response) + ": ";
  std::vector<std::string> lines;
  for (const std::string& failure : failures(response.steps)) lines.push_back(name + failure);
  const BranchDiagram& diagram = response.diagram;
  const std::string none =
      response.steps.empty() ? values_without_motion(diagram.branches, values) : std::string();
  const std::string left_out = incompleteness(response);
  if (!none.empty())
    lines.push_back(
        fmt::format("{}no motion at {}: {}", name, none,
                    diagram.unfinished.empty() ? "no branch that was found goes there" : diagram.unfinished));
  else if (!left_out.empty())
    lines.push_back(left_out);
  else if (!diagram.unfinished.empty())
    lines.push_back(diagram.unfinished);
  return lines;
}

std::string sweep_text(const std::vector<MethodResponse>& responses) {
  std::string text;
  for (const MethodResponse& response : responses) {
    if (response.steps.empty() && !response.at_values)
      text += branches_text(response);
    else
      text += to_columns(branch_table({response}));
  }
  return text;
}

}  // namespace signorini
