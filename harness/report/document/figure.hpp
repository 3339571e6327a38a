#pragma once
// Figures as gnuplot draws them: a script and its data, kept beside what is drawn.

#include <cstddef>
#include <string>
#include <vector>

namespace signorini {

class Evaluation;

/// One figure. The script sets neither terminal nor output; its data are in `NAME.dat` beside it.
struct Figure {
  std::string name = {};  ///< lower-kebab-case: NAME.gp, NAME.dat, NAME.svg, NAME.pdf
  std::string caption = {};
  std::string script = {};
  std::string data = {};               ///< blocks parted by two blank lines, gnuplot's `index`
  double width = 16.0, height = 10.0;  ///< [cm]
};

/// Of figures on a screen.
inline constexpr double kPixelsPerCentimetre = 96.0 / 2.54;

/// How a contestant is drawn, the same in every figure: told apart by colour (Okabe and Ito's, safe for
/// colour-blind readers), dashes and mark, any one of which is enough.
struct LineStyle {
  std::string line = {};    ///< "lc rgb '#0072B2' dt 2 lw 1.5"
  std::string mark = {};    ///< "pt 5"
  std::string filled = {};  ///< mark and colour
  std::string hollow = {};  ///< the same mark, hollow
};
LineStyle line_style(std::size_t contestant);

/// A line of a key: how it is drawn, and what it stands for.
struct KeyEntry {
  std::string style = {};
  std::string title = {};
};

/// The part of a multiplot's script that fills its lowest `height` (a share of the whole) with a key for all
/// panels, in so many columns if they fit.
std::string key_panel(const std::vector<KeyEntry>& entries, double height, int columns);

/// Error against time on one scene, one curve per contestant; hollow: below ten error bars. A second panel
/// shows methods of another law, each against its own. None if nobody has both error and time.
std::vector<Figure> work_precision_figures(const Evaluation& evaluation, const std::string& scene);

/// x, velocity, force and impulse over a period at one contact, and the phase portrait: the coarsest answer
/// of each contestant that has one, on the certified orbit. None where the records keep no motions.
std::vector<Figure> motion_figures(const Evaluation& evaluation, const std::string& scene);

/// Joint performance profiles of one contest at three errors.
std::vector<Figure> profile_figures(const Evaluation& evaluation, std::size_t contest);

}  // namespace signorini
