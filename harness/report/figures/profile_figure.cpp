#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

constexpr std::array kProfileErrors{1e-2, 1e-3, 1e-6};

constexpr std::string_view kProfilePanels =
    R"(set multiplot layout 1,{} margins 0.06,0.99,0.36,0.90 spacing 0.03,0
set logscale x
set xrange [1:{:.6e}]
set yrange [-0.02:1.02]
set ytics 0,0.25,1
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set format x '10^{{%T}}'
set xlabel 'time / fastest'
unset key
)";

/// The steps of one curve up to the right end of the panel.
std::string steps(const PerformanceProfile& profile, std::size_t configuration, double end) {
  std::string lines = fmt::format("1 {:.6f}\n", profile.share(configuration, 1.0));
  for (const double ratio : profile.ratios[configuration])
    lines += fmt::format("{:.6e} {:.6f}\n", ratio, profile.share(configuration, ratio));
  return lines + fmt::format("{:.6e} {:.6f}\n\n\n", end, profile.share(configuration, end));
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

Figure profile_figure(const Evaluation& evaluation, std::size_t number) {
  const RankingGroup& group = evaluation.groups()[number];
  std::vector<PerformanceProfile> profiles;
  for (const double error : kProfileErrors)
    profiles.push_back(performance_profile(costs_to_error(group, time_axis(), error)));
  const double end = 1.5 * largest_ratio(profiles);
  Figure figure{.name = fmt::format("profile-{}", number + 1), .width = 18.0, .height = 9.0};
  figure.caption = fmt::format(
      "Performance profiles on {} scenes: the share of all of them that a method solves to the error above "
      "the "
      "panel within a factor of the time of the fastest. A failure is infinitely slow; a scene that nobody "
      "solves counts.",
      group.scenes.size());
  figure.script = fmt::format(kProfilePanels, kProfileErrors.size(), end);
  int block = 0;
  for (std::size_t p = 0; p < profiles.size(); ++p) {
    std::string plots;
    for (std::size_t c = 0; c < group.configurations.size(); ++c) {
      figure.data += fmt::format("# {}, error {:.0e}\n{}", group.configurations[c], kProfileErrors[p],
                                 steps(profiles[p], c, end));
      const LineStyle style = line_style(evaluation.place_of(group.configurations[c]));
      plots +=
          fmt::format("{}data index {} with steps {} notitle, data index {} with points {} ps 0.6 notitle",
                      plots.empty() ? "" : ", \\\n  ", block, style.line, block, style.filled);
      ++block;
    }
    figure.script +=
        fmt::format("set title 'error {:.0e}'\nplot {}\nset format y ''\n", kProfileErrors[p], plots);
  }
  std::vector<KeyEntry> keys;
  for (const std::string& configuration : group.configurations) {
    const LineStyle style = line_style(evaluation.place_of(configuration));
    keys.push_back({style.line + " " + style.mark, configuration});
  }
  figure.script += key_panel(keys, 0.20, 4) + "unset multiplot\n";
  return figure;
}

}  // namespace signorini
