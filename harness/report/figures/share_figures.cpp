// Shares of what a method solves: within a factor of the fastest time, and within a time.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr std::string_view kSharePanels =
    R"(set multiplot layout {},{} margins {:.2f},0.99,{:.3f},{:.3f} spacing 0.03,{:.3f}
set logscale x
set xrange [{:.6e}:{:.6e}]
set yrange [-0.02:1.02]
set ytics 0,0.25,1
set format x '10^{{%T}}'
set xlabel '{}'
set ylabel '{}'
unset key
)";

/// A panel: its title, words for the data, and of each configuration the values at which its curve steps up
/// by one, ascending; `of` steps are the whole.
struct Panel {
  std::string title = {}, words = {};
  std::vector<std::vector<double>> steps = {};
  std::size_t of = 1;
};

/// What the panels of a figure share.
struct Axes {
  double begin = 1.0, end = 10.0;
  std::string x = {}, y = {};
};

/// The steps of one curve from the left end of the panel to the right one.
std::string steps_text(const Panel& panel, std::size_t configuration, const Axes& axes) {
  const std::vector<double>& steps = panel.steps[configuration];
  const auto share = [&](double value) {
    return static_cast<double>(std::ranges::upper_bound(steps, value) - steps.begin()) /
           static_cast<double>(panel.of);
  };
  std::string lines = fmt::format("{:.6g} {:.6f}\n", axes.begin, share(axes.begin));
  for (const double value : steps)
    if (std::isfinite(value)) lines += fmt::format("{:.6e} {:.6f}\n", value, share(value));
  return lines + fmt::format("{:.6e} {:.6f}\n", axes.end, share(axes.end));
}

/// Panels beside each other, in a single column below each other, and the key below.
void draw_panels(const Evaluation& evaluation, const RankingGroup& group, Column column,
                 const std::vector<Panel>& panels, const Axes& axes, Figure& figure) {
  const bool narrow = is_narrow(column);
  const int keys_beside = narrow ? 1 : 2, count = static_cast<int>(panels.size());
  constexpr double kPanel = 4.9, kBelow = 1.5, kAbove = 1.1;  // of a panel, of its axis, of its title [cm]
  const double key = key_height(group.configurations.size(), keys_beside);
  figure.width = width_in(column, 18.0);
  figure.height = (kPanel + kBelow + kAbove) * (narrow ? count : 1) + key;
  figure.script = std::string(kFrame) + fmt::format(kSharePanels, narrow ? count : 1, narrow ? 1 : count,
                                                    narrow ? 0.23 : 0.11, (key + kBelow) / figure.height,
                                                    1.0 - kAbove / figure.height,
                                                    narrow ? (kBelow + kAbove) / figure.height : 0.0,
                                                    axes.begin, axes.end, axes.x, axes.y);
  Canvas canvas;
  std::vector<KeyEntry> keys;
  for (const std::string& configuration : group.configurations) {
    const LineStyle style = line_style(evaluation.place_of(configuration));
    keys.push_back({style.line + " " + style.mark, configuration});
  }
  for (const Panel& panel : panels) {
    for (std::size_t c = 0; c < group.configurations.size(); ++c) {
      const LineStyle style = line_style(evaluation.place_of(group.configurations[c]));
      const auto block =
          canvas.add(steps_text(panel, c, axes), fmt::format("{}, {}", group.configurations[c], panel.words));
      canvas.plot(block, fmt::format("with steps {} notitle", style.line));
      canvas.plot(block, fmt::format("with points {} ps 0.6 notitle", style.filled));
    }
    figure.script += fmt::format("set title '{}'\n{}{}", panel.title, canvas.panel(),
                                 narrow ? "" : "set format y ''\nunset ylabel\n");
  }
  figure.data = canvas.data();
  figure.script += key_panel(keys, key / figure.height, keys_beside) + "unset multiplot\n";
}

/// The least and the largest finite step of a panel; nothing where there is none.
std::optional<std::pair<double, double>> range_of(const Panel& panel) {
  std::optional<std::pair<double, double>> range;
  for (const auto& steps : panel.steps) {
    for (const double value : steps) {
      if (!std::isfinite(value)) continue;
      if (!range) range = {value, value};
      range = {std::min(range->first, value), std::max(range->second, value)};
    }
  }
  return range;
}

constexpr double kMargin = 1.5;  // from the last step to the end of a panel, a factor

}  // namespace

Figure profile_figure(const Evaluation& evaluation, std::size_t number, Column column) {
  const RankingGroup& group = evaluation.groups()[number];
  Axes axes{.x = "time / fastest", .y = "share of scenes solved"};
  std::vector<Panel> panels;
  for (const double error : kProfileErrors) {
    PerformanceProfile profile = performance_profile(costs_to_error(group, time_axis(), error));
    panels.push_back({.title = fmt::format("error 10^{{{:.0f}}}", std::log10(error)),
                      .words = fmt::format("error {:.0e}", error),
                      .steps = std::move(profile.ratios),
                      .of = static_cast<std::size_t>(profile.scenes)});
    if (const auto range = range_of(panels.back())) axes.end = std::max(axes.end, range->second);
  }
  axes.end *= kMargin;
  Figure figure{.name = fmt::format("profile-{}", number + 1)};
  figure.caption = fmt::format(
      "Performance profiles on {} scenes: the share of all of them that a method solves to the error above "
      "the panel within a factor of the time of the fastest. A failure is infinitely slow; a scene that no "
      "method solves counts.",
      group.scenes.size());
  draw_panels(evaluation, group, column, panels, axes, figure);
  return figure;
}

Figure distribution_figure(const Evaluation& evaluation, std::size_t number, Column column) {
  const RankingGroup& group = evaluation.groups()[number];
  Panel panel{.title = "all targets", .words = "all targets", .steps = costs_to_targets(group, time_axis())};
  panel.of = std::max<std::size_t>(1, kErrorLevels.size() * group.scenes.size());
  Axes axes{.x = "time [s]", .y = "share of targets reached"};
  if (const auto range = range_of(panel)) {
    axes.begin = range->first / kMargin;
    axes.end = range->second * kMargin;
  }
  Figure figure{.name = fmt::format("distribution-{}", number + 1)};
  figure.caption = fmt::format(
      "Share of targets, each of {} scenes with each of {} errors, that a method reaches within a time: the "
      "empirical distribution function of the time to a target.",
      group.scenes.size(), kErrorLevels.size());
  draw_panels(evaluation, group, column, {panel}, axes, figure);
  return figure;
}

}  // namespace signorini
