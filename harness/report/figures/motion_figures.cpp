#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "harness/report/figures/drawn_waveform.hpp"
#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

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

constexpr std::string_view kImpactStyle = "lc rgb '#D55E00' pt 6 ps 0.9 lw 1.5";

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

/// The certified orbit or an answer: its line, its name in the key, its blocks.
struct DrawnMotion {
  std::string line = {}, title = {};
  std::optional<int> waveform = {}, portrait = {};
};

/// What is drawn of a scene at one contact.
struct DrawnMotions {
  double end = 0.0;                       ///< of the time axis [s]
  double range = 0.0;                     ///< of the orbit's x [m]
  std::optional<double> stop = {};        ///< where the contact closes [m]
  std::vector<DrawnMotion> motions = {};  ///< the orbit first
  std::optional<int> impacts = {};
  Canvas canvas = {};

  void add(const std::string& name, DrawnMotion motion, const Waveform& waveform, std::size_t place) {
    motion.waveform = canvas.add(waveform_lines(waveform, place),
                                 name + ": t [s], x [m], velocity [m/s], force [N], impulse so far [N s]");
    motion.portrait = canvas.add(portrait_lines(waveform, place),
                                 name + ": x [m], velocity [m/s], with points between samples");
    motions.push_back(std::move(motion));
  }
};

DrawnMotions drawn_motions(const Evaluation& evaluation, const KeptMotions& kept) {
  const auto [least, largest] = std::ranges::minmax(kept.orbit().x[kept.place]);
  DrawnMotions drawn{.end = kept.orbit().t.back(),
                     .range = largest - least,
                     .stop = stop_position(*kept.leader, kept.place)};
  drawn.add("certified orbit", {"lc rgb '#bbbbbb' lw 5", "certified orbit"}, kept.orbit(), kept.place);
  for (const auto& [result, place, motion] : kept.answers) {
    const LineStyle style = line_style(evaluation.place_of(result->choice->configuration));
    drawn.add(result->case_id, {style.line, result->choice->resolution}, motion, place);
  }
  if (drawn.stop)
    drawn.impacts =
        drawn.canvas.add(impact_lines_of(*kept.leader, kept.contact, drawn.end, *drawn.stop), "impacts");
  return drawn;
}

Figure waveform_figure(DrawnMotions& drawn, const std::string& scene, Column page) {
  constexpr std::array kSignals{"x [m]", "velocity [m/s]", "force of the stop [N]", "impulse so far [N s]"};
  std::vector<KeyEntry> keys;
  for (const DrawnMotion& motion : drawn.motions) keys.push_back({motion.line + " pt -1", motion.title});
  if (drawn.impacts) keys.insert(keys.begin() + 1, {std::string(kImpactStyle), "its impacts", "points"});
  constexpr std::size_t kFitsTwice = 36;  // letters
  const auto is_long = [](const KeyEntry& entry) { return entry.title.size() > kFitsTwice; };
  const int columns = is_narrow(page) || std::ranges::any_of(keys, is_long) ? 1 : 2;
  const double key = key_height(keys.size(), columns);
  Figure figure{.name = scene + "-waveforms", .width = width_in(page, 17.0), .height = 15.2 + key};
  figure.script = fmt::format(
      "{}set multiplot layout 4,1 margins {:.2f},0.98,{:.3f},0.98 spacing 0,0.03\nset xrange [0:{:.6g}]\n"
      "set format x ''\nunset key\n",
      kFrame, 1.9 / figure.width, (key + 1.3) / figure.height, drawn.end);
  if (drawn.stop)
    figure.script += fmt::format(
        "set arrow 1 from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead {1}\n"
        "set label 1 'stop' at graph 1, first {0:.6g} right offset 0,-0.6 font ',8' textcolor rgb "
        "'#D55E00'\n",
        *drawn.stop, kStopStyle);
  for (std::size_t panel = 0; panel < kSignals.size(); ++panel) {
    if (panel + 1 == kSignals.size()) figure.script += "set format x '%g'\nset xlabel 't [s]'\n";
    for (const DrawnMotion& motion : drawn.motions)
      drawn.canvas.plot(motion.waveform, fmt::format("using 1:{} with lines {}", panel + 2, motion.line));
    if (panel == 0) drawn.canvas.plot(drawn.impacts, fmt::format("with points {}", kImpactStyle));
    figure.script += fmt::format("set ylabel '{}'\n{}", kSignals[panel], drawn.canvas.panel());
    if (panel == 0) figure.script += "unset arrow\nunset label\n";
  }
  figure.script += key_panel(keys, key / figure.height, columns) + "unset multiplot\n";
  return figure;
}

Figure phase_figure(DrawnMotions& drawn, const std::string& scene, Column page) {
  constexpr int kTics = 5;
  Figure figure{.name = scene + "-phase",
                .width = width_in(page, 12.0),
                .height = is_narrow(page) ? kSingleColumn : 10.0};
  for (const DrawnMotion& motion : drawn.motions)
    drawn.canvas.plot(motion.portrait, "with lines " + motion.line);
  if (drawn.stop)
    figure.script = fmt::format("set arrow 1 from {0:.6g}, graph 0 to {0:.6g}, graph 1 nohead {1}\n",
                                *drawn.stop, kStopStyle);
  figure.script += fmt::format(
      "{}set xlabel 'x [m]'\nset ylabel 'velocity [m/s]'\nunset key\nset offsets graph 0.05, graph 0.05, "
      "graph 0.05, graph 0.05\nset xtics {:g}\n{}",
      kFrame, tic_step(drawn.range, kTics), drawn.canvas.panel());
  return figure;
}

}  // namespace

std::vector<Figure> motion_figures(const Evaluation& evaluation, const std::string& scene, Column column) {
  const KeptMotions kept = kept_motions(evaluation, scene);
  if (kept.answers.empty()) return {};
  DrawnMotions drawn = drawn_motions(evaluation, kept);
  std::vector<Figure> figures{waveform_figure(drawn, scene, column), phase_figure(drawn, scene, column)};
  figures[0].caption = fmt::format(
      "One period at contact {}: each method's coarsest solved resolution on the certified orbit; "
      "subharmonic "
      "answers are shifted by whole periods of the load to its phase. Impacts are jumps of the impulse; a "
      "method "
      "without impacts shows them as peaks of its force. Forces push the structure back: they are negative.",
      kept.contact);
  figures[1].caption = fmt::format(
      "Phase portrait at contact {}, with the stop as a wall; lines as in the waveforms.", kept.contact);
  for (Figure& figure : figures) figure.data = drawn.canvas.data();
  return figures;
}

}  // namespace signorini
