// Performance profiles over scenes.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr std::string_view kProfilePanels =
    R"(set multiplot layout {},{} margins {:.2f},0.99,{:.3f},{:.3f} spacing 0.03,{:.3f}
set logscale x
set xrange [1:{:.6e}]
set yrange [-0.02:1.02]
set ytics 0,0.25,1
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set format x '10^{{%T}}'
set xlabel 'time / fastest'
set ylabel 'share of scenes solved'
unset key
)";

/// The steps of one curve up to the right end of the panel.
std::string steps(const PerformanceProfile& profile, std::size_t configuration, double end) {
  std::string lines = fmt::format("1 {:.6f}\n", profile.share(configuration, 1.0));
  for (const double ratio : profile.ratios[configuration])
    lines += fmt::format("{:.6e} {:.6f}\n", ratio, profile.share(configuration, ratio));
  return lines + fmt::format("{:.6e} {:.6f}\n", end, profile.share(configuration, end));
}

double largest_ratio(const std::vector<PerformanceProfile>& profiles) {
  double largest = 10.0;
  for (const PerformanceProfile& profile : profiles) {
    for (const auto& ratios : profile.ratios) {
      if (!ratios.empty()) largest = std::max(largest, ratios.back());
    }
  }
  return largest;
}

}  // namespace

Figure profile_figure(const Evaluation& evaluation, std::size_t number, Column column) {
  const RankingGroup& group = evaluation.groups()[number];
  std::vector<PerformanceProfile> profiles;
  for (const double error : kProfileErrors)
    profiles.push_back(performance_profile(costs_to_error(group, time_axis(), error)));
  const double end = 1.5 * largest_ratio(profiles);
  const bool narrow = is_narrow(column);  // then the panels stand below each other
  const int columns = narrow ? 1 : 2, panels = static_cast<int>(kProfileErrors.size());
  constexpr double kPanel = 4.9, kBelow = 1.5, kAbove = 1.1;  // of a panel, of its axis, of its title [cm]
  const double key = key_height(group.configurations.size(), columns);
  const double stack = (kPanel + kBelow + kAbove) * (narrow ? panels : 1);
  Figure figure{
      .name = fmt::format("profile-{}", number + 1), .width = width_in(column, 18.0), .height = stack + key};
  figure.caption = fmt::format(
      "Performance profiles on {} scenes: the share of all of them that a method solves to the error above "
      "the panel within a factor of the time of the fastest. A failure is infinitely slow; a scene that no "
      "method solves counts.",
      group.scenes.size());
  figure.script = fmt::format(kProfilePanels, narrow ? panels : 1, narrow ? 1 : panels, narrow ? 0.23 : 0.11,
                              (key + kBelow) / figure.height, 1.0 - kAbove / figure.height,
                              narrow ? (kBelow + kAbove) / figure.height : 0.0, end);
  Canvas canvas;
  for (std::size_t p = 0; p < profiles.size(); ++p) {
    for (std::size_t c = 0; c < group.configurations.size(); ++c) {
      const LineStyle style = line_style(evaluation.place_of(group.configurations[c]));
      const auto block =
          canvas.add(steps(profiles[p], c, end),
                     fmt::format("{}, error {:.0e}", group.configurations[c], kProfileErrors[p]));
      canvas.plot(block, fmt::format("with steps {} notitle", style.line));
      canvas.plot(block, fmt::format("with points {} ps 0.6 notitle", style.filled));
    }
    figure.script += fmt::format("set title 'error 10^{{{:.0f}}}'\n{}{}", std::log10(kProfileErrors[p]),
                                 canvas.panel(), narrow ? "" : "set format y ''\nunset ylabel\n");
  }
  figure.data = canvas.data();
  std::vector<KeyEntry> keys;
  for (const std::string& configuration : group.configurations) {
    const LineStyle style = line_style(evaluation.place_of(configuration));
    keys.push_back({style.line + " " + style.mark, configuration});
  }
  figure.script += key_panel(keys, key / figure.height, columns) + "unset multiplot\n";
  return figure;
}

}  // namespace signorini
