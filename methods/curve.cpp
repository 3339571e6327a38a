#include "methods/curve.hpp"

#include <fmt/format.h>

namespace signorini {

ParametrisedScene over_frequency(const Problem& problem, double from, double to) {
  return {.parameter = std::string(kFrequency), .from = from, .to = to, .at = [problem](double frequency) {
            return at_frequency(problem, frequency);
          }};
}

std::string describe(OrbitStability stability) {
  return std::string(EnumNames<OrbitStability>::values[static_cast<std::size_t>(stability)]);
}

std::string describe(SpecialKind kind) {
  return std::string(EnumNames<SpecialKind>::values[static_cast<std::size_t>(kind)]);
}

Support follows_frequency(const Method& method, const ParametrisedScene& scene) {
  if (scene.parameter != kFrequency) return {false, fmt::format("its curves are over {} alone", kFrequency)};
  if (highest_load_harmonic(scene.at(scene.from)) == 0)
    return {
        false,
        "without a periodic load its equations have the state of rest at every frequency, and do not tell "
        "that of free motions"};
  for (const double end : {scene.from, scene.to}) {
    if (Support support = method.supports(scene.at(end)); !support.ok) return support;
  }
  return {};
}

}  // namespace signorini
