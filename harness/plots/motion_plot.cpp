#include "harness/plots/motion_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

std::string motion_block(const Waveform& motion, std::size_t place) {
  std::string lines = "# t [s], x [m], velocity [m/s], impulse so far [N s]\n";
  for (std::size_t i = 0; i < motion.t.size(); ++i)
    lines += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", motion.t[i], motion.x[place][i],
                         motion.velocity[place][i], motion.impulse[place][i]);
  return lines + "\n\n";
}

/// The contact with the largest impulse over the period, by its place among those kept.
std::size_t busiest(const Waveform& motion) {
  const auto total = [](const std::vector<double>& impulse) {
    return impulse.empty() ? 0.0 : impulse.back();
  };
  return static_cast<std::size_t>(std::ranges::min_element(motion.impulse, {}, total) -
                                  motion.impulse.begin());
}

/// Instants of the impacts of one contact within the motion drawn [s].
std::string impact_lines(const Record& record, int contact, double gap) {
  std::string lines;
  for (const OrbitEvent& event : record.certificate.events)
    if (event.contact == contact && event.kind == ContactEvent::Kind::impact)
      lines += fmt::format("{:.8g} {:.8g}\n", event.time, gap);
  return lines.empty() ? lines : lines + "\n\n";
}

constexpr std::string_view kMotionFrame = R"(set multiplot layout 2,2 title {} noenhanced
set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror font ',8'
unset key
)";

}  // namespace

Figure motion_plot(const Scene& scene, const Record& record, const Waveforms& waveforms) {
  const std::size_t place = busiest(waveforms.answer);
  const int contact = waveforms.contacts[place];
  const double gap = scene.problem.contacts[static_cast<std::size_t>(contact)].gap;
  const std::string impacts = impact_lines(record, contact, gap);
  Figure figure{.name = "motion", .caption = record.case_id, .width = 17.0, .height = 13.0};
  figure.data = motion_block(waveforms.answer, place);
  int blocks = 1;
  std::optional<int> orbit_block, impact_block;
  if (waveforms.orbit) {
    figure.data += motion_block(*waveforms.orbit, place);
    orbit_block = blocks++;
  }
  if (!impacts.empty()) {
    figure.data += impacts;
    impact_block = blocks++;
  }
  const auto curves = [&](int abscissa, int ordinate) {
    std::string plots;
    if (orbit_block)
      plots += fmt::format("data index {} using {}:{} with lines lc rgb '#bbbbbb' lw 5, \\\n  ", *orbit_block,
                           abscissa, ordinate);
    return plots +
           fmt::format("data index 0 using {}:{} with lines lc rgb '#0072B2' lw 1.6", abscissa, ordinate);
  };
  const double end = waveforms.answer.t.back();
  figure.script =
      fmt::format(kMotionFrame, gnuplot_string(fmt::format("{}, contact {}", record.case_id, contact)));
  figure.script += fmt::format("set xrange [0:{:.8g}]\nset xlabel 't [s]'\nset ylabel 'x [m]'\n", end);
  figure.script +=
      fmt::format("plot {:.10g} with lines lc rgb '#D55E00' dt (12,6) lw 1.2, \\\n  {}", gap, curves(1, 2));
  if (impact_block)
    figure.script +=
        fmt::format(", \\\n  data index {} with points lc rgb '#D55E00' pt 7 ps 0.6", *impact_block);
  figure.script += "\nset ylabel 'velocity [m/s]'\nplot " + curves(1, 3);
  figure.script += "\nset ylabel 'impulse so far [N s]'\nplot " + curves(1, 4);
  figure.script += fmt::format(
      "\nset xrange [*:*]\nset xlabel 'x [m]'\nset ylabel 'velocity [m/s]'\nset arrow 1 from {0:.10g}, graph "
      "0 to "
      "{0:.10g}, graph 1 nohead lc rgb '#D55E00' dt (12,6) lw 1.2\nplot {1}\nunset multiplot\n",
      gap, curves(2, 3));
  return figure;
}

}  // namespace signorini
