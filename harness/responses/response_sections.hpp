#pragma once
// What a folder of responses says, as tables and one sentence.

#include <span>
#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/responses/response_record.hpp"
#include "harness/responses/response_standings.hpp"

namespace signorini {

/// For each kind of scenes the recommended methods and those that find the most, at most 80 columns wide:
/// what a terminal shows of a folder.
std::string response_screen(std::span<const ResponseRecord> records);

/// Sections `verdict` (a row for each kind of scenes), `responses` (each method on each kind, sums of
/// length), `response-cases` (each response), `located` (each fold and the like of the exact responses, with
/// the error of every method in omega), and `open-ends` (where an exact response is not known to be whole).
/// Cells lead to the records by their places.
std::vector<Section> response_sections(std::span<const ResponseRecord> records);

}  // namespace signorini
