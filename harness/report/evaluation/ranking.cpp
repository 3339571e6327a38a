#include "harness/report/evaluation/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "harness/statistics.hpp"

namespace signorini {

namespace {

using Names = std::vector<std::string>;

/// Removes configurations that apply to none of the scenes.
void drop_inapplicable(RankingGroup& group) {
  for (std::size_t c = group.configurations.size(); c-- > 0;) {
    const auto inapplicable = [](const ResolutionStudy* study) {
      return study->eligibility == Eligibility::not_applicable;
    };
    if (!std::all_of(group.studies[c].begin(), group.studies[c].end(), inapplicable)) continue;
    group.configurations.erase(group.configurations.begin() + static_cast<std::ptrdiff_t>(c));
    group.studies.erase(group.studies.begin() + static_cast<std::ptrdiff_t>(c));
  }
}

}  // namespace

std::ptrdiff_t solved_count(std::span<const double> costs) {
  return std::ranges::count_if(costs, [](double cost) { return std::isfinite(cost); });
}

double shifted_geometric_mean(std::span<const double> costs, double shift, double failure) {
  double sum = 0.0;
  for (const double cost : costs) sum += std::log((std::isfinite(cost) ? cost : failure) + shift);
  return std::exp(sum / static_cast<double>(costs.size())) - shift;
}

double par2(std::span<const double> costs, double limit) {
  double sum = 0.0;
  for (const double cost : costs) sum += std::isfinite(cost) ? cost : 2.0 * limit;
  return sum / static_cast<double>(costs.size());
}

double PerformanceProfile::share(std::size_t configuration, double factor) const {
  const std::vector<double>& sorted = ratios[configuration];
  const auto within = std::upper_bound(sorted.begin(), sorted.end(), factor) - sorted.begin();
  return scenes == 0 ? 0.0 : static_cast<double>(within) / static_cast<double>(scenes);
}

PerformanceProfile performance_profile(const Costs& costs) {
  PerformanceProfile profile;
  profile.scenes = costs.empty() ? 0 : costs.front().size();
  profile.ratios.resize(costs.size());
  for (std::size_t s = 0; s < profile.scenes; ++s) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& row : costs) least = std::min(least, row[s]);
    for (std::size_t c = 0; c < costs.size(); ++c) {
      // Of two zeros the ratio is 1; a failure has none, nor has a cost beside one of zero.
      const double ratio = costs[c][s] == least ? 1.0 : costs[c][s] / least;
      if (std::isfinite(costs[c][s]) && std::isfinite(ratio)) profile.ratios[c].push_back(ratio);
    }
  }
  for (auto& ratios : profile.ratios) std::sort(ratios.begin(), ratios.end());
  return profile;
}

PairedCosts::PairedCosts(const std::vector<double>& one, const std::vector<double>& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (std::isfinite(one[i]) || std::isfinite(other[i])) logarithms.push_back(std::log(one[i] / other[i]));
  }
}

double PairedCosts::ratio() const {
  std::vector<double> both = logarithms;
  std::erase_if(both, [](double value) { return !std::isfinite(value); });
  return both.empty() ? 1.0 : std::exp(median(both));
}

bool PairedCosts::both_solve_all() const {
  return std::ranges::all_of(logarithms, [](double value) { return std::isfinite(value); });
}

std::vector<std::vector<bool>> different_costs(const Costs& costs) {
  constexpr double kAlike = 1.05, kChance = 0.05;
  std::vector<std::vector<bool>> differ(costs.size(), std::vector<bool>(costs.size(), false));
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<double> probabilities;
  for (std::size_t a = 0; a < costs.size(); ++a) {
    for (std::size_t b = a + 1; b < costs.size(); ++b) {
      const PairedCosts pair(costs[a], costs[b]);
      pairs.emplace_back(a, b);
      probabilities.push_back(signed_rank_probability(pair.logarithms));
      differ[a][b] = !pair.both_solve_all() || std::max(pair.ratio(), 1.0 / pair.ratio()) >= kAlike;
    }
  }
  probabilities = corrected_probabilities(probabilities);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    differ[b][a] = differ[a][b] = differ[a][b] && probabilities[i] <= kChance;
  }
  return differ;
}

std::vector<RankingGroup> ranking_groups(const std::vector<ResolutionStudy>& studies,
                                         const std::function<bool(const std::string& scene)>& is_ranked,
                                         const std::function<bool(const std::string& scene)>& is_apart) {
  std::map<std::string, std::map<std::string, const ResolutionStudy*>> by_scene;
  Names scenes;
  for (const ResolutionStudy& study : studies) {
    const bool fresh = scenes.empty() || scenes.back() != study.scene;
    if (fresh && !is_ranked(study.scene)) continue;
    if (fresh) scenes.push_back(study.scene);
    if (study.eligibility != Eligibility::another_law) by_scene[study.scene][study.configuration] = &study;
  }
  std::map<std::pair<Names, bool>, RankingGroup> by_configurations;
  for (const std::string& scene : scenes) {
    Names names;
    for (const auto& entry : by_scene[scene]) names.push_back(entry.first);
    if (names.empty()) continue;
    RankingGroup& group = by_configurations[{names, is_apart(scene)}];
    group.configurations = names;
    group.studies.resize(names.size());
    group.scenes.push_back(scene);
    for (std::size_t c = 0; c < names.size(); ++c) group.studies[c].push_back(by_scene[scene][names[c]]);
  }
  std::vector<RankingGroup> groups;
  for (auto& [names, group] : by_configurations) {
    drop_inapplicable(group);
    if (!group.configurations.empty()) groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const RankingGroup& a, const RankingGroup& b) {
    return a.scenes.size() > b.scenes.size();
  });
  return groups;
}

Costs costs_to_error(const RankingGroup& group, const CostAxis& axis, double error) {
  Costs costs;
  for (const auto& studies : group.studies) {
    std::vector<double>& row = costs.emplace_back();
    for (const ResolutionStudy* study : studies) row.push_back(cost_to_error(*study, axis, error).cost);
  }
  return costs;
}

Costs costs_to_targets(const RankingGroup& group, const CostAxis& axis) {
  Costs all(group.configurations.size());
  for (const double error : kErrorLevels) {
    const Costs costs = costs_to_error(group, axis, error);
    for (std::size_t c = 0; c < costs.size(); ++c) std::ranges::copy(costs[c], std::back_inserter(all[c]));
  }
  for (std::vector<double>& row : all) std::ranges::sort(row);
  return all;
}

}  // namespace signorini
