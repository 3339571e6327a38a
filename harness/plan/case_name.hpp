#pragma once
// The name of a case, "sdof-stop/hat-lcp[samples=64]". Programs go by its parts; the name is for people, and
// for records and plans of earlier versions, which kept nothing else.

#include <string>
#include <string_view>
#include <vector>

#include "methods/options.hpp"

namespace signorini {

/// Options of a method with their values, as asked for; every other option has its default.
using Settings = std::vector<OptionSetting>;

/// Whether they ask for a method as the literature has it, `plain=true`.
bool is_plain(const Settings& settings);

/// Parts of the name of a case.
struct CaseName {
  std::string scene = {};
  std::string method = {};
  Settings settings = {};
};

/// "hat-lcp[samples=64,scheme=nodal]"; the bare name where nothing is set.
std::string method_label(std::string_view method, const Settings& settings);

/// Takes apart what method_label printed; `scene` stays empty.
CaseName parse_method_label(std::string_view label);

/// Takes apart "SCENE/LABEL"; without a slash, all of it is the label.
CaseName parse_case_name(std::string_view name);

/// Time marching to six digits, the usual way to solve such problems. This is the part of the case's name
/// after the scene.
inline constexpr std::string_view kTimeBaseline = "event-driven[flow=cvode,tolerance=1e-6]";

}  // namespace signorini
