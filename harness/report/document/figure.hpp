#pragma once
// Figures: a gnuplot script and its data.

#include <cstddef>
#include <string>
#include <vector>

namespace signorini {

/// One figure. The script sets neither terminal nor output; its data are in `NAME.dat` beside it.
struct Figure {
  std::string name = {};  ///< lower-kebab-case: NAME.gp, NAME.dat, NAME.svg, NAME.pdf
  std::string caption = {};
  std::string script = {};
  std::string data = {};               ///< blocks parted by two blank lines, gnuplot's `index`
  double width = 16.0, height = 10.0;  ///< [cm]
};

/// Resolution of figures on a screen: 96 pixels per inch.
inline constexpr double kPixelsPerCentimetre = 96.0 / 2.54;

/// The style of a configuration, the same in every figure: distinguished by colour (Okabe and Ito's, safe for
/// colour-blind readers), dashes and mark, any one of which is enough.
struct LineStyle {
  std::string line = {};    ///< "lc rgb '#0072B2' dt 2 lw 1.5"
  std::string mark = {};    ///< "pt 5"
  std::string filled = {};  ///< mark and colour
  std::string hollow = {};  ///< the same mark, hollow
};
LineStyle line_style(std::size_t configuration);

/// An entry of a key: style and title.
struct KeyEntry {
  std::string style = {};
  std::string title = {};
};

/// The part of a multiplot's script that fills its lowest `height` (a share of the whole) with a key for all
/// panels, in so many columns if they fit.
std::string key_panel(const std::vector<KeyEntry>& entries, double height, int columns);

}  // namespace signorini
