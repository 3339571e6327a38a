#pragma once
// A schematic as `show --plot` writes it.

#include <filesystem>

#include "harness/report/document/section.hpp"
#include "harness/schematic/drawing.hpp"

namespace signorini {

/// A drawing as a figure of gnuplot, for the formats that it has.
Figure schematic_figure(const Drawing& drawing);

/// Writes a drawing in the format of the file's ending: SVG as it is, PDF and PNG by gnuplot.
/// \throws UsageError as write_plot does
void write_schematic(const std::filesystem::path& file, const Drawing& drawing);

}  // namespace signorini
