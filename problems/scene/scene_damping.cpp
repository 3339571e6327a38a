#include <fmt/format.h>

#include "problems/scene/scene_system.hpp"

namespace signorini {

ModalDamping read_modal(const SceneField& modal, int size) {
  constexpr std::string_view kRequirement = "must be a damping ratio >= 0 [-], or a list of them";
  if (size > kMostModalCoordinates) {
    modal.refuse(fmt::format("a system of {} coordinates", size),
                 fmt::format("modal damping takes at most {}: use alpha and beta", kMostModalCoordinates));
  }
  if (!modal.is_array()) return {{modal.number(kRequirement, 0.0)}};
  ModalDamping damping;
  for (const SceneField& item : modal.items(kRequirement)) {
    damping.ratios.push_back(item.number("must be a damping ratio >= 0 [-]", 0.0));
  }
  if (std::ssize(damping.ratios) > size) {
    modal.refuse(fmt::format("{} values", damping.ratios.size()), fmt::format("has at most {} modes", size));
  }
  return damping;
}

ProportionalDamping read_rayleigh(const SceneField& rayleigh) {
  const auto read = [&](std::string_view key, std::string_view unit) {
    const SceneField field = rayleigh[key];
    return field.given() ? field.number(fmt::format("must be a number >= 0 {}", unit), 0.0) : 0.0;
  };
  return {.alpha = read("alpha", "[1/s]"), .beta = read("beta", "[s]")};
}

DampingModel read_damping(const SceneField& damping, int size) {
  constexpr std::string_view kRequirement = "must be { alpha = .., beta = .. } or { modal = .. }";
  damping.allow_only({"alpha", "beta", "modal"}, kRequirement);
  const SceneField modal = damping["modal"];
  const bool rayleigh = damping["alpha"].given() || damping["beta"].given();
  if (modal.given() && rayleigh) modal.refuse("must be absent: alpha or beta is given");
  if (modal.given()) return read_modal(modal, size);
  if (!rayleigh) damping.refuse(kRequirement);
  return read_rayleigh(damping);
}

}  // namespace signorini
