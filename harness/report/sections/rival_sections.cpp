#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "harness/report/document/cells.hpp"
#include "harness/report/evaluation/rivals.hpp"
#include "harness/report/sections/sections.hpp"

namespace signorini {

namespace {

/// Two digits, without an exponent where it is large: "0.043", "3.1", "4000".
std::string ratio_text(double ratio) {
  if (ratio < 99.5) return fmt::format("{:.2g}", ratio);
  const double unit = std::pow(10.0, std::floor(std::log10(ratio)) - 1.0);
  return fmt::format("{:.0f}", std::round(ratio / unit) * unit);
}

/// "120 (3.1 to 4000)" of ratios that rise; "-" of none.
Cell ratio_cell(std::span<const double> ratios) {
  if (ratios.empty()) return {"-", kNeverReached};
  const double mean = shifted_geometric_mean(ratios, 0.0, kNeverReached);
  return {
      fmt::format("{} ({} to {})", ratio_text(mean), ratio_text(ratios.front()), ratio_text(ratios.back())),
      mean};
}

/// "186", "21 to 540"; "-" of none.
Cell points_cell(std::span<const long> points) {
  if (points.empty()) return {"-", kNeverReached};
  return {points.front() == points.back() ? fmt::format("{}", points.front())
                                          : fmt::format("{} to {}", points.front(), points.back()),
          static_cast<double>(points.back())};
}

}  // namespace

Sections rival_sections(const Evaluation& evaluation) {
  Section section{.id = "plugins", .title = "Plugins beside our methods at equal error"};
  section.text = R"(On the scenes whose law the plugin represents: how many it solves with
errors of x, of the worst contact and of the force of at most 1e-2 and 1e-6. Its least time there, over that of the fastest of the program's own methods
and over that of the fastest plain form of the literature, on the scenes that both solve: geometric mean (least
to largest). Over ours per point: of plugins that tell how many points of a curve they solved on the way to their
answer, the same of their time for one point. Fastest: scenes on which no other method of the run is as fast. Scenes that
a motion without contact solves are left out.)";
  section.table.header = {"method"};
  for (const double error : kHeadlineErrors) {
    section.table.header.push_back(fmt::format("to {:.0e}", error));
    for (const char* title :
         {"stability", "time over ours", "points", "over ours per point", "over plain forms", "fastest"})
      section.table.header.emplace_back(title);
  }
  for (const Rival& rival : rivals(evaluation)) {
    std::vector<Cell> row{rival.configuration};
    for (const RivalTimes& times : rival.at)
      row.insert(row.end(), {count_cell(times.reached, times.scenes),
                             stability_text(times.stable, times.unstable, times.reached),
                             ratio_cell(times.to_own), points_cell(times.points), ratio_cell(times.per_point),
                             ratio_cell(times.to_plain), count_cell(times.fastest)});
    section.table.rows.push_back(std::move(row));
  }
  return {std::move(section)};
}

Sections hand_over_sections(const Evaluation& evaluation) {
  Section section{.id = "hand-over",
                  .title = "Commands: own time and hand-over",
                  .text = R"(Methods that are commands and tell the time of their own computation, by
which they stand in all other tables. Hand-over is what passes beside it for every solve: the problem is written
and the answer read, the least of a round. Medians over the cases that were timed.)"};
  section.table.header = {"method", "cases", "own time", "hand-over", "hand-over / own time"};
  for (const HandOver& one : hand_overs(evaluation)) {
    const Measure ratio = one.own > 0.0 ? Measure(one.beside / one.own) : Measure();
    section.table.rows.push_back({one.configuration, count_cell(one.cases), time_cell(one.own),
                                  time_cell(one.beside), number_cell(ratio, "{:.2g}")});
  }
  return {std::move(section)};
}

}  // namespace signorini
