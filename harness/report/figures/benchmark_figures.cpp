// Work and precision on each scene, and performance profiles over scenes.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/report/document/cells.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// Blocks of data with their plot commands and the ranges of the axes.
struct Canvas {
  std::string data = {};
  std::string plots = {};
  int blocks = 0;
  double least_cost = kNeverReached, largest_cost = 0.0, least_error = kNeverReached, largest_error = 0.0;
};

void add_block(const std::string& comment, const std::string& lines, const std::string& how, Canvas& canvas) {
  if (lines.empty()) return;
  canvas.data += fmt::format("# {}\n{}\n\n", comment, lines);
  canvas.plots += fmt::format(", \\\n  data index {} with {} notitle", canvas.blocks++, how);
}

void stretch(double cost, double error, Canvas& canvas) {
  canvas.least_cost = std::min(canvas.least_cost, cost);
  canvas.largest_cost = std::max(canvas.largest_cost, cost);
  canvas.least_error = std::min(canvas.least_error, error);
  canvas.largest_error = std::max(canvas.largest_error, error);
}

/// Adds the work-precision curve of a study, its runs, and the runs whose errors are bounds.
void add_study(const ResolutionStudy& study, const LineStyle& style, const std::string& label,
               Canvas& canvas) {
  std::string curve, runs, bounds;
  for (const CurvePoint& point : pareto_curve(study, time_axis()))
    curve += fmt::format("{:.6e} {:.6e}\n", point.cost, *point.run->error);
  if (curve.empty()) return;
  for (const ScoredRun& run : study.runs) {
    const std::optional<double> seconds = time_axis().cost(*run.record);
    if (!run.error || !seconds) continue;
    stretch(*seconds, *run.error, canvas);
    std::string& list = run.bounded ? bounds : runs;
    list += fmt::format("{:.6e} {:.6e}  # {}\n", *seconds, *run.error, resolution_of(*run.record));
  }
  add_block(study.configuration + ", curve", curve, "lines " + style.line, canvas);
  add_block(study.configuration + ", runs", runs, fmt::format("points {} ps 1.1", style.filled), canvas);
  add_block(study.configuration + ", runs below ten error bars", bounds,
            fmt::format("points {} ps 1.1", style.hollow), canvas);
  canvas.plots += fmt::format(", \\\n  keyentry with linespoints {} {} title {}", style.line, style.mark,
                              gnuplot_string(label));
}

/// Ten error bars of the least certain orbit.
double floor_of(const std::vector<const ResolutionStudy*>& studies) {
  double floor = 0.0;
  for (const ResolutionStudy* study : studies) {
    for (const ScoredRun& run : study->runs) {
      if (run.error) floor = std::max(floor, measurable_error(*run.record));
    }
  }
  return floor;
}

std::string label_of(const ResolutionStudy& study) {
  const Record& record = *study.runs.front().record;
  if (study.eligibility != Eligibility::another_law || !record.law) return study.configuration;
  return fmt::format("{} ({})", study.configuration, law_text(*record.law));
}

constexpr std::string_view kAxes = R"(set logscale xy
set format '10^{{%T}}'
set xlabel 'time, set-up and solve [s]'
set ylabel '{}'
set xrange [{:.2e}:{:.2e}]
set yrange [{:.2e}:{:.2e}]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key outside right top vertical Left reverse samplen 3 spacing 1.2 noenhanced
floor = {:.6e}  # ten error bars of the least certain orbit
)";

Figure figure_of(const Evaluation& evaluation, const std::vector<const ResolutionStudy*>& studies,
                 const std::string& name, const std::string& error_label) {
  Canvas canvas;
  for (const ResolutionStudy* study : studies)
    add_study(*study, line_style(evaluation.place_of(study->configuration)), label_of(*study), canvas);
  if (canvas.blocks == 0) return {};
  const double floor = floor_of(studies);
  constexpr double kMargin = 3.0;
  Figure figure{.name = name, .data = canvas.data, .width = 17.0};
  figure.script =
      fmt::format(kAxes, error_label, canvas.least_cost / kMargin, canvas.largest_cost * kMargin,
                  std::min(canvas.least_error, floor) / kMargin, canvas.largest_error * kMargin, floor);
  figure.script +=
      "plot floor with lines lc rgb '#888888' dt 3 lw 1 title 'error bar x 10'" + canvas.plots + "\n";
  return figure;
}

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

std::vector<Figure> work_precision_figures(const Evaluation& evaluation, const std::string& scene) {
  std::vector<const ResolutionStudy*> competing, others;
  for (const ResolutionStudy& study : evaluation.studies()) {
    if (study.scene == scene)
      (study.eligibility == Eligibility::another_law ? others : competing).push_back(&study);
  }
  std::vector<Figure> figures{
      figure_of(evaluation, competing, scene + "-work-precision", "error of x [-]"),
      figure_of(evaluation, others, scene + "-other-laws", "error of x, own law [-]")};
  figures[0].caption =
      "Error against time. Each mark is a resolution; hollow ones lie below ten error bars of the orbit and "
      "are "
      "not ranked.";
  figures[1].caption =
      "The same for methods that represent another law than the scene's: errors against the motion under "
      "their "
      "own.";
  std::erase_if(figures, [](const Figure& figure) { return figure.data.empty(); });
  return figures;
}

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
