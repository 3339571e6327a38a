#include "harness/plots/schematic_plot.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "harness/files.hpp"
#include "harness/plots/plot_file.hpp"
#include "harness/report/figures/gnuplot.hpp"

namespace signorini {

namespace {

std::string_view colour(Ink ink) { return kDaySheet.ink.at(static_cast<std::size_t>(ink)); }

/// How gnuplot draws a stroke: the inside, then the line.
std::vector<std::string> styles(const Stroke& stroke) {
  // Points of a line in print, 72.27 per inch.
  constexpr double kPoints = 72.27 / 2.54;
  std::vector<std::string> found;
  if (stroke.fill != Fill::none) {
    const std::string_view inside = stroke.fill == Fill::body    ? kDaySheet.body
                                    : stroke.fill == Fill::paper ? "#ffffff"
                                                                 : colour(stroke.ink);
    found.push_back(fmt::format("with filledcurves closed fc rgb '{}'", inside));
  }
  found.push_back(fmt::format("with lines lc rgb '{}' lw {:.2f}{}", colour(stroke.ink),
                              kPoints * stroke.width, stroke.dashed ? " dt (6,4)" : ""));
  return found;
}

std::string line_block(const Stroke& stroke) {
  std::string lines;
  for (const Place& place : stroke.places) lines += fmt::format("{:.3f} {:.3f}\n", place.x(), place.y());
  if (stroke.closed)
    lines += fmt::format("{:.3f} {:.3f}\n", stroke.places.front().x(), stroke.places.front().y());
  return lines;
}

/// Strokes in their order; neighbours of one style share a block.
class StrokeBlocks {
 public:
  explicit StrokeBlocks(Canvas& canvas) : canvas_(canvas) {}
  void add(const std::string& lines, const std::string& style) {
    // Filled shapes stay by themselves: gnuplot would join them.
    if (style != style_ || style.starts_with("with filled")) {
      finish();
      style_ = style;
    }
    lines_ += (lines_.empty() ? "" : "\n") + lines;
  }
  void finish() { canvas_.draw(std::exchange(lines_, {}), style_); }

 private:
  Canvas& canvas_;
  std::string lines_, style_;
};

std::string label_command(const Label& label) {
  constexpr std::array kAnchors{"left", "center", "right"};
  // gnuplot centres a line of text on its place.
  return fmt::format("set label {} at {:.3f},{:.3f} {} font ',9.6' textcolor rgb '{}' noenhanced front\n",
                     gnuplot_string(label.words), label.place.x(), label.place.y() + 0.35 * kTextSize,
                     kAnchors.at(static_cast<std::size_t>(label.anchor)), colour(label.ink));
}

}  // namespace

Figure schematic_figure(const Drawing& drawing) {
  const Box box = extent(drawing);
  const Place low = box.low - Place::Constant(kDrawingMargin),
              size = box.size() + Place::Constant(2.0 * kDrawingMargin);
  std::string script = fmt::format(
      "set margins 0,0,0,0\nset lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset "
      "tmargin at screen 1\nunset border\nunset tics\nunset key\nset xrange [{:.3f}:{:.3f}]\nset yrange "
      "[{:.3f}:{:.3f}]\n",
      low.x(), low.x() + size.x(), low.y(), low.y() + size.y());
  Canvas canvas;
  StrokeBlocks lines(canvas);
  for (const Part& part : drawing.parts) {
    for (const Stroke& stroke : part.strokes)
      for (const std::string& style : styles(stroke)) lines.add(line_block(stroke), style);
    for (const Label& label : part.labels) script += label_command(label);
  }
  lines.finish();
  return {.name = "schematic",
          .caption = drawing.title,
          .script = script + canvas.panel(),
          .data = canvas.data(),
          .width = size.x(),
          .height = size.y()};
}

void write_schematic(const std::filesystem::path& file, const Drawing& drawing) {
  if (file.extension() == ".svg")
    write_whole(file, svg_of(drawing));
  else
    write_plot(file, schematic_figure(drawing));
}

}  // namespace signorini
