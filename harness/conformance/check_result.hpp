#pragma once
// What one check of a method found.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace signorini {

enum class CheckOutcome {
  passed,
  remarked,        ///< accepted, with a remark that the author of the method should read
  not_applicable,  ///< the scene gives the check nothing to look at
  failed
};

/// "passed", "remarked", "not-applicable", "failed".
std::string_view outcome_name(CheckOutcome outcome);

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

/// An object with the keys `check`, `promise`, `scene`, `outcome`, `why`, `reproduce`, without those that are
/// empty.
nlohmann::ordered_json to_json(const CheckResult& result);

/// The inverse of to_json. \throws nlohmann::json::exception if there is no `outcome`
CheckResult check_result_from_json(const nlohmann::ordered_json& json);

}  // namespace signorini
