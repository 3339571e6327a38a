#include "methods/catalogue.hpp"

#include <algorithm>
#include <utility>
#include <vector>

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

std::vector<MethodEntry> methods_of_the_program() {
  // One method per line.
  // clang-format off
  return {
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
}

std::vector<MethodEntry>& all_methods() {
  static std::vector<MethodEntry> entries = methods_of_the_program();
  return entries;
}

}  // namespace

std::span<const MethodEntry> method_catalogue() { return all_methods(); }

void add_method(MethodEntry entry) {
  if (!is_lower_kebab_case(entry.name))
    throw InvalidOption("method = " + entry.name + " (must be a name in lower-kebab-case)");
  std::vector<MethodEntry>& entries = all_methods();
  const auto same = [&](const MethodEntry& known) { return known.name == entry.name; };
  if (std::any_of(entries.begin(), entries.end(), same))
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
    if (std::any_of(options.begin(), options.end(), holds)) return same.method;
  }
  return {};
}

const MethodEntry& find_method(std::string_view name) {
  std::string names;
  for (const MethodEntry& entry : method_catalogue()) {
    if (entry.name == name) return entry;
    if (!names.empty()) names += ", ";
    names += entry.name;
  }
  throw InvalidOption("method = " + std::string(name) + " (must be one of " + names + ")");
}

}  // namespace signorini
