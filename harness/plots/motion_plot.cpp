#include "harness/plots/motion_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "harness/report/figures/canvas.hpp"
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

/// The contact with the largest impulse over the period, by its place among those kept.
std::size_t busiest(const Waveform& motion) {
  const auto total = [](const std::vector<double>& impulse) {
    return impulse.empty() ? 0.0 : impulse.back();
  };
  return static_cast<std::size_t>(std::ranges::min_element(motion.impulse, {}, total) -
                                  motion.impulse.begin());
}

constexpr int kPortraitTics = 5;

/// With the stop, which is drawn too.
double range_of_displacement(const std::vector<double>& x, double gap) {
  const auto [least, largest] = std::ranges::minmax(x);
  return std::max(largest, gap) - std::min(least, gap);
}

/// Instants of the impacts of one contact within the motion drawn [s].
std::string impact_lines(const Record& record, int contact, double gap) {
  std::string lines;
  for (const OrbitEvent& event : record.certificate.events)
    if (event.contact == contact && event.kind == ContactEvent::Kind::impact)
      lines += fmt::format("{:.8g} {:.8g}\n", event.time, gap);
  return lines;
}

constexpr std::string_view kMotionFrame = R"(set multiplot layout {},{} title {} noenhanced
set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror font ',8'
unset key
)";

}  // namespace

Figure motion_plot(const Scene& scene, const Record& record, const Waveforms& waveforms, Column column) {
  const std::size_t place = busiest(waveforms.answer);
  const int contact = waveforms.contacts[place];
  const double gap = scene.problem.contacts[static_cast<std::size_t>(contact)].gap;
  Canvas canvas;
  const auto answer =
      canvas.add(motion_block(waveforms.answer, place), "t [s], x [m], velocity [m/s], impulse so far [N s]");
  const auto orbit = waveforms.orbit
                         ? canvas.add(motion_block(*waveforms.orbit, place), "the certified orbit")
                         : std::nullopt;
  const auto impacts = canvas.add(impact_lines(record, contact, gap), "impacts");
  const auto portrait = canvas.add(portrait_lines(waveforms.answer, place),
                                   "x [m], velocity [m/s], with points between samples");
  const auto orbit_portrait =
      waveforms.orbit ? canvas.add(portrait_lines(*waveforms.orbit, place), "the same of the orbit")
                      : std::nullopt;
  const auto draw = [&](std::optional<int> below, std::optional<int> above, int column) {
    canvas.plot(below, fmt::format("using 1:{} with lines lc rgb '#bbbbbb' lw 5", column));
    canvas.plot(above, fmt::format("using 1:{} with lines lc rgb '#0072B2' lw 1.6", column));
  };
  constexpr double kUsualWidth = 17.0, kHeight = 13.0, kNarrowHeight = 20.0;  // [cm]
  const bool narrow = is_narrow(column);  // then the four panels stand below each other
  Figure figure{.name = "motion",
                .caption = record.case_id,
                .width = width_in(column, kUsualWidth),
                .height = narrow ? kNarrowHeight : kHeight};
  figure.script = fmt::format(kMotionFrame, narrow ? 4 : 2, narrow ? 1 : 2,
                              gnuplot_string(fmt::format("{}, contact {}", record.case_id, contact)));
  figure.script += fmt::format("set xrange [0:{:.8g}]\nset xlabel 't [s]'\nset ylabel 'x [m]'\n",
                               waveforms.answer.t.back());
  canvas.plot(fmt::format("{:.10g} with lines lc rgb '#D55E00' dt (12,6) lw 1.2", gap));
  draw(orbit, answer, 2);
  canvas.plot(impacts, "with points lc rgb '#D55E00' pt 7 ps 0.6");
  figure.script += canvas.panel();
  draw(orbit, answer, 3);
  figure.script += "set ylabel 'velocity [m/s]'\n" + canvas.panel();
  draw(orbit, answer, 4);
  figure.script += "set ylabel 'impulse so far [N s]'\n" + canvas.panel();
  draw(orbit_portrait, portrait, 2);
  figure.script += fmt::format(
      "set xrange [*:*]\nset xtics {2:g}\nset xlabel 'x [m]'\nset ylabel 'velocity [m/s]'\nset arrow 1 from "
      "{0:.10g}, graph 0 "
      "to {0:.10g}, graph "
      "1 nohead lc rgb '#D55E00' dt (12,6) lw 1.2\n{1}unset multiplot\n",
      gap, canvas.panel(), tic_step(range_of_displacement(waveforms.answer.x[place], gap), kPortraitTics));
  figure.data = canvas.data();
  return figure;
}

}  // namespace signorini
