#pragma once
// A frequency response as a table and as data.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "harness/sweep/frequency_response.hpp"
#include "harness/table.hpp"

namespace signorini {

/// One row per point in the order of the solves; `certified` adds the column of stability. What is absent is
/// "-".
Table response_table(const std::vector<SweepPoint>& points, bool certified);

/// Keys `frequency`, `way` ("there" or "back"), `status`, `message`, `x_max`, `amplitude`, `contact_ratio`,
/// `stable`; absent where a notion is.
nlohmann::ordered_json to_json(const SweepPoint& point);

}  // namespace signorini
