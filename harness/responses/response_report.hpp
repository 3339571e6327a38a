#pragma once
// Tables and figures of a folder of responses, pure functions of its records.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/responses/response_record.hpp"

namespace signorini {

/// Sections `responses` (methods over all responses, sums of length), `response-cases` (each response),
/// `located` (each fold and the like of the exact responses, with the error of every method in omega), and
/// `open-ends` (where an exact response is not known to be whole).
std::vector<Section> response_sections(std::span<const ResponseRecord> records);

/// Amplitude over frequency of every scene: the exact response, stable and unstable, under those of the
/// methods.
std::vector<Figure> response_figures(std::span<const ResponseRecord> records);

/// Writes table.md and, if asked to, figures/SCENE-response.{gp,dat,svg,pdf}. Returns the files that a reader
/// opens. \throws UsageError if the folder cannot be written, or gnuplot is missing
std::vector<std::filesystem::path> write_response_report(const std::filesystem::path& folder,
                                                         std::span<const ResponseRecord> records,
                                                         bool with_figures);

/// Brings the tables of a document up to date; see `with_tables`. The run goes by the name of its folder.
/// \throws UsageError, NothingMatched
void write_response_tables_into(const std::filesystem::path& document, const std::filesystem::path& folder,
                                std::span<const ResponseRecord> records);

}  // namespace signorini
