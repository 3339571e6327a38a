#pragma once
// The one list of methods.

#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "methods/method.hpp"

namespace signorini {

/// A method as the harness sees it before any scene: how to name it, describe it, make one.
struct MethodEntry {
  std::string_view name;    ///< lower-kebab-case
  std::string_view title;   ///< one line for people
  std::string_view laws;    ///< laws it can represent, for `list`
  std::string_view ladder;  ///< resolutions a benchmark runs, "key=v1|v2|v3"
  /// p of error of x ~ h^p, h the step that the ladder refines, on motions with impacts; empty: none is
  /// claimed [-]
  std::optional<double> order = {};
  /// \throws InvalidOption
  std::unique_ptr<Method> (*make)(std::span<const OptionSetting> settings);
};

template <class M>
concept RegistrableMethod = std::derived_from<M, Method> && requires(typename M::Options options) {
  { M::kName } -> std::convertible_to<std::string_view>;
  { M::kTitle } -> std::convertible_to<std::string_view>;
  { M::kLaws } -> std::convertible_to<std::string_view>;
  { M::kLadder } -> std::convertible_to<std::string_view>;
  M(options);
};

/// The order that a method class claims by a member `kOrder`, if it has one.
template <class M>
constexpr std::optional<double> claimed_order() {
  if constexpr (requires { M::kOrder; }) return M::kOrder;
  return std::nullopt;
}

/// The catalogue entry of a method class: its constructor validates the options it is given.
template <RegistrableMethod M>
MethodEntry method_entry() {
  return {.name = M::kName,
          .title = M::kTitle,
          .laws = M::kLaws,
          .ladder = M::kLadder,
          .order = claimed_order<M>(),
          .make = [](std::span<const OptionSetting> settings) -> std::unique_ptr<Method> {
            typename M::Options options;
            apply_settings(options, settings);
            return std::make_unique<M>(options);
          }};
}

/// All methods, in table order.
std::span<const MethodEntry> method_catalogue();

/// The entry of that name. \throws InvalidOption listing the names there are.
const MethodEntry& find_method(std::string_view name);

}  // namespace signorini
