#pragma once
// The report of a run: files that are pure functions of its records and manifest.

#include <filesystem>
#include <string>
#include <vector>

#include "harness/plan/suite.hpp"
#include "harness/report/document/section.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "harness/report/figures/column.hpp"

namespace signorini {

/// Formats of reports.
inline const std::vector<std::string> kReportFormats{"md", "whole", "csv", "tex", "html"};

/// Writes the report of a run in these formats, the same bytes whatever the order of the records:
///
/// - md: table.md; where it would have more than 300,000 characters, each of its tables as far as 8,000 go
/// - whole: table-whole.md, all of them to their ends
/// - csv: table.csv, one row per record of a motion; measures.csv, one row per scene and method
/// - tex: tables/SECTION.tex, and the figures
/// - html: report.html; of more than kMostOfPage cases the scenes on pages/NUMBER.html
/// - figures: figures/NAME.{gp,dat,svg,pdf}, as wide as `column`
///
/// Returns the files that a reader opens. \throws UsageError if the folder cannot be written, or gnuplot,
/// which draws figures, is missing
std::vector<std::filesystem::path> write_report(const std::filesystem::path& folder,
                                                const Evaluation& evaluation,
                                                const std::vector<std::string>& formats,
                                                Column column = Column::own);

/// What a document may show of a run: its sections, as `verdict` a table of the methods that are
/// recommended, and as `screen` its screen (screen.hpp), that of a run in the folder results.
std::vector<Section> document_sections(const std::string& run, const Evaluation& evaluation);

/// Brings the tables of a run that a document shows up to date; see `with_tables`. The run goes by the name
/// of its folder. \throws UsageError
void write_tables_into(const std::filesystem::path& document, const std::filesystem::path& folder,
                       const Evaluation& evaluation);

}  // namespace signorini
