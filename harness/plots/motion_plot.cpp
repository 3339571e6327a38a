#include "harness/plots/motion_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "harness/plots/drawn_stops.hpp"
#include "harness/report/figures/drawn_waveform.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

std::string motion_block(const Waveform& motion, std::size_t place) {
  std::string lines;
  for (std::size_t i = 0; i < motion.t.size(); ++i)
    lines += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", motion.t[i], motion.x[place][i],
                         motion.velocity[place][i], motion.impulse[place][i]);
  return lines;
}

/// Instants of the impacts on these stops within the motion drawn [s], and where they are [m].
std::string impact_lines(const Record& record, const std::vector<DrawnStop>& stops) {
  std::string lines;
  for (const OrbitEvent& event : record.certificate.events) {
    const auto stop = std::ranges::find(stops, event.contact, &DrawnStop::contact);
    if (stop != stops.end() && event.kind == ContactEvent::Kind::impact)
      lines += fmt::format("{:.8g} {:.8g}\n", event.time, stop->place);
  }
  return lines;
}

}  // namespace

Figure motion_plot(const Scene& scene, const Record& record, const Waveforms& waveforms, Column column) {
  const std::size_t place = busiest_place(waveforms.answer);
  const int contact = waveforms.contacts[place];
  const std::vector<DrawnStop> stops = stops_of(scene.problem, contact);
  Canvas canvas;
  const auto answer =
      canvas.add(motion_block(waveforms.answer, place), "t [s], x [m], velocity [m/s], impulse so far [N s]");
  const auto orbit = waveforms.orbit
                         ? canvas.add(motion_block(*waveforms.orbit, place), "the certified orbit")
                         : std::nullopt;
  const auto impacts = canvas.add(impact_lines(record, stops), "impacts");
  const auto portrait = canvas.add(portrait_lines(waveforms.answer, place),
                                   "x [m], velocity [m/s], with points between samples");
  const auto orbit_portrait =
      waveforms.orbit ? canvas.add(portrait_lines(*waveforms.orbit, place), "the same of the orbit")
                      : std::nullopt;
  const auto draw = [&](std::optional<int> below, std::optional<int> above, int column) {
    canvas.plot(below, fmt::format("using 1:{} with lines lc rgb '#bbbbbb' lw 5", column));
    canvas.plot(above, fmt::format("using 1:{} with lines lc rgb '#0072B2' lw 1.6", column));
  };
  const bool narrow = is_narrow(column);  // then the four panels stand below each other
  Figure figure{.name = "motion",
                .caption = record.case_id,
                .width = width_in(column, 17.0),
                .height = narrow ? 20.0 : 13.0};
  const std::string title = fmt::format("{}, contact {}{}", record.case_id, contact,
                                        orbit && !narrow ? " (broad: the certified orbit)" : "");
  figure.script =
      panels(narrow ? 4 : 2, narrow ? 1 : 2, fmt::format(" title {} noenhanced", gnuplot_string(title))) +
      fmt::format(
          "set offsets 0, 0, graph 0.05, graph 0.05\nset xrange [0:{:.8g}]\nset xlabel 't [s]'\n"
          "set ylabel 'x [m]'\n",
          waveforms.answer.t.back());
  draw_stops(stops, canvas);
  draw(orbit, answer, 2);
  canvas.plot(impacts, "with points lc rgb '#D55E00' pt 7 ps 0.7");
  figure.script += canvas.panel();
  draw(orbit, answer, 3);
  figure.script += "set ylabel 'velocity [m/s]'\n" + canvas.panel();
  draw(orbit, answer, 4);
  figure.script += "set ylabel 'impulse so far [N s]'\n" + canvas.panel();
  draw(orbit_portrait, portrait, 2);
  figure.script += fmt::format(
      "set xrange [*:*]\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n{}set xlabel 'x [m]'\n"
      "set ylabel 'velocity [m/s]'\n{}unset multiplot\n",
      abscissa_commands(waveforms.answer.x[place], stops, 5), canvas.panel());
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
