#pragma once
// Records made by hand.

#include <vector>

#include "harness/records/record.hpp"

namespace signorini::test {

/// Every key present.
Record full_record();

/// A converged, certified and timed run.
Record good_record(const std::string& scene, const std::string& method, const std::string& resolution,
                   double error, double seconds);

/// One record of each status, two of converged: certified and not.
std::vector<Record> records_of_every_status();

}  // namespace signorini::test
