#include "methods/catalogue.hpp"

#include <array>
#include <string>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"

namespace signorini {

std::span<const MethodEntry> method_catalogue() {
  // One method per line.
  // clang-format off
  static const std::array entries{
      method_entry<HatLcp>(),
      method_entry<FourierLipschitz>(),
      method_entry<PenaltyHbm>(),
      method_entry<AftHbm>(),
      method_entry<EventDriven>(),
      method_entry<ExactOrbitMethod>(),
  };
  // clang-format on
  return entries;
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
