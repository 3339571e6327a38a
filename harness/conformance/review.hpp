#pragma once
// The results of the checks of a method as text.

#include <string>
#include <vector>

#include "harness/conformance/check_result.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

/// One paragraph per check: what it asks for and on how many scenes it passed; then, for each failure and
/// each remark, the reason, and the command that shows the failure. The last line counts the outcomes. \param
/// results  those of one check in succession, as check_method returns them
std::string review_text(const MethodEntry& entry, const std::vector<CheckResult>& results);

}  // namespace signorini
