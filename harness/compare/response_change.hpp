#pragma once
// What became of a frequency response between two runs.

#include <optional>
#include <string>

#include "harness/records/recorded_response.hpp"

namespace signorini {

/// Shares of length may differ by this much.
inline constexpr double kShareTolerance = 0.01;

/// A difference of two responses.
struct ResponseChange {
  bool worse = false;       ///< less is found, more is false, or fewer points are located
  std::string detail = {};  ///< what was and what is
};

/// How a response differs, first in the share of the exact one that it finds, then in the share of its own
/// that is false, each by more than kShareTolerance, then in how many special points it located, of those
/// there are; nothing where it does not.
std::optional<ResponseChange> response_change(const RecordedResponse& before, const RecordedResponse& after);

}  // namespace signorini
