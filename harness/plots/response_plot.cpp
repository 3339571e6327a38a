#include "harness/plots/response_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

std::string line_of(double frequency, const std::vector<double>& amplitude) {
  return fmt::format("{:.10g} {:.8g}\n", frequency, largest_of(amplitude));
}

enum class Part { stable, unstable, unknown };

Part part_of(const BranchPoint& point) {
  switch (point.stability) {
    case OrbitStability::stable:
    case OrbitStability::elliptic:
      return Part::stable;
    case OrbitStability::unstable:
      return Part::unstable;
    default:
      return Part::unknown;
  }
}

/// The pieces of all branches between neighbours of which the first belongs to the part.
std::string pieces(const BranchDiagram& diagram, Part part) {
  std::string lines;
  for (const Branch& branch : diagram.branches) {
    bool drawing = false;
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const BranchPoint &from = branch.points[i], &to = branch.points[i + 1];
      // A grazing has no multipliers: the piece that begins there is what its end is.
      const bool belongs = part_of(from.stability == OrbitStability::undefined ? to : from) == part;
      if (belongs && !drawing) lines += line_of(from.parameter, from.amplitude);
      if (belongs) lines += line_of(to.parameter, to.amplitude);
      if (drawing && !belongs) lines += "\n";
      drawing = belongs;
    }
    if (drawing) lines += "\n";
  }
  return lines;
}

std::string steps(const std::vector<SweepPoint>& points) {
  std::string lines;
  for (const SweepPoint& point : points)
    if (point.status == Status::converged) lines += line_of(point.frequency, point.amplitude);
  return lines;
}

std::string marks(const std::vector<MethodResponse>& responses, SpecialKind kind) {
  std::string lines;
  for (const MethodResponse& response : responses)
    for (const Branch& branch : response.diagram.branches)
      for (const SpecialPoint& special : branch.special)
        if (special.kind == kind) lines += line_of(special.point.parameter, special.point.amplitude);
  return lines;
}

/// Data blocks and the plot command.
struct Plot {
  std::string data = {}, command = {};
  int blocks = 0;

  void add(const std::string& lines, const std::string& how) {
    if (lines.empty()) return;
    data += lines + "\n\n";
    command += fmt::format("{}data index {} with {}", blocks == 0 ? "plot " : ", \\\n  ", blocks, how);
    ++blocks;
  }
};

constexpr std::string_view kResponseFrame = R"(set grid back lc rgb '#dddddd' lw 0.5
set border 3
set tics nomirror
set key outside bottom center horizontal noenhanced Left reverse samplen 3
set ylabel 'amplitude [m]'
)";

}  // namespace

Figure response_plot(const std::string& scene, const std::vector<MethodResponse>& responses) {
  // gnuplot's hollow marks.
  constexpr std::array kMarks{
      std::pair{SpecialKind::fold, 10},           std::pair{SpecialKind::period_doubling, 4},
      std::pair{SpecialKind::neimark_sacker, 12}, std::pair{SpecialKind::branch_point, 6},
      std::pair{SpecialKind::grazing, 2},         std::pair{SpecialKind::contact_change, 1}};
  const bool over_frequency = responses.empty() || responses.front().parameter == kFrequency;
  const std::string abscissa = over_frequency ? "frequency of the load [rad/s]" : responses.front().parameter;
  Plot plot;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const MethodResponse& response = responses[i];
    const std::string colour = line_colour(i);
    const std::string title = gnuplot_string(response.method);
    bool titled = false;
    for (const auto& [part, style] :
         {std::pair{Part::stable, "lw 2.4"}, std::pair{Part::unstable, "lw 1.2 dt (12,8)"},
          std::pair{Part::unknown, "lw 1"}}) {
      const std::string lines = pieces(response.diagram, part);
      const std::string words = part == Part::unstable
                                    ? "title " + gnuplot_string(response.method + ", unstable")
                                : titled ? "notitle"
                                         : "title " + title;
      plot.add(lines, fmt::format("lines {} {} {}", colour, style, words));
      titled = titled || (!lines.empty() && part != Part::unstable);
    }
    plot.add(steps(response.steps), fmt::format("points {} pt 6 ps 0.5 title {}", colour, title));
  }
  for (const auto& [kind, mark] : kMarks)
    plot.add(marks(responses, kind), fmt::format("points lc rgb '#333333' pt {} ps 0.9 title {}", mark,
                                                 gnuplot_string(describe(kind))));
  if (plot.blocks == 0) plot.command = "set xrange [0:1]\nset yrange [0:1]\nplot 2 notitle";
  return {.name = "response",
          .caption = "Frequency response of " + scene,
          .script = fmt::format("{}set xlabel {} noenhanced\nset title {} noenhanced\n{}\n", kResponseFrame,
                                gnuplot_string(abscissa), gnuplot_string(scene), plot.command),
          .data = plot.data,
          .width = 16.0,
          .height = 11.0};
}

}  // namespace signorini
