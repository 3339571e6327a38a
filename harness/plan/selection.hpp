#pragma once
// Methods with the option settings they run with: `penalty-hbm[harmonics=31,penalty=1e4|1e6]`.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/failure.hpp"
#include "harness/plan/case_name.hpp"
#include "methods/catalogue.hpp"

namespace signorini {

/// One method with one set of settings.
struct MethodChoice {
  const MethodEntry* entry = nullptr;
  Settings settings = {};

  /// "penalty-hbm[harmonics=31,penalty=1e4]"; the bare name where nothing is set.
  [[nodiscard]] std::string label() const;
  /// The method with these settings, but for kStartSetting. \throws InvalidOption
  [[nodiscard]] std::unique_ptr<Method> make() const;
  /// What the options are, kStartSetting among them if it is set. \throws InvalidOption
  [[nodiscard]] std::vector<OptionEcho> options() const;
  /// The share of its period, in [0, 1), by which the motion is late that a solve starts from: the orbit that
  /// the scene reaches from rest under the method's law. Empty: a cold start. \throws InvalidOption
  [[nodiscard]] std::optional<double> start() const;
};

/// A setting that the harness applies to any method, see MethodChoice::start.
inline constexpr std::string_view kStartSetting = "start";

/// The cross product of the alternatives, the last key varying fastest:
/// "a=1,b=2|3" -> {a=1,b=2}, {a=1,b=3}. Empty text gives one empty set.
/// \throws UsageError unless every item reads key=value[|value...], each key once
std::vector<Settings> expand_settings(std::string_view text);

/// The settings that a method's own ladder prescribes.
std::vector<Settings> ladder_of(const MethodEntry& entry);

/// The refusal of a filter that no method matches.
NothingMatched no_method(std::string_view filter);

/// Methods that a filter of globs, each with optional settings in brackets, chooses; in catalogue
/// order, each (method, settings) once. A piece without brackets gives a method its settings in `prescribed`,
/// or its own ladder if it has none there. Negative pieces are globs on method names.
/// \throws UsageError for bad brackets; NothingMatched if a piece matches no method
std::vector<MethodChoice> select_methods(std::string_view filter, std::span<const MethodEntry> catalogue,
                                         std::span<const MethodChoice> prescribed = {});

}  // namespace signorini
