#pragma once
// Methods with the option settings they run with: `penalty-hbm[harmonics=31,penalty=1e4|1e6]`.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "methods/catalogue.hpp"

namespace signorini {

using Settings = std::vector<OptionSetting>;

/// One method with one set of settings.
struct MethodChoice {
  const MethodEntry* entry = nullptr;
  Settings settings = {};

  /// "penalty-hbm[harmonics=31,penalty=1e4]"; the bare name where nothing is set.
  [[nodiscard]] std::string label() const;
};

/// The cross product of the alternatives, the last key varying fastest:
/// "a=1,b=2|3" -> {a=1,b=2}, {a=1,b=3}. Empty text gives one empty set.
/// \throws UsageError unless every item reads key=value[|value...], each key once
std::vector<Settings> expand_settings(std::string_view text);

/// The settings that a method's own ladder prescribes.
std::vector<Settings> ladder_of(const MethodEntry& entry);

/// Settings for a method that a piece without brackets names.
using DefaultSettings = std::function<std::vector<Settings>(const MethodEntry&)>;

/// Methods that a filter of globs, each with optional settings in brackets, chooses; in catalogue
/// order, each (method, settings) once. Negative pieces are globs on method names.
/// \throws UsageError for bad brackets; NothingMatched if a piece matches no method
std::vector<MethodChoice> select_methods(std::string_view filter, std::span<const MethodEntry> catalogue,
                                         const DefaultSettings& defaults = ladder_of);

}  // namespace signorini
