#pragma once
// The one list of methods.

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method.hpp"

namespace signorini {

/// Another method that solves the same discrete equations by another algorithm, where an option has this
/// value.
struct SameEquations {
  std::string option;  ///< of this method
  std::string value;   ///< as it is set, "penalty"
  std::string method;  ///< name of the other one
};

/// A method as the harness sees it before any scene: how to name it, describe it, make one.
struct MethodEntry {
  std::string name;         ///< lower-kebab-case
  std::string title;        ///< one line for people
  std::string laws;         ///< laws it can represent, for `list`
  std::string ladder;       ///< resolutions a benchmark runs, "key=v1|v2|v3"
  std::string limits = {};  ///< what it cannot do, in sentences for people; empty: nothing is said
  /// Settings, "key=v1|v2", from which cold starts lead to orbits that no step of the ladder leads to: tried
  /// in searches for all orbits of a scene only; empty: none
  std::string starts = {};
  /// p of error of x ~ h^p, h the step that the ladder refines, on motions with impacts; empty: none is
  /// claimed [-]
  std::optional<double> order = {};
  /// Whose equations it solves too, wherever the options that both have are equal: an answer that agrees with
  /// theirs confirms nothing.
  std::vector<SameEquations> same_equations = {};
  /// \throws InvalidOption
  std::function<std::unique_ptr<Method>(std::span<const OptionSetting> settings)> make;
  bool exact = false;       ///< its motions are exact orbits, and curves of others are judged by its own
  std::string plugin = {};  ///< SHA-256 of the files that a method of a plugin consists of; else empty
  std::string untimed =
      {};  ///< why its times would mean nothing, as of a plugin without optimiser; else empty
};

template <class M>
concept RegistrableMethod = std::derived_from<M, Method> && requires(typename M::Options options) {
  { M::kName } -> std::convertible_to<std::string_view>;
  { M::kTitle } -> std::convertible_to<std::string_view>;
  { M::kLaws } -> std::convertible_to<std::string_view>;
  { M::kLadder } -> std::convertible_to<std::string_view>;
  M(options);
};

/// The catalogue entry of a method class: its constructor validates the options it is given. What a class
/// need not say it says by members of its own: `kLimits`, `kStarts`, `kOrder`, `kSameEquations`, `kExact`.
template <RegistrableMethod M>
MethodEntry method_entry() {
  MethodEntry entry{.name = std::string(M::kName),
                    .title = std::string(M::kTitle),
                    .laws = std::string(M::kLaws),
                    .ladder = std::string(M::kLadder),
                    .make = [](std::span<const OptionSetting> settings) -> std::unique_ptr<Method> {
                      typename M::Options options;
                      apply_settings(options, settings);
                      return std::make_unique<M>(options);
                    }};
  if constexpr (requires { M::kLimits; }) entry.limits = M::kLimits;
  if constexpr (requires { M::kStarts; }) entry.starts = M::kStarts;
  if constexpr (requires { M::kOrder; }) entry.order = M::kOrder;
  if constexpr (requires { M::kExact; }) entry.exact = M::kExact;
  if constexpr (requires { M::kSameEquations; })
    for (const auto& [option, value, method] : M::kSameEquations)
      entry.same_equations.push_back({std::string(option), std::string(value), std::string(method)});
  return entry;
}

/// All methods, in table order: those of the program, then those of plugins by name.
std::span<const MethodEntry> method_catalogue();

/// Adds a method of a plugin. To be called before anyone keeps a pointer to an entry: they move.
/// \throws InvalidOption unless the name is new and in lower-kebab-case
void add_method(MethodEntry entry);

/// The method whose equations this one solves too with these complete options; empty: none is known.
std::string same_equations_as(const MethodEntry& entry, std::span<const OptionEcho> options);

/// The first method whose motions are exact orbits.
const MethodEntry& exact_method();

/// The entry of that name. \throws InvalidOption listing the names there are.
const MethodEntry& find_method(std::string_view name);

}  // namespace signorini
