#include "methods/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"
#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/files/kebab_case.hpp"

namespace signorini {

namespace {

std::vector<MethodEntry>& all_methods() {
  // One method per line.
  // clang-format off
  static std::vector<MethodEntry> entries{
      method_entry<HatLcp>(),
      method_entry<FourierLipschitz>(),
      method_entry<PenaltyHbm>(),
      method_entry<AftHbm>(),
      method_entry<AugmentedLagrangian>(),
      method_entry<ClosedHbm>(),
      method_entry<EventDriven>(),
      method_entry<ExactOrbitMethod>(),
  };
  // clang-format on
  return entries;
}

}  // namespace

std::span<const MethodEntry> method_catalogue() { return all_methods(); }

void add_method(MethodEntry entry) {
  if (!is_lower_kebab_case(entry.name))
    throw InvalidOption("method = " + entry.name + " (must be a name in lower-kebab-case)");
  std::vector<MethodEntry>& entries = all_methods();
  if (std::ranges::find(entries, entry.name, &MethodEntry::name) != entries.end())
    throw InvalidOption("method = " + entry.name + " (must be new: there is a method of that name)");
  // Whatever the order in which plugins are found, tables have one.
  const auto place = std::find_if(entries.begin(), entries.end(), [&](const MethodEntry& known) {
    return !known.plugin.empty() && known.name > entry.name;
  });
  entries.insert(place, std::move(entry));
}

const MethodEntry& exact_method() { return *std::ranges::find(all_methods(), true, &MethodEntry::exact); }

std::string same_equations_as(const MethodEntry& entry, std::span<const OptionEcho> options) {
  for (const SameEquations& same : entry.same_equations) {
    const auto holds = [&](const OptionEcho& option) {
      return option.name == same.option && option.value == OptionValue(same.value);
    };
    if (std::ranges::any_of(options, holds)) return same.method;
  }
  return {};
}

const MethodEntry& find_method(std::string_view name) {
  const std::vector<MethodEntry>& entries = all_methods();
  const auto entry = std::ranges::find(entries, name, &MethodEntry::name);
  if (entry != entries.end()) return *entry;
  std::string names;
  for (const MethodEntry& known : entries) names += (names.empty() ? "" : ", ") + known.name;
  throw InvalidOption(fmt::format("method = {} (must be one of {})", name, names));
}

}  // namespace signorini
