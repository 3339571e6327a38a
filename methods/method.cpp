#include "methods/method.hpp"

namespace signorini {

namespace {

struct SameLaw {
  bool operator()(std::monostate, std::monostate) const { return true; }
  bool operator()(Massless, Massless) const { return true; }
  bool operator()(const Restitution& a, const Restitution& b) const { return a.e == b.e; }
  bool operator()(const Penalty& a, const Penalty& b) const { return a.stiffness == b.stiffness; }
  bool operator()(const auto&, const auto&) const { return false; }
};

}  // namespace

RepresentedLaw as_represented(const Law& law) {
  return std::visit([](const auto& held) -> RepresentedLaw { return held; }, law);
}

bool law_matches(const RepresentedLaw& represented, const Law& scene) {
  return std::visit(SameLaw{}, represented, scene);
}

}  // namespace signorini
