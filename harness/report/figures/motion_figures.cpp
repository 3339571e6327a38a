#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "harness/report/figures/canvas.hpp"
#include "harness/report/figures/drawn_waveform.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"
#include "harness/report/figures/kept_motions.hpp"

namespace signorini {

namespace {

std::string waveform_lines(const Waveform& waveform, std::size_t contact) {
  std::string lines;
  for (std::size_t i = 0; i < waveform.t.size(); ++i) {
    lines +=
        fmt::format("{:.4g} {:.4g} {:.4g} {:.4g} {:.4g}\n", waveform.t[i], waveform.x[contact][i],
                    waveform.velocity[contact][i], waveform.force[contact][i], waveform.impulse[contact][i]);
  }
  return lines;
}

constexpr std::string_view kOrbitStyle = "lc rgb '#bbbbbb' lw 5";
constexpr std::string_view kImpactStyle = "lc rgb '#D55E00' pt 6 ps 0.9 lw 1.5";
constexpr int kDisplacement = 2;  // column of the waveforms

LineStyle style_of(const Evaluation& evaluation, const KeptAnswer& answer) {
  return line_style(evaluation.place_of(answer.result->choice->configuration));
}

/// What is drawn of a scene at one contact: blocks of the certified orbit, then of each answer.
struct DrawnMotions {
  KeptMotions kept = {};
  double end = 0.0;                 ///< of the time axis [s]
  std::optional<double> stop = {};  ///< where the contact closes [m]
  Canvas canvas = {};
  std::vector<std::optional<int>> waveforms = {}, portraits = {};  ///< the orbit first
  std::optional<int> impacts = {};
};

/// The panel of two columns of the waveforms.
std::string waveform_panel(const Evaluation& evaluation, DrawnMotions& drawn, int column) {
  drawn.canvas.plot(drawn.waveforms[0], fmt::format("using 1:{} with lines {}", column, kOrbitStyle));
  for (std::size_t i = 0; i < drawn.kept.answers.size(); ++i)
    drawn.canvas.plot(drawn.waveforms[i + 1], fmt::format("using 1:{} with lines {}", column,
                                                          style_of(evaluation, drawn.kept.answers[i]).line));
  if (column == kDisplacement)
    drawn.canvas.plot(drawn.impacts, std::string("with points ") + std::string(kImpactStyle));
  return drawn.canvas.panel();
}

/// "set arrow ...": the stop, across the panel at a height, or upright as a wall.
std::string stop_line(const DrawnMotions& drawn, bool upright) {
  if (!drawn.stop) return "";
  return upright
             ? fmt::format("set arrow 1 from {0:.6g}, graph 0 to {0:.6g}, graph 1 nohead {1}\n", *drawn.stop,
                           kStopStyle)
             : fmt::format(
                   "set arrow 1 from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead {1}\n"
                   "set label 1 'stop' at graph 1, first {0:.6g} right offset 0,-0.6 font ',8' textcolor rgb "
                   "'#D55E00'\n",
                   *drawn.stop, kStopStyle);
}

constexpr std::string_view kFrame = R"(set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
)";

constexpr std::string_view kPanels =
    R"(set multiplot layout 4,1 margins {:.2f},0.98,{:.3f},0.98 spacing 0,0.03
set xrange [0:{:.6g}]
set format x ''
unset key
)";

constexpr std::string_view kPhaseAxes = R"(set xlabel 'x [m]'
set ylabel 'velocity [m/s]'
unset key
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
)";

Figure waveform_figure(const Evaluation& evaluation, DrawnMotions& drawn, const std::string& scene,
                       Column column_of_page) {
  std::vector<KeyEntry> keys{{std::string(kOrbitStyle) + " pt -1", "certified orbit"}};
  if (drawn.impacts) keys.push_back({std::string(kImpactStyle), "its impacts", "points"});
  for (const KeptAnswer& answer : drawn.kept.answers)
    keys.push_back({style_of(evaluation, answer).line + " pt -1", answer.result->choice->resolution});
  constexpr std::size_t kFitsTwice = 36;  // letters
  const bool wide = is_narrow(column_of_page) || std::ranges::any_of(keys, [](const KeyEntry& entry) {
                      return entry.title.size() > kFitsTwice;
                    });
  const int columns = wide ? 1 : 2;
  constexpr double kPanelsAndAxis = 15.2, kAxis = 1.3, kLabels = 1.9;  // [cm]
  const double key = key_height(keys.size(), columns);
  Figure figure{
      .name = scene + "-waveforms", .width = width_in(column_of_page, 17.0), .height = kPanelsAndAxis + key};
  figure.script = std::string(kFrame) +
                  fmt::format(kPanels, kLabels / figure.width, (key + kAxis) / figure.height, drawn.end);
  constexpr std::array kSignals{"x [m]", "velocity [m/s]", "force of the stop [N]", "impulse so far [N s]"};
  for (std::size_t panel = 0; panel < kSignals.size(); ++panel) {
    const int column = static_cast<int>(panel) + kDisplacement;
    if (panel + 1 == kSignals.size()) figure.script += "set format x '%g'\nset xlabel 't [s]'\n";
    if (column == kDisplacement) figure.script += stop_line(drawn, false);
    figure.script +=
        fmt::format("set ylabel '{}'\n", kSignals[panel]) + waveform_panel(evaluation, drawn, column);
    if (column == kDisplacement) figure.script += "unset arrow\nunset label\n";
  }
  figure.script += key_panel(keys, key / figure.height, columns) + "unset multiplot\n";
  return figure;
}

Figure phase_figure(const Evaluation& evaluation, DrawnMotions& drawn, const std::string& scene,
                    Column column) {
  constexpr double kUsualWidth = 12.0, kHeight = 10.0;  // [cm]
  Figure figure{.name = scene + "-phase",
                .width = width_in(column, kUsualWidth),
                .height = is_narrow(column) ? kSingleColumn : kHeight};
  drawn.canvas.plot(drawn.portraits[0], fmt::format("with lines {}", kOrbitStyle));
  for (std::size_t i = 0; i < drawn.kept.answers.size(); ++i)
    drawn.canvas.plot(drawn.portraits[i + 1],
                      fmt::format("with lines {}", style_of(evaluation, drawn.kept.answers[i]).line));
  constexpr int kTics = 5;
  const auto [least, largest] = std::ranges::minmax(drawn.kept.orbit().x[drawn.kept.place]);
  figure.script = std::string(kFrame) + std::string(kPhaseAxes) +
                  fmt::format("set xtics {:g}\n", tic_step(largest - least, kTics)) + stop_line(drawn, true) +
                  drawn.canvas.panel();
  return figure;
}

/// The impacts of the orbit at a contact, repeated over the time axis: t [s], x [m].
std::string impact_lines_of(const Record& record, int contact, double end, double stop) {
  const double period = end / std::max(1.0, std::round(end / record.period.value_or(end)));
  std::string lines;
  for (const OrbitEvent& event : record.certificate.events) {
    if (event.contact != contact || event.kind != ContactEvent::Kind::impact) continue;
    for (double t = event.time; t <= end * (1.0 + 1e-9) && period > 0.0; t += period)
      lines += fmt::format("{:.4g} {:.4g}\n", t, stop);
  }
  return lines;
}

DrawnMotions motions_drawn(KeptMotions kept) {
  DrawnMotions drawn{.end = kept.orbit().t.back(), .stop = stop_position(*kept.leader, kept.place)};
  const auto add = [&](const std::string& name, const Waveform& waveform, std::size_t at) {
    drawn.waveforms.push_back(
        drawn.canvas.add(waveform_lines(waveform, at),
                         name + ": t [s], x [m], velocity [m/s], force [N], impulse so far [N s]"));
    drawn.portraits.push_back(drawn.canvas.add(
        portrait_lines(waveform, at), name + ": x [m], velocity [m/s], with points between samples"));
  };
  add("certified orbit", kept.orbit(), kept.place);
  for (const auto& [result, place, motion] : kept.answers) add(result->case_id, motion, place);
  if (drawn.stop)
    drawn.impacts =
        drawn.canvas.add(impact_lines_of(*kept.leader, kept.contact, drawn.end, *drawn.stop), "impacts");
  drawn.kept = std::move(kept);
  return drawn;
}

}  // namespace

std::vector<Figure> motion_figures(const Evaluation& evaluation, const std::string& scene, Column column) {
  KeptMotions kept = kept_motions(evaluation, scene);
  if (kept.answers.empty()) return {};
  const int contact = kept.contact;
  DrawnMotions drawn = motions_drawn(std::move(kept));
  std::vector<Figure> figures{waveform_figure(evaluation, drawn, scene, column),
                              phase_figure(evaluation, drawn, scene, column)};
  figures[0].caption = fmt::format(
      "One period at contact {}: each method's coarsest solved resolution on the certified orbit; "
      "subharmonic answers are shifted by whole periods of the load to its phase. Impacts are jumps of the "
      "impulse; a method without impacts shows them as peaks of its force. Forces push the structure back: "
      "they are negative.",
      contact);
  figures[1].caption = fmt::format(
      "Phase portrait at contact {}, with the stop as a wall; lines as in the waveforms.", contact);
  for (Figure& figure : figures) figure.data = drawn.canvas.data();
  return figures;
}

}  // namespace signorini
