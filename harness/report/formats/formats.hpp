#pragma once
// A report as text: Markdown, LaTeX, CSV.

#include <cstddef>
#include <span>
#include <string>

#include "harness/files.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// All sections as Markdown, one below the other. \param most  characters of a table: a longer one ends with
/// the rows that have room, at least one, and how many these are of how many stands below it
std::string markdown_report(std::span<const Section> sections, std::size_t most = std::string::npos);

/// A document with its tables brought up to date: what stands between a line
/// `<!-- table RUN/SECTION [WORD] -->` and the next `<!-- /table -->` becomes the table of that section, of
/// its rows only those whose first cell is WORD; of a section without a table its text as a block of code.
/// Markers of other runs stay as they are. \throws UsageError for a section that is not there, or a marker
/// without its end, NothingMatched where no marker is of this run or no row begins with WORD
std::string with_tables(const std::string& document, const std::string& run,
                        std::span<const Section> sections);

/// The table of a section, ready for \input: a `tabular` with the rules of the package booktabs, a
/// `longtable` where it is longer than a page.
std::string to_latex(const Section& section);

/// Text with the characters that TeX takes for its own, and those beyond ASCII that our tables use, spelled
/// out.
std::string latex_escaped(const std::string& text);

/// One row per record with all measures as plain numbers. An empty cell is explained in the last column. Row
/// by row: of a run of a million cases no more than one is in memory.
void csv_report(const Evaluation& evaluation, const TextSink& sink);

/// One row per scene and configuration: its eligibility (competes, another-law, not-applicable), how many of
/// its runs are solved, and seconds to each error of kErrorLevels; `inf` where it is not reached.
void measures_csv(const Evaluation& evaluation, const TextSink& sink);

}  // namespace signorini
