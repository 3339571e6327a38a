#pragma once
// A figure as one file: what --plot writes.

#include <filesystem>
#include <string>

#include "harness/report/document/section.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Why no picture can be written to a file of this name: it must end in .svg, .pdf or .png and stand in a
/// folder that is there. Empty where one can; for command lines, before any work is done.
std::string plot_obstacle(const std::string& file);

/// For commands that draw contacts, before any work is done. \throws UsageError if the scene has none
void require_contact_to_draw(const Problem& problem);

/// Draws a figure into a file, in the format of its ending. \throws UsageError if gnuplot is missing, or the
/// file cannot be written
void write_plot(const std::filesystem::path& file, const Figure& figure);

}  // namespace signorini
