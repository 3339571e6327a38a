#pragma once
// What a folder of responses says, as tables and one sentence.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/responses/response_record.hpp"

namespace signorini {

/// How a method for frequency responses is recommended.
inline constexpr std::string_view kResponseRule =
    "Recommended: of the methods of whose own branches at most 5 % are false, over all responses together, "
    "the "
    "one that finds the most of the exact branches; of those that find as much but for 5 percentage points, "
    "the "
    "one that takes the least time per length. A response that a method does not apply to counts as not "
    "found.";

/// The sums of one method over all responses, by length.
struct ResponseStanding {
  std::string label = {};
  double covered = 0.0;                ///< share of the exact length of all responses, within kCloseTolerance
  double false_share = 0.0;            ///< of the method's own length, beyond kWideTolerance
  std::optional<double> cost = {};     ///< processor time per length within kWideTolerance [s]
  bool recommended = false;            ///< by kResponseRule
  bool recommended_otherwise = false;  ///< by the same among methods other than kFollowedByArcLength
};

/// Of every method, in the order of labels_of.
std::vector<ResponseStanding> response_standings(std::span<const ResponseRecord> records);

/// The recommendation in words, the second best where the best is what the exact responses are made by.
std::string response_verdict(std::span<const ResponseRecord> records);

/// The recommendation and a line for each method, at most 80 columns wide: what a terminal shows of a folder.
std::string response_screen(std::span<const ResponseRecord> records);

/// Sections `responses` (methods over all responses, sums of length), `response-cases` (each response),
/// `located` (each fold and the like of the exact responses, with the error of every method in omega), and
/// `open-ends` (where an exact response is not known to be whole). Cells lead to the records by their places.
std::vector<Section> response_sections(std::span<const ResponseRecord> records);

}  // namespace signorini
