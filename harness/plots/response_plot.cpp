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

enum class Stability { stable, unstable, unknown };

Stability part_of(const SolutionPoint& point) {
  switch (point.stability) {
    case OrbitStability::stable:
    case OrbitStability::elliptic:
      return Stability::stable;
    case OrbitStability::unstable:
      return Stability::unstable;
    default:
      return Stability::unknown;
  }
}

/// What is drawn of a point: its amplitude, or one displacement for each forcing period; of the contact that
/// moves most.
std::vector<double> ordinates(const SolutionPoint& point, ResponseOrdinate ordinate) {
  if (ordinate == ResponseOrdinate::amplitude) return {largest_of(point.amplitude)};
  if (point.amplitude.empty() || point.motion.rows() < point.order) return {};
  const auto contact = std::ranges::max_element(point.amplitude) - point.amplitude.begin();
  const Eigen::Index phases = point.motion.rows() / point.order;
  std::vector<double> found;
  for (Eigen::Index period = 0; period < point.order; ++period)
    found.push_back(point.motion(period * phases, contact));
  return found;
}

/// A point of a curve that is drawn: one of the branch, or a special one between two of these.
struct Vertex {
  const SolutionPoint* point = nullptr;
  bool special = false;
  Measure ordinate = {};  ///< empty where the point does not keep it

  [[nodiscard]] std::string line() const {
    return fmt::format("{:.10g} {:.8g}\n", point->parameter, *ordinate);
  }
};

/// Those of a branch with their `number`-th ordinates, in their order; special ones that have one.
std::vector<Vertex> vertices_of(const Branch& branch, ResponseOrdinate ordinate, std::size_t number) {
  std::vector<Vertex> vertices;
  const auto add = [&](const SolutionPoint& point, bool special) {
    const std::vector<double> all = ordinates(point, ordinate);
    const Measure own = number < all.size() ? Measure(all[number]) : Measure();
    if (!special || own) vertices.push_back({&point, special, own});
  };
  auto special = branch.special.begin();
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    for (; special != branch.special.end() && special->after <= i; ++special) add(special->point, true);
    add(branch.points[i], false);
  }
  return vertices;
}

/// What a curve is between two vertices. It changes at special points: a piece that begins at one, or at a
/// grazing, which has no multipliers, is what its end is.
Stability part_between(const Vertex& from, const Vertex& to) {
  const bool of_end = from.special || from.point->stability == OrbitStability::undefined;
  return part_of(of_end && !to.special ? *to.point : *from.point);
}

/// The pieces of one curve of a branch, its `number`-th ordinate, that belong to the part.
std::string pieces_of(const Branch& branch, Stability part, ResponseOrdinate ordinate, std::size_t number) {
  std::string lines;
  bool drawing = false;
  const std::vector<Vertex> vertices = vertices_of(branch, ordinate, number);
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const Vertex &from = vertices[i], &to = vertices[i + 1];
    const bool belongs = from.ordinate && to.ordinate && part_between(from, to) == part;
    if (belongs) lines += (drawing ? "" : from.line()) + to.line();
    if (drawing && !belongs) lines += "\n";
    drawing = belongs;
  }
  return drawing ? lines + "\n" : lines;
}

/// Those of all branches.
std::string pieces(const BranchDiagram& diagram, Stability part, ResponseOrdinate ordinate) {
  std::string lines;
  for (const Branch& branch : diagram.branches) {
    if (branch.points.empty()) continue;  // none at the values asked for
    const auto order = static_cast<std::size_t>(branch.points.front().order);
    for (std::size_t i = 0; i < (ordinate == ResponseOrdinate::amplitude ? 1 : order); ++i)
      lines += pieces_of(branch, part, ordinate, i);
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

/// Points of the attractors that repeat, or of those that do not.
std::string attractor_points(const std::vector<AttractorsAt>& all, ResponseOrdinate ordinate, bool repeats) {
  std::string lines;
  for (const AttractorsAt& at : all) {
    for (const Attractor& one : at.attractors) {
      if (one.verdict == LongRun::undecided || one.verdict == LongRun::unbounded) continue;
      if (repeats != (one.verdict == LongRun::periodic || one.verdict == LongRun::at_rest)) continue;
      if (ordinate == ResponseOrdinate::amplitude) {
        lines += line_of(at.value, {one.amplitude()});
      } else {
        for (const double x : one.once_a_period) lines += fmt::format("{:.10g} {:.8g}\n", at.value, x);
      }
    }
  }
  return lines;
}

// gnuplot's hollow marks.
constexpr std::array kMarks{
    std::pair{SpecialKind::fold, 10},           std::pair{SpecialKind::period_doubling, 4},
    std::pair{SpecialKind::neimark_sacker, 12}, std::pair{SpecialKind::branch_point, 6},
    std::pair{SpecialKind::phase_resonance, 8}, std::pair{SpecialKind::grazing, 2},
    std::pair{SpecialKind::contact_change, 1}};

/// Curves, and how many of them have an entry in the key.
struct KeyedCanvas : Canvas {
  std::size_t entries = 0;

  void draw(const std::string& lines, const std::string& how) {
    entries += lines.empty() || how.ends_with("notitle") ? 0U : 1U;
    Canvas::draw(lines, how);
  }
};

/// The parts of its branches by their stability, one of the stable and unknown ones with a title; its steps.
void draw_method(const MethodResponse& response, const std::string& colour, ResponseOrdinate ordinate,
                 KeyedCanvas& canvas) {
  const std::string name = name_with_law(response), title = "title " + gnuplot_string(name);
  bool titled = false;
  for (const auto& [part, style] :
       {std::pair{Stability::stable, "lw 2.4"}, std::pair{Stability::unstable, "lw 1.2 dt (12,8)"},
        std::pair{Stability::unknown, "lw 1"}}) {
    const bool unstable = part == Stability::unstable;
    const std::string lines = pieces(response.diagram, part, ordinate);
    const std::string words = unstable ? "title " + gnuplot_string(name + ", unstable")
                              : titled ? "notitle"
                                       : title;
    canvas.draw(lines, fmt::format("with lines {} {} {}", colour, style, words));
    titled = titled || (!lines.empty() && !unstable);
  }
  if (ordinate == ResponseOrdinate::amplitude)
    canvas.draw(steps(response.steps), fmt::format("with points {} pt 6 ps 0.5 {}", colour, title));
}

}  // namespace

Figure response_plot(const std::string& scene, const std::vector<MethodResponse>& responses,
                     ResponseOrdinate ordinate, Column column, const std::vector<AttractorsAt>& attractors,
                     const std::string& parameter) {
  const bool amplitudes = ordinate == ResponseOrdinate::amplitude;
  const std::string over = !responses.empty()  ? responses.front().parameter
                           : parameter.empty() ? std::string(kFrequency)
                                               : parameter;
  const std::string abscissa = over == kFrequency ? "frequency of the load [rad/s]" : over;
  KeyedCanvas canvas;
  canvas.draw(attractor_points(attractors, ordinate, false),
              "with points lc rgb '#b03030' pt 7 ps 0.25 title 'goes to: irregular or a torus'");
  canvas.draw(attractor_points(attractors, ordinate, true),
              "with points lc rgb '#303030' pt 6 ps 0.4 title 'goes to: periodic'");
  for (std::size_t i = 0; i < responses.size(); ++i)
    draw_method(responses[i], line_colour(i), ordinate, canvas);
  for (const auto& [kind, mark] : kMarks)
    if (amplitudes)
      canvas.draw(marks(responses, kind), fmt::format("with points lc rgb '#333333' pt {} ps 0.9 title {}",
                                                      mark, gnuplot_string(describe(kind))));
  const auto asked = responses.empty() ? std::nullopt : responses.front().asked;
  const std::string axis =
      asked ? fmt::format("set xrange [{:.10g}:{:.10g}]\n", asked->low, asked->high) : "";
  constexpr double kAxis = 1.3;  // [cm]
  const bool narrow = is_narrow(column);
  const int columns = narrow ? 1 : 3;  // of the key
  const double key = key_height(canvas.entries, columns), height = (narrow ? 6.0 : 9.2) + kAxis + key;
  return {
      .name = "response",
      .caption = "Response of " + scene,
      .script = std::string(kFrame) +
                fmt::format("set key at screen 0.5,0.01 bottom center horizontal maxcols {} noenhanced Left "
                            "reverse samplen 2 font ',8'\n{}set bmargin at screen {:.3f}\nset ylabel {}\n"
                            "set xlabel {} noenhanced\nset title {} noenhanced\n{}",
                            columns, axis, (kAxis + key) / height,
                            amplitudes ? "'amplitude [m]'" : "'x at t = 0 of each forcing period [m]'",
                            gnuplot_string(abscissa), gnuplot_string(scene), canvas.panel()),
      .data = canvas.data(),
      .width = width_in(column, 16.0),
      .height = height};
}

}  // namespace signorini
