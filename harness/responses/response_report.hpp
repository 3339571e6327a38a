#pragma once
// A folder of responses as files: tables, figures, a page.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/figures/column.hpp"
#include "harness/responses/response_record.hpp"

namespace signorini {

/// Amplitude over frequency of every scene: the exact response, stable and unstable, under those of the
/// methods.
std::vector<Figure> response_figures(std::span<const ResponseRecord> records, Column column = Column::own);

/// Writes what the formats ask for: "md" table.md, "html" report.html, "tex" figures/SCENE-response.{gp, dat,
/// svg, pdf}. Returns the files that a reader opens. \throws UsageError if the folder cannot be written, or
/// gnuplot is missing
std::vector<std::filesystem::path> write_response_report(const std::filesystem::path& folder,
                                                         std::span<const ResponseRecord> records,
                                                         const std::vector<std::string>& formats,
                                                         Column column = Column::own);

/// Brings the tables of a document up to date; see `with_tables`. The run goes by the name of its folder.
/// \throws UsageError, NothingMatched
void write_response_tables_into(const std::filesystem::path& document, const std::filesystem::path& folder,
                                std::span<const ResponseRecord> records);

}  // namespace signorini
