#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/evaluation/scene_groups.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/sections/sections.hpp"
#include "harness/statistics.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// Factors at which a table gives a profile [-].
constexpr std::array kFactors{1.0, 2.0, 10.0};

std::string error_title(double error) { return fmt::format("{:.0e}", error); }

/// "rigid stop (e = 1), spring, 8 scenes".
std::string contest_title(const Evaluation& evaluation, const RankingGroup& group) {
  std::set<SceneKind> kinds;
  for (const std::string& scene : group.scenes)
    if (const std::optional<SceneKind> kind = kind_of(evaluation, scene)) kinds.insert(*kind);
  std::string title;
  for (const SceneKind kind : kinds) {
    std::string words{kind_title(kind)};
    words.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(words.front())));
    title += words + ", ";
  }
  return title + plural(std::ssize(group.scenes), "scene");
}

/// "All methods solve the impact law of these scenes, hat-lcp[plain=true] excepted.": the shorter of who
/// does and who not.
std::string contestants_text(const Evaluation& evaluation, const RankingGroup& group) {
  std::vector<std::string> others;
  std::ranges::set_difference(evaluation.configurations(), group.configurations, std::back_inserter(others));
  if (others.empty()) return "All methods are ranked: all solve the impact law of these scenes.";
  if (others.size() < group.configurations.size())
    return fmt::format("Ranked are the methods that solve the impact law of these scenes: all but {}.",
                       joined(others, ", "));
  const bool one = group.configurations.size() == 1;
  return fmt::format("Ranked {} {}: no other method solves the impact law of these scenes.",
                     one ? "is" : "are", joined(group.configurations, ", "));
}

/// Whether any run of a group has a time: runs of a build that may not be timed have none, and cannot be
/// ranked.
bool is_timed(const RankingGroup& group) {
  const auto has_time = [](const ScoredRun& run) { return run.result->seconds.has_value(); };
  for (const auto& row : group.studies) {
    for (const ResolutionStudy* study : row) {
      if (std::ranges::any_of(study->runs, has_time)) return true;
    }
  }
  return false;
}

Cell share_cell(double share) { return {fmt::format("{:.0f} %", 100.0 * share), share}; }

std::ptrdiff_t runs_on_another_orbit(const std::vector<const ResolutionStudy*>& studies) {
  const auto on_another = [](const ScoredRun& run) {
    return run.result->outcome.status == Status::converged && run.result->outcome.same_orbit == false;
  };
  std::ptrdiff_t runs = 0;
  for (const ResolutionStudy* study : studies) runs += std::ranges::count_if(study->runs, on_another);
  return runs;
}

/// Contestants by rising key.
template <class Key>
std::vector<std::size_t> order_by(std::size_t contestants, const Key& key) {
  std::vector<std::size_t> order(contestants);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, key);
  return order;
}

/// Whether the order of the means depends on the shift.
bool order_depends_on_shift(const Costs& costs, double failure) {
  const auto order = [&](double shift) {
    std::vector<double> means;
    for (const auto& row : costs) means.push_back(shifted_geometric_mean(row, shift, failure));
    return order_by(costs.size(), [&](std::size_t c) { return means[c]; });
  };
  const auto usual = order(kMeanShift);
  return std::ranges::any_of(kMeanShifts, [&](double shift) { return order(shift) != usual; });
}

void add_mean_rows(const RankingGroup& group, double error, double limit, Table& table) {
  const Costs costs = costs_to_error(group, time_axis(), error);
  const PerformanceProfile profile = performance_profile(costs);
  for (std::size_t c = 0; c < costs.size(); ++c) {
    const std::ptrdiff_t solved = solved_count(costs[c]);
    std::vector<Cell> row{Cell(error_title(error), -error), group.configurations[c],
                          count_cell(solved, std::ssize(costs[c]))};
    const auto add_time = [&](double seconds) {
      row.emplace_back(solved == 0 ? "none solved" : time_text(seconds),
                       solved == 0 ? kNeverReached : seconds);
    };
    for (const double shift : kMeanShifts) add_time(shifted_geometric_mean(costs[c], shift, limit));
    add_time(par2(costs[c], limit));
    for (const double factor : kFactors) row.push_back(share_cell(profile.share(c, factor)));
    table.rows.push_back(std::move(row));
  }
}

std::string shift_remark(const RankingGroup& group, double limit) {
  std::vector<std::string> changed;
  for (const double error : kErrorLevels) {
    if (order_depends_on_shift(costs_to_error(group, time_axis(), error), limit))
      changed.push_back(error_title(error));
  }
  if (changed.empty()) return "The order of the means is the same with all three shifts.";
  return fmt::format(
      "The order of the means changes with the shift at error {}, where it is therefore no ranking.",
      joined(changed, ", "));
}

/// Medians over the scenes; "not counted" where a configuration has no such count on any of them.
Cell work_cell(const std::vector<const ResolutionStudy*>& studies, const CostAxis& axis, double error) {
  std::vector<double> costs;
  bool counted = false;
  for (const ResolutionStudy* study : studies) {
    costs.push_back(cost_to_error(*study, axis, error).cost);
    counted = counted || std::ranges::any_of(study->runs, [&](const ScoredRun& run) {
                return axis.cost(*run.result).has_value();
              });
  }
  if (!counted) return {"not counted", kNeverReached};
  const double middle = median(costs);
  return {std::isfinite(middle) ? fmt::format("{:.0f}", middle) : "half or more fail", middle};
}

/// "64 to 100 %".
std::string interval_text(const Interval& share) {
  return fmt::format("{:.0f} to {:.0f} %", 100.0 * share.low, 100.0 * share.high);
}

/// "not reached" of an infinite time.
std::string end_text(double seconds) { return std::isfinite(seconds) ? time_text(seconds) : "not reached"; }

/// What a row says of its costs beside those of the best.
Cell beside_best(const std::vector<double>& row, const std::vector<double>& best, bool differ) {
  if (!differ) return {"no difference"};
  const double ratio = PairedCosts(row, best).ratio();
  const std::ptrdiff_t fewer = solved_count(best) - solved_count(row);
  const std::string times = fmt::format("{:.2g} times as long", ratio);
  return {fewer > 0 ? fmt::format("{}, {} fewer solved", times, fewer) : times, ratio};
}

void fill_intervals(const RankingGroup& group, double /*limit*/, Section& section) {
  if (group.scenes.size() < kFewestScenes || group.configurations.size() < 2) return;
  const double error = kGroupErrors[kRankingError];
  section.text = fmt::format(
      R"(How sure the verdict on these scenes is of others like them, to an error of {}: the scenes as a
sample of 95 % confidence. Of the share that is solved Wilson's interval [wilson1927]; of the median time, a failure counting as
infinite, that of the bootstrap over scenes [efron1979]. Best first, by scenes and then by time. Beside the best: no
difference, where the times of the two differ by less than 5 % or by no more than chance would explain, as in the
section pair by pair.)",
      error_title(error));
  section.table.header = {"method", "solved", "share, 95 %", "time, median", "time, 95 %", "beside the best"};
  const Costs costs = costs_to_error(group, time_axis(), error);
  const std::vector<std::vector<bool>> differ = different_costs(costs);
  const std::vector<std::size_t> order = order_by(
      costs.size(), [&](std::size_t c) { return std::pair(-solved_count(costs[c]), median(costs[c])); });
  for (const std::size_t c : order) {
    const std::ptrdiff_t solved = solved_count(costs[c]);
    if (solved == 0) continue;
    const Interval time = bootstrap_median(costs[c]);
    const double middle = median(costs[c]);
    section.table.rows.push_back(
        {group.configurations[c], count_cell(solved, std::ssize(costs[c])),
         interval_text(proportion(static_cast<int>(solved), static_cast<int>(costs[c].size()))),
         Cell(end_text(middle), middle), fmt::format("{} to {}", end_text(time.low), end_text(time.high)),
         c == order.front() ? Cell("-")
                            : beside_best(costs[c], costs[order.front()], differ[c][order.front()])});
  }
}

void fill_time_to_error(const RankingGroup& group, double /*limit*/, Section& section) {
  section.text = R"(On how many scenes a method gets its error down to that of
the column at any of its resolutions, and the median over all scenes of the time of the cheapest that does.
Nothing is interpolated; a scene that is not solved counts as infinite. Motions of the first column are told
stable or not: no experiment shows an unstable one. Runs on another orbit: those that
found another motion of the scene than the one reached from rest, which counts as well.)";
  section.table.header = {"method"};
  for (const double error : kErrorLevels) section.table.header.push_back(error_title(error));
  section.table.header.insert(section.table.header.end(), {"stability", "runs on another orbit"});
  for (std::size_t c = 0; c < group.configurations.size(); ++c) {
    std::vector<Cell> row{group.configurations[c]};
    for (const double error : kErrorLevels) {
      const std::vector<double> costs = costs_to_error(group, time_axis(), error)[c];
      row.push_back(count_cell(solved_count(costs), std::ssize(costs), median(costs)));
    }
    Reach reach;  // to the error of the first column
    for (const ResolutionStudy* study : group.studies[c]) reach.add(*study, kErrorLevels.front());
    row.emplace_back(stability_text(reach.stable, reach.unstable, reach.scenes),
                     static_cast<double>(reach.unstable));
    row.push_back(count_cell(runs_on_another_orbit(group.studies[c])));
    section.table.rows.push_back(std::move(row));
  }
}

void fill_means(const RankingGroup& group, double limit, Section& section) {
  section.text = fmt::format(R"(Times to error over all scenes. A failure counts as the time limit of
{} in the shifted geometric means, as twice that in PAR2. Right: on how many of all scenes the method is the
fastest, or within 2 or 10 times of it; a failure is infinitely slow.)",
                             time_text(limit));
  section.table.header = {"error", "method", "solved"};
  for (const double shift : kMeanShifts)
    section.table.header.push_back(fmt::format("mean, shift {}", time_text(shift)));
  section.table.header.insert(section.table.header.end(), {"PAR2", "fastest", "within 2 x", "within 10 x"});
  for (const double error : kErrorLevels) add_mean_rows(group, error, limit, section.table);
  section.note = shift_remark(group, limit);
}

void fill_distribution(const RankingGroup& group, double limit, Section& section) {
  constexpr std::array kTimes{1e-4, 1e-3, 1e-2, 1.0};  // [s]
  std::vector<std::string> titles;
  for (const double error : kErrorLevels) titles.push_back(error_title(error));
  const Costs times = costs_to_targets(group, time_axis());
  section.text = fmt::format(
      R"(Share of all targets reached within a time, a target being a scene and one of the errors {}: the empirical
distribution function of the time to a target [hansen2021], which weighs all errors alike and needs no fastest method. The last
column: within the time limit.)",
      joined(titles, ", "));
  section.table.header = {"method"};
  for (const double time : kTimes) section.table.header.push_back(time_text(time));
  section.table.header.emplace_back("ever");
  for (std::size_t c = 0; c < times.size(); ++c) {
    const auto within = [&](double time) {
      const auto reached = std::ranges::upper_bound(times[c], time) - times[c].begin();
      return static_cast<double>(reached) / static_cast<double>(times[c].size());
    };
    std::vector<Cell> row{group.configurations[c]};
    for (const double time : kTimes) row.push_back(share_cell(within(time)));
    row.push_back(share_cell(within(std::max(limit, kTimes.back()))));
    section.table.rows.push_back(std::move(row));
  }
}

/// "62 % (1.9)", or "62 % =".
Cell pair_cell(const std::vector<double>& row, const std::vector<double>& column, bool differ) {
  Cell cell = share_cell(performance_profile({row, column}).share(0, 1.0));
  cell.text += differ ? fmt::format(" ({:.2g})", PairedCosts(row, column).ratio()) : " =";
  return cell;
}

void fill_pairs(const RankingGroup& group, double /*limit*/, Section& section) {
  if (group.configurations.size() < 3) return;  // the joint profile of two is the pairwise one
  section.text = R"(Share of all scenes that the method of the row solves at least as fast
as that of the column, the two alone: a joint profile of more than two methods tells only who is first. Methods that reach
the error nowhere have no row. In brackets how many times as long the row takes, the median over the scenes that both
solve. =: no difference; the two differ by less than 5 %, or by no more than chance would explain (signed ranks of the
logarithms of their times, a failure being slower than any time; 5 % for all pairs of an error together, Holm's
correction).)";
  section.table.header = {"error", "method"};
  section.table.header.insert(section.table.header.end(), group.configurations.begin(),
                              group.configurations.end());
  for (const double error : kHeadlineErrors) {
    const Costs costs = costs_to_error(group, time_axis(), error);
    const std::vector<std::vector<bool>> differ = different_costs(costs);
    for (std::size_t a = 0; a < costs.size(); ++a) {
      if (solved_count(costs[a]) == 0) continue;
      std::vector<Cell> row{Cell(error_title(error), -error), group.configurations[a]};
      for (std::size_t b = 0; b < costs.size(); ++b)
        row.push_back(a == b ? Cell("·") : pair_cell(costs[a], costs[b], differ[a][b]));
      section.table.rows.push_back(std::move(row));
    }
  }
}

void fill_work(const RankingGroup& group, double /*limit*/, Section& section) {
  section.text = R"(What the cheapest resolution by each count needs, the median over all
scenes: counts that no noise touches. What an iteration or a pivot costs differs between methods; they compare
runs of one kind.)";
  section.table.header = {"error", "method"};
  for (const CostAxis& axis : work_axes()) section.table.header.emplace_back(axis.name);
  for (const double error : kHeadlineErrors) {
    for (std::size_t c = 0; c < group.configurations.size(); ++c) {
      std::vector<Cell> row{Cell(error_title(error), -error), group.configurations[c]};
      for (const CostAxis& axis : work_axes()) row.push_back(work_cell(group.studies[c], axis, error));
      section.table.rows.push_back(std::move(row));
    }
  }
}

/// A table that each group has; `fill` leaves it without rows where the group cannot have it.
struct RankingTable {
  const char *id, *title;
  bool of_times;
  void (*fill)(const RankingGroup& group, double limit, Section& section);
  Figure (*figure)(const Evaluation& evaluation, std::size_t group, Column column) = nullptr;
};

constexpr std::array kRankingTables{
    RankingTable{"time-to-error", "Time to error", true, fill_time_to_error},
    RankingTable{"intervals", "How sure the times are", true, fill_intervals},
    RankingTable{"means", "Means and profiles", true, fill_means, profile_figure},
    RankingTable{"distribution", "Time to a target", true, fill_distribution, distribution_figure},
    RankingTable{"pairs", "Pair by pair", true, fill_pairs},
    RankingTable{"work", "Work to error", false, fill_work}};

}  // namespace

Sections ranking_sections(const Evaluation& evaluation) {
  Sections sections;
  for (const RankingTable& table : kRankingTables) {
    for (std::size_t k = 0; k < evaluation.groups().size(); ++k) {
      const RankingGroup& group = evaluation.groups()[k];
      Section section{.id = fmt::format("{}-{}", table.id, k + 1),
                      .title = fmt::format("{}: {}", table.title, contest_title(evaluation, group))};
      if (!table.of_times || is_timed(group)) table.fill(group, evaluation.time_limit(), section);
      if (section.table.rows.empty()) continue;
      section.text = contestants_text(evaluation, group) + " " + section.text;
      if (table.figure != nullptr) section.figures = {table.figure(evaluation, k, Column::own)};
      sections.push_back(std::move(section));
    }
  }
  return sections;
}

}  // namespace signorini
