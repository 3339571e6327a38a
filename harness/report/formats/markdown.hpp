#pragma once
// Sections as Markdown.

#include <span>
#include <string>

#include "harness/report/document/section.hpp"

namespace signorini {

/// All sections, one below the other.
std::string markdown_report(std::span<const Section> sections);

/// A document with its tables brought up to date: what stands between a line
/// `<!-- table RUN/SECTION [WORD] -->` and the next `<!-- /table -->` becomes the table of that section, of
/// its rows only those whose first cell is WORD. Markers of other runs stay as they are. \throws UsageError
/// for a section that is not there, or a marker without its end, NothingMatched where no marker is of this
/// run or no row begins with WORD
std::string with_tables(const std::string& document, const std::string& run,
                        std::span<const Section> sections);

}  // namespace signorini
