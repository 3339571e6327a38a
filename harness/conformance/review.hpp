#pragma once
// Findings as a review that a person reads.

#include <span>
#include <string>
#include <vector>

#include "harness/conformance/finding.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

/// A paragraph per check: what was asked, on how many scenes it holds; what failed or deserves a remark, why,
/// and the command that shows it again. A line with the sum of it ends the review.
std::string review_text(const MethodEntry& entry, const std::vector<CheckFinding>& findings);

}  // namespace signorini
