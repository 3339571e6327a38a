#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/report/figures/figures.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

/// The coarsest answer of a study with a certified orbit whose motion is kept; null if there is none.
const Record* coarsest(const ResolutionStudy& study) {
  for (const ScoredRun& run : study.runs) {
    const auto& waveforms = run.record->waveforms;
    if (run.error && waveforms && waveforms->orbit && !waveforms->contacts.empty()) return run.record;
  }
  return nullptr;
}

std::vector<const Record*> drawn_on(const Evaluation& evaluation, const std::string& scene) {
  std::vector<const Record*> found;
  for (const ResolutionStudy& study : evaluation.studies()) {
    if (study.scene != scene || study.eligibility != Eligibility::ranked) continue;
    if (const Record* record = coarsest(study)) found.push_back(record);
  }
  return found;
}

/// The contact that exchanges most impulse, by its place among those kept.
std::size_t busiest_contact(const Waveform& orbit) {
  const auto total = [](const std::vector<double>& impulse) { return impulse.back(); };
  return static_cast<std::size_t>(std::ranges::min_element(orbit.impulse, {}, total) - orbit.impulse.begin());
}

std::string block_of(const std::string& name, const Waveform& waveform, std::size_t contact) {
  std::string lines =
      fmt::format("# {}: t [s], x [m], velocity [m/s], force [N], impulse so far [N s]\n", name);
  for (std::size_t i = 0; i < waveform.t.size(); ++i) {
    lines +=
        fmt::format("{:.4g} {:.4g} {:.4g} {:.4g} {:.4g}\n", waveform.t[i], waveform.x[contact][i],
                    waveform.velocity[contact][i], waveform.force[contact][i], waveform.impulse[contact][i]);
  }
  return lines + "\n\n";
}

/// Where this contact is kept in another record of the scene; the first if it is not.
std::size_t place_of_contact(const Waveforms& waveforms, int contact) {
  const auto found = std::find(waveforms.contacts.begin(), waveforms.contacts.end(), contact);
  return found == waveforms.contacts.end() ? 0 : static_cast<std::size_t>(found - waveforms.contacts.begin());
}

constexpr std::string_view kOrbitStyle = "lc rgb '#bbbbbb' lw 5";

LineStyle style_of(const Evaluation& evaluation, const Record& record) {
  return line_style(evaluation.place_of(configuration_of(record)));
}

std::string curves(const Evaluation& evaluation, const std::vector<const Record*>& drawn, int abscissa,
                   int ordinate, bool titled) {
  std::string plots = fmt::format("data index 0 using {}:{} with lines {} {}", abscissa, ordinate,
                                  kOrbitStyle, titled ? "title 'certified orbit'" : "notitle");
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    plots += fmt::format(", \\\n  data index {} using {}:{} with lines {} {}", i + 1, abscissa, ordinate,
                         style_of(evaluation, *drawn[i]).line,
                         titled ? "title " + gnuplot_string(resolution_of(*drawn[i])) : "notitle");
  }
  return "plot " + plots + "\n";
}

constexpr std::string_view kFrame = R"(set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
set key noenhanced Left reverse samplen 3
)";

constexpr std::string_view kPanels = R"(set multiplot layout 4,1 margins 0.11,0.98,0.25,0.98 spacing 0,0.03
set xrange [0:{:.6g}]
set format x ''
unset key
)";

constexpr std::string_view kPhaseAxes = R"(set xlabel 'x [m]'
set ylabel 'velocity [m/s]'
set key outside bottom center horizontal
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
)";

Figure waveform_figure(const Evaluation& evaluation, const std::vector<const Record*>& drawn,
                       const std::string& scene, double end) {
  Figure figure{.name = scene + "-waveforms", .width = 17.0, .height = 18.0};
  figure.script = std::string(kFrame) + fmt::format(kPanels, end);
  constexpr std::array kLabels{"x [m]", "velocity [m/s]", "force [N]", "impulse so far [N s]"};
  for (std::size_t panel = 0; panel < kLabels.size(); ++panel) {
    if (panel + 1 == kLabels.size()) figure.script += "set format x '%g'\nset xlabel 't [s]'\n";
    figure.script += fmt::format("set ylabel '{}'\n", kLabels[panel]) +
                     curves(evaluation, drawn, 1, static_cast<int>(panel) + 2, false);
  }
  std::vector<KeyEntry> keys{{std::string(kOrbitStyle) + " pt -1", "certified orbit"}};
  for (const Record* record : drawn)
    keys.push_back({style_of(evaluation, *record).line + " pt -1", resolution_of(*record)});
  figure.script += key_panel(keys, 0.18, 2) + "unset multiplot\n";
  return figure;
}

Figure phase_figure(const Evaluation& evaluation, const std::vector<const Record*>& drawn,
                    const std::string& scene) {
  Figure figure{.name = scene + "-phase", .width = 13.0, .height = 13.0};
  figure.script = std::string(kFrame) + std::string(kPhaseAxes) + curves(evaluation, drawn, 2, 3, true);
  return figure;
}

}  // namespace

std::vector<Figure> motion_figures(const Evaluation& evaluation, const std::string& scene) {
  const std::vector<const Record*> drawn = drawn_on(evaluation, scene);
  if (drawn.empty()) return {};
  const Waveforms& first = *drawn.front()->waveforms;
  const std::size_t place = busiest_contact(*first.orbit);
  const int contact = first.contacts[place];
  std::string data = block_of("certified orbit", *first.orbit, place);
  for (const Record* record : drawn) {
    const Waveforms& kept = *record->waveforms;
    data += block_of(record->case_id, kept.answer, place_of_contact(kept, contact));
  }
  std::vector<Figure> figures{waveform_figure(evaluation, drawn, scene, first.orbit->t.back()),
                              phase_figure(evaluation, drawn, scene)};
  figures[0].caption = fmt::format(
      "One period at contact {}: each method's coarsest solved resolution on the certified orbit. Impacts "
      "are "
      "jumps of the impulse; a method without impacts shows them as peaks of its force.",
      contact);
  figures[1].caption = fmt::format("Phase portrait at contact {}.", contact);
  for (Figure& figure : figures) figure.data = data;
  return figures;
}

}  // namespace signorini
