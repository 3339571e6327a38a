// Which method for whole frequency responses, on a screen.

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "harness/report/document/cells.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/evaluation/response_standings.hpp"
#include "harness/report/formats/screen_groups.hpp"

namespace signorini {

namespace {

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

ScreenLines response_lines(const Evaluation& evaluation, std::size_t most) {
  if (evaluation.responses().empty()) return {};
  const std::vector<ResponseGroup> groups = response_groups(evaluation.responses());
  if (groups.empty()) return wrapped_text("No method was compared with an exact response.");
  ScreenLines lines = wrapped_text(
      "Which method? Share of the exact branches found, of its own false, special points located, "
      "processor time per length:");
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
