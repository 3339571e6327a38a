#pragma once
// What a check of a method came to.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace signorini {

enum class CheckOutcome {
  passed,
  remarked,        ///< accepted, but worth a word
  not_applicable,  ///< there was nothing to look at
  failed
};

/// "passed", "remarked", "not-applicable", "failed".
std::string_view outcome_name(CheckOutcome outcome);

/// The outcome of one check, and why unless it passed.
struct CheckResult {
  CheckOutcome outcome = CheckOutcome::passed;
  std::string why = {};        ///< one line
  std::string reproduce = {};  ///< a command that shows it; empty: the check itself
};

CheckResult passed();
CheckResult remarked(std::string why);
CheckResult failed(std::string why);
CheckResult not_applicable(std::string why);

/// A result with what it is about.
struct CheckFinding {
  std::string check = {};    ///< "load-scaling"
  std::string promise = {};  ///< what was asked: "the answer scales with load and gap"
  std::string scene = {};    ///< empty where the check is of the method itself
  CheckResult result = {};
};

nlohmann::ordered_json to_json(const CheckResult& result);
CheckResult result_from_json(const nlohmann::ordered_json& json);

/// Keys `check`, `promise`, `scene`, `outcome`, `why`, `reproduce`; those that are empty are absent.
nlohmann::ordered_json to_json(const CheckFinding& finding);

}  // namespace signorini
