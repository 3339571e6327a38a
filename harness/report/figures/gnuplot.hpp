#pragma once
// gnuplot: what the scripts of all figures share, and gnuplot as a subprocess that draws them.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/document/section.hpp"

namespace signorini {

/// The style of a configuration, the same in every figure: distinguished by colour (Okabe and Ito's, safe for
/// colour-blind readers), dashes and mark, any one of which is enough.
struct LineStyle {
  std::string line = {};    ///< "lc rgb '#0072B2' dt 2 lw 1.5"
  std::string mark = {};    ///< "pt 5"
  std::string filled = {};  ///< mark and colour
  std::string hollow = {};  ///< the same mark, hollow
};
LineStyle line_style(std::size_t configuration);
/// Its colour alone: "lc rgb '#0072B2'".
std::string line_colour(std::size_t configuration);

/// A text as gnuplot's string literal in single quotes, which knows no escapes and no commands; line breaks
/// become blanks.
std::string gnuplot_string(std::string_view text);

/// The step of the tics of a range: 1, 2 or 5 times a power of ten, so that it has at most so many; 1 for no
/// range. gnuplot counts those of an abscissa by the width of its letters, and sets them too close.
double tic_step(double range, int most);

/// An entry of a key: style and title.
struct KeyEntry {
  std::string style = {};
  std::string title = {};
  std::string with = "linespoints";
};

/// Room that a key of so many entries takes below a figure [cm].
double key_height(std::size_t entries, int columns);

/// The part of a multiplot's script that fills its lowest `height` (a share of the whole) with a key for all
/// panels, in so many columns if they fit.
std::string key_panel(const std::vector<KeyEntry>& entries, double height, int columns);

/// Writes NAME.gp and NAME.dat of each figure into the folder and has gnuplot make NAME.svg and NAME.pdf of
/// them: the same bytes each time. `gnuplot NAME.gp` in the folder makes them again.
/// \throws UsageError if gnuplot is not installed, refuses a script, the folder cannot be written, or the
/// name of a figure is more than letters, digits and "@._-"
void draw_figures(const std::filesystem::path& folder, std::span<const Figure> figures);

/// The bytes of one figure as "svg", "pdf" or "png", the last at twice the pixels of a screen; no file is
/// left. \throws UsageError if gnuplot is not installed or refuses the script
std::string drawn(const Figure& figure, std::string_view format);

/// The whole of NAME.gp.
std::string whole_script(const Figure& figure);

/// A PDF with its date of creation set to the epoch, all bytes in their places.
std::string without_date(std::string pdf);

/// How gnuplot draws the line of a stop.
inline constexpr std::string_view kStopStyle = "lc rgb '#D55E00' dt (12,6) lw 1.2";

/// What panels have: a grid behind, two axes.
inline constexpr std::string_view kFrame =
    "set grid back lc rgb '#dddddd' lw 0.5\nset border 3\nset tics nomirror\n";

/// Commands that begin panels of that look, with small numbers and no key, in a multiplot of so many rows and
/// columns. \param layout  further words for it, " margins ..."
std::string panels(int rows, int columns, std::string_view layout = {});

/// Collects blocks of data, and for one panel after the other what is plotted in it.
class Canvas {
 public:
  /// Adds a block, which gnuplot's `index` names; single blank lines in it part its pieces. Empty where there
  /// is no line.
  std::optional<int> add(const std::string& lines, std::string_view comment = {});
  /// Plots a block in the panel that is begun: "using 1:2 with lines". Nothing where there is no block.
  void plot(std::optional<int> block, std::string_view how);
  /// Both at once.
  void draw(const std::string& lines, std::string_view how, std::string_view comment = {}) {
    plot(add(lines, comment), how);
  }
  /// Plots what is no data: a function, an entry of the key.
  void plot(std::string_view what);

  /// The command that plots the panel, and the next one begins. A panel without curves is an empty frame.
  std::string panel();
  /// All blocks.
  [[nodiscard]] const std::string& data() const { return data_; }
  /// Whether there is any block.
  [[nodiscard]] bool empty() const { return blocks_ == 0; }

 private:
  std::string data_, curves_;
  int blocks_ = 0;
};

}  // namespace signorini
