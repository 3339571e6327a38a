#pragma once
// gnuplot as a subprocess.

#include <filesystem>
#include <span>

#include "harness/report/document/figure.hpp"

namespace signorini {

/// Writes NAME.gp and NAME.dat of each figure into the folder and has gnuplot make NAME.svg and NAME.pdf of
/// them: the same bytes each time. `gnuplot NAME.gp` in the folder makes them again.
/// \throws UsageError if gnuplot is not installed, refuses a script, or the folder cannot be written
void draw_figures(const std::filesystem::path& folder, std::span<const Figure> figures);

/// The whole of NAME.gp.
std::string whole_script(const Figure& figure);

/// A PDF with its date of creation set to the epoch, all bytes in their places.
std::string without_date(std::string pdf);

}  // namespace signorini
