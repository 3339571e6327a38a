#pragma once
// What the checks of a method found, as JSON and as text.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "methods/catalogue.hpp"

namespace signorini {

enum class CheckOutcome {
  passed,
  remarked,        ///< accepted, with a remark that the author of the method should read
  not_applicable,  ///< the scene gives the check nothing to look at
  failed
};

/// The words of its JSON.
template <>
struct EnumNames<CheckOutcome> {
  /// In order.
  static constexpr std::array<std::string_view, 4> values{"passed", "remarked", "not-applicable", "failed"};
};

/// The outcome of one check. The check sets outcome, reason and command, the runner the first three fields.
struct CheckResult {
  std::string check = {};    ///< name of the check, "load-scaling"
  std::string promise = {};  ///< what the check asks for, "scales with load and gap"
  std::string scene = {};    ///< name of the scene; empty where the check is of the method alone
  CheckOutcome outcome = CheckOutcome::passed;
  std::string why = {};        ///< the reason in one line; empty if the check passed
  std::string reproduce = {};  ///< a command that shows a failure; empty: the command of the check itself
};

CheckResult passed();
CheckResult remarked(std::string why);
CheckResult failed(std::string why);
CheckResult not_applicable(std::string why);
/// Failed for the reason given, passed where there is none.
CheckResult passed_unless(std::string defect);

/// An object with the keys `check`, `promise`, `scene`, `outcome`, `why`, `reproduce`, without those that are
/// empty.
nlohmann::ordered_json to_json(const CheckResult& result);

/// The inverse of to_json. \throws nlohmann::json::exception if there is no `outcome`
CheckResult check_result_from_json(const nlohmann::ordered_json& json);

/// One paragraph per check: what it asks for and on how many scenes it passed; then, for each failure and
/// each remark, the reason, and the command that shows the failure. The last line counts the outcomes.
/// \param results        those of one check in succession, as check_method returns them
/// \param further_words  of those commands, such as " --plugin march.toml"
std::string review_text(const MethodEntry& entry, const std::vector<CheckResult>& results,
                        const std::string& further_words = {});

}  // namespace signorini
