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
  std::string name;                  ///< lower-kebab-case
  std::string title;                 ///< one line for people
  std::string laws;                  ///< laws it can represent, for `list`
  std::string ladder;                ///< this and what follows as MethodText has it
  std::string limits = {};           ///< empty: nothing is said
  std::string starts = {};           ///< empty: none
  std::optional<double> order = {};  ///< empty: none is claimed [-]
  /// Whose equations it solves too, wherever the options that both have are equal: an answer that agrees with
  /// theirs confirms nothing.
  std::vector<SameEquations> same_equations = {};
  /// \throws InvalidOption
  std::function<std::unique_ptr<Method>(std::span<const OptionSetting> settings)> make;
  bool exact = false;       ///< as MethodText has it
  std::string plugin = {};  ///< SHA-256 of the files that a method of a plugin consists of; else empty
  std::string untimed =
      {};  ///< why its times would mean nothing, as of a plugin without optimiser; else empty
};

template <class M>
concept RegistrableMethod = std::derived_from<M, Method> && requires(typename M::Options options) {
  { M::kText } -> std::convertible_to<MethodText>;
  requires !M::kText.name.empty() && !M::kText.title.empty();
  requires !M::kText.laws.empty() && !M::kText.ladder.empty();
  M(options);
};

/// The catalogue entry of a method class: its constructor validates the options it is given. Which equations
/// of others it solves too a class may say by a member `kSameEquations`.
template <RegistrableMethod M>
MethodEntry method_entry() {
  const MethodText& text = M::kText;
  MethodEntry entry{.name = std::string(text.name),
                    .title = std::string(text.title),
                    .laws = std::string(text.laws),
                    .ladder = std::string(text.ladder),
                    .limits = std::string(text.limits),
                    .starts = std::string(text.starts),
                    .order = text.order,
                    .make = [](std::span<const OptionSetting> settings) -> std::unique_ptr<Method> {
                      typename M::Options options;
                      apply_settings(options, settings, M::kText.former);
                      return std::make_unique<M>(options);
                    },
                    .exact = text.exact};
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
