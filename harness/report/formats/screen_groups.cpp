#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/formats/screen.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

constexpr int kUnstableWidth = 6;
constexpr int kTimeWidth = 8;  // "1.23e+03 s" of a very slow method pushes its line, which is clipped

/// Lines of the columns of one group: names, then a time and a number of scenes for each error.
class Columns {
 public:
  explicit Columns(std::span<const SceneGroup> groups) {
    std::size_t scenes = 1;
    for (const SceneGroup& group : groups) scenes = std::max(scenes, group.scenes.size());
    count_width_ = static_cast<int>(std::max<std::size_t>(2, std::to_string(scenes).size()));
    const auto cell = static_cast<std::size_t>(1 + kTimeWidth + 1 + count_width_);
    name_width_ = kTerminalWidth - kGroupErrors.size() * cell - kUnstableWidth;
  }

  [[nodiscard]] ScreenLine titles() const {
    std::string text(name_width_, ' ');
    for (const char* title : kErrorTitles)
      text += fmt::format(" {:>{}} {:{}}", title, kTimeWidth, "", count_width_);
    return {text + fmt::format("{:>{}}", "unst.", kUnstableWidth)};
  }

  /// A name that is too long stands in a line of its own.
  [[nodiscard]] ScreenLines row(const Standing& standing) const {
    std::string figures;
    for (const Reach& reach : standing.reach) {
      const double seconds = reach.median_seconds();
      figures += fmt::format(" {:>{}} {:>{}}", std::isfinite(seconds) ? time_text(seconds) : "-", kTimeWidth,
                             reach.scenes, count_width_);
    }
    figures += fmt::format("{:>{}}", standing.reach.front().unstable, kUnstableWidth);
    const Emphasis emphasis = standing.recommended ? Emphasis::good : Emphasis::none;
    const std::string name = (standing.recommended ? "* " : "  ") + standing.names();
    if (name.size() <= name_width_)
      return {{clipped(fmt::format("{:{}}{}", name, name_width_, figures), kTerminalWidth), emphasis}};
    return {{clipped(name, kTerminalWidth), emphasis},
            {clipped(std::string(name_width_, ' ') + figures, kTerminalWidth), emphasis}};
  }

 private:
  int count_width_ = 0;
  std::size_t name_width_ = 0;
};

/// The standings in the order in which they get room, by their places: those recommended, then of each method
/// the best.
std::vector<std::size_t> order_of_room(const SceneGroup& group) {
  std::vector<std::string> methods;
  std::vector<std::pair<int, std::size_t>> turns;
  for (std::size_t i = 0; i < group.standings.size(); ++i) {
    const Standing& standing = group.standings[i];
    const bool seen = std::ranges::find(methods, standing.method) != methods.end();
    if (!seen) methods.push_back(standing.method);
    turns.emplace_back(seen ? 2 : standing.recommended ? 0 : 1, i);
  }
  std::ranges::sort(turns);
  std::vector<std::size_t> order;
  for (const auto& [turn, place] : turns) order.push_back(place);
  return order;
}

/// For each group the places of the standings for which there is room, shared out in turns, in their order.
std::vector<std::vector<std::size_t>> share_out(std::span<const SceneGroup> groups, const Columns& columns,
                                                std::size_t room) {
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> queue;  // turn, group, place
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::vector<std::size_t> order = order_of_room(groups[g]);
    for (std::size_t turn = 0; turn < order.size(); ++turn) queue.emplace_back(turn, g, order[turn]);
  }
  std::ranges::sort(queue);
  std::vector<std::vector<std::size_t>> shown(groups.size());
  for (const auto& [turn, g, place] : queue) {
    const std::size_t lines = columns.row(groups[g].standings[place]).size();
    if (lines > room) break;  // nor is there any for those that come after
    room -= lines;
    shown[g].push_back(place);
  }
  for (std::vector<std::size_t>& places : shown) std::ranges::sort(places);
  return shown;
}

/// "a, b and c".
std::string enumerated(const std::vector<std::string>& words) {
  if (words.size() < 2) return joined(words, "");
  return joined(std::span(words).first(words.size() - 1), ", ") + " and " + words.back();
}

/// What one method does on kinds of scenes, by one error.
struct Advice {
  const Standing* standing = nullptr;
  std::vector<std::string> kinds = {};
  std::size_t solved = 0, scenes = 0;
  double least = std::numeric_limits<double>::infinity(), most = 0.0;  ///< medians of the kinds [s]

  void add(const SceneGroup& group, const Standing& of) {
    const Reach& reach = of.reach[kRankingError];
    standing = &of;
    kinds.emplace_back(kind_words(group.kind));
    solved += reach.scenes;
    scenes += group.scenes.size();
    least = std::min(least, reach.median_seconds());
    most = std::max(most, reach.median_seconds());
  }

  [[nodiscard]] std::string text() const {
    const std::string from = time_text(least), to = time_text(most);
    return fmt::format("For {} use {}: its error is at most 1 % on {} of {} scenes, the median time {}.",
                       enumerated(kinds), standing->configuration, solved, scenes,
                       from == to ? from : fmt::format("{} to {}, by kind", from, to));
  }
};

/// "Other methods reach 1 % on these scenes, ...: hat-lcp 11 of 12, ...": of each further method the best
/// configuration, best first, as far as two lines hold.
ScreenLines others_lines(std::span<const SceneGroup> groups, const std::vector<Advice>& advice) {
  struct Solved {
    std::string configuration;
    std::size_t scenes = 0, of = 0;

    [[nodiscard]] std::string method() const { return configuration.substr(0, configuration.find('[')); }
  };
  std::vector<Solved> others;
  const auto add = [&](const std::string& configuration, const Standing& standing, const SceneGroup& group) {
    auto place = std::ranges::find(others, configuration, &Solved::configuration);
    if (place == others.end()) place = others.insert(others.end(), {configuration});
    place->scenes += standing.reach[kRankingError].scenes;
    place->of += group.scenes.size();
  };
  for (const SceneGroup& group : groups) {
    for (const Standing& standing : group.standings) {
      add(standing.configuration, standing, group);
      for (const std::string& same : standing.same) add(same, standing, group);
    }
  }
  std::ranges::stable_sort(others, std::ranges::greater(), &Solved::scenes);
  std::vector<std::string> seen, items;
  for (const Advice& one : advice) seen.push_back(one.standing->method);
  for (const Solved& one : others) {
    if (one.scenes == 0 || std::ranges::find(seen, one.method()) != seen.end()) continue;
    seen.push_back(one.method());
    items.push_back(fmt::format("{} {} of {}", one.configuration, one.scenes, one.of));
  }
  if (items.empty()) return {};
  constexpr std::size_t kMostLines = 3;
  const std::string words = "Other methods reach 1 % on these scenes, of those whose law they represent: ";
  ScreenLines lines = wrapped_text(words + joined(items, ", ") + ".");
  for (std::size_t more = 1; lines.size() > kMostLines && items.size() > 1; ++more) {
    items.pop_back();
    lines = wrapped_text(fmt::format("{}{} and {} more.", words, joined(items, ", "), more));
  }
  for (ScreenLine& line : lines) line.text = clipped(line.text, kTerminalWidth);
  return lines;
}

/// The recommendations as sentences, one for each method; what the others do; what nothing solves.
ScreenLines advice_lines(std::vector<SceneGroup> groups) {
  std::erase_if(groups, [](const SceneGroup& group) {
    return group.is_too_small() || group.kind == SceneKind::contact_free;
  });
  std::vector<Advice> advice;
  std::vector<std::string> unsolved;
  for (const SceneGroup& group : groups) {
    const auto best = std::ranges::find(group.standings, true, &Standing::recommended);
    if (best == group.standings.end()) {
      unsolved.emplace_back(kind_words(group.kind));
      continue;
    }
    auto place = std::ranges::find(advice, best->configuration,
                                   [](const Advice& one) { return one.standing->configuration; });
    if (place == advice.end()) place = advice.insert(advice.end(), Advice());
    place->add(group, *best);
  }
  ScreenLines lines;
  for (const Advice& one : advice) append(lines, wrapped_text(one.text()));
  if (!advice.empty()) append(lines, others_lines(groups, advice));
  if (!unsolved.empty())
    append(lines, wrapped_text(
                      fmt::format("For {} no method reaches 1 % on a stable motion.", enumerated(unsolved))));
  return lines;
}

ScreenLine row_of(const ResponseStanding& one) {
  constexpr std::size_t kName = 42;
  const bool starred = one.recommended;
  const std::string mark = one.makes_the_exact ? "=" : starred ? "*" : " ";
  return {fmt::format("{} {:<{}}{:>6.1f} %{:>6.1f} %{:>9}{:>10}", mark, clipped(one.label, kName), kName,
                      100.0 * one.found, 100.0 * one.false_share,
                      fmt::format("{}/{}", one.located, one.points), one.cost ? time_text(*one.cost) : "-"),
          starred ? Emphasis::good : Emphasis::none};
}

}  // namespace

void append(ScreenLines& lines, ScreenLines more) {
  lines.insert(lines.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

ScreenLines wrapped_text(const std::string& text, Emphasis emphasis) {
  ScreenLines lines;
  for (std::string& line : wrapped_lines(text, kTerminalWidth)) lines.push_back({std::move(line), emphasis});
  return lines;
}

std::string verdict_title(const SceneGroup& group) {
  std::string names;
  for (const Standing& standing : group.standings) {
    if (!standing.recommended) continue;
    names += names.empty() ? standing.names() : fmt::format(" or {} ({})", standing.names(), standing.reason);
  }
  if (group.is_too_small()) names = kTooFewScenes;
  const bool any = std::ranges::any_of(
      group.standings, [](const Standing& standing) { return standing.reach[kRankingError].scenes > 0; });
  const auto scenes = static_cast<std::ptrdiff_t>(group.scenes.size());
  return fmt::format("{}, {}: {}", kind_title(group.kind), plural(scenes, "scene"),
                     !names.empty() ? names
                     : any          ? "only unstable motions get to 1 %"
                                    : "no method gets to 1 %");
}

ScreenLines group_lines(const Evaluation& evaluation, std::size_t most) {
  std::vector<SceneGroup> groups = scene_groups(evaluation);
  if (groups.empty()) return {};
  if (!std::ranges::all_of(groups, &SceneGroup::is_too_small))  // they recommend nothing, and take room
    std::erase_if(groups, [](const SceneGroup& group) { return group.is_too_small(); });
  const Columns columns(groups);
  ScreenLines lines{{}};
  if (ScreenLines advice = advice_lines(groups); !advice.empty()) {
    append(lines, std::move(advice));
    lines.emplace_back();
  }
  append(lines, wrapped_text("Which method? " + std::string(kVerdictRule)));
  lines.push_back(columns.titles());
  constexpr std::size_t kMostOfTitle = 2;  // lines
  std::vector<ScreenLines> titles;
  std::size_t taken = lines.size();
  for (const SceneGroup& group : groups) {
    titles.push_back(wrapped_text(verdict_title(group), Emphasis::title));
    titles.back().resize(std::min(titles.back().size(), kMostOfTitle));
    for (ScreenLine& line : titles.back()) line.text = clipped(line.text, kTerminalWidth);
    taken += titles.back().size();
  }
  const std::vector<std::vector<std::size_t>> shown =
      share_out(groups, columns, most - std::min(most, taken));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    append(lines, std::move(titles[g]));
    for (const std::size_t place : shown[g]) append(lines, columns.row(groups[g].standings[place]));
  }
  return lines;
}

ScreenLines response_lines(const Evaluation& evaluation, std::size_t most) {
  if (evaluation.responses().empty()) return {};
  const std::vector<ResponseGroup> groups = response_groups(evaluation.responses());
  if (groups.empty()) return wrapped_text("No method was compared with an exact response.");
  ScreenLines lines = wrapped_text(
      "Which method? Share of the exact branches found, of its own false, special points located, processor "
      "time per length:");
  lines.push_back({fmt::format("{:<44}{:>8}{:>8}{:>9}{:>10}", "", "found", "false", "located", "time")});
  ScreenLines rule = wrapped_text(std::string(kResponseRule) + " It has the sign =.");
  const std::size_t taken = lines.size() + rule.size() + 1;
  const std::size_t rows = (most > taken ? most - taken : 0) / groups.size();
  const std::size_t methods = std::max<std::size_t>(3, rows) - 1;  // beside the title
  for (const ResponseGroup& group : groups) {
    lines.push_back({group_title(group) + (group.is_too_small() ? fmt::format(": {}", kTooFewScenes) : ""),
                     Emphasis::title});
    for (const ResponseStanding& one :
         std::span(group.standings).first(std::min(methods, group.standings.size())))
      lines.push_back(row_of(one));
  }
  lines.push_back({});
  append(lines, std::move(rule));
  return lines;
}

}  // namespace signorini
