#include "harness/report/evaluation/contest.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "harness/report/evaluation/work_precision.hpp"

namespace signorini {

namespace {

using Names = std::vector<std::string>;

/// Without those that apply to none of the scenes.
void drop_strangers(Contest& contest) {
  for (std::size_t c = contest.contestants.size(); c-- > 0;) {
    const auto stranger = [](const Ladder* ladder) { return ladder->standing == Standing::not_applicable; };
    if (!std::all_of(contest.ladders[c].begin(), contest.ladders[c].end(), stranger)) continue;
    contest.contestants.erase(contest.contestants.begin() + static_cast<std::ptrdiff_t>(c));
    contest.ladders.erase(contest.ladders.begin() + static_cast<std::ptrdiff_t>(c));
  }
}

}  // namespace

std::vector<Contest> contests_of(const std::vector<Ladder>& ladders) {
  std::map<std::string, std::map<std::string, const Ladder*>> by_scene;
  Names scenes;
  for (const Ladder& ladder : ladders) {
    if (scenes.empty() || scenes.back() != ladder.scene) scenes.push_back(ladder.scene);
    if (ladder.standing != Standing::another_law) by_scene[ladder.scene][ladder.contestant] = &ladder;
  }
  std::map<Names, Contest> groups;
  for (const std::string& scene : scenes) {
    Names names;
    for (const auto& entry : by_scene[scene]) names.push_back(entry.first);
    if (names.empty()) continue;
    Contest& contest = groups[names];
    contest.contestants = names;
    contest.ladders.resize(names.size());
    contest.scenes.push_back(scene);
    for (std::size_t c = 0; c < names.size(); ++c) contest.ladders[c].push_back(by_scene[scene][names[c]]);
  }
  std::vector<Contest> contests;
  for (auto& group : groups) {
    drop_strangers(group.second);
    if (!group.second.contestants.empty()) contests.push_back(std::move(group.second));
  }
  std::stable_sort(contests.begin(), contests.end(),
                   [](const Contest& a, const Contest& b) { return a.scenes.size() > b.scenes.size(); });
  return contests;
}

Costs costs_to_error(const Contest& contest, const CostAxis& axis, double error) {
  Costs costs;
  for (const auto& ladders : contest.ladders) {
    std::vector<double>& row = costs.emplace_back();
    for (const Ladder* ladder : ladders) row.push_back(cost_to_error(*ladder, axis, error).cost);
  }
  return costs;
}

}  // namespace signorini
