#include "methods/flow/impact_groups.hpp"

#include <algorithm>
#include <cmath>

#include "methods/solvers/constants.hpp"

namespace signorini {

bool feel_through_mass(const FlowStructure& structure, int j, int k) {
  const Eigen::MatrixXd& G = structure.delassus;
  return std::abs(G(j, k)) > kMatrixRounding * std::sqrt(G(j, j) * G(k, k));
}

bool feel_through_dampers(const FlowStructure& structure, int j, int k) {
  const auto a = structure.velocity_per_impulse.col(j), b = structure.velocity_per_impulse.col(k);
  const Eigen::VectorXd by_a = structure.damping * a, by_b = structure.damping * b;
  const double largest = std::max(by_a.norm() * b.norm(), by_b.norm() * a.norm());
  return std::max(std::abs(a.dot(by_b)), std::abs(b.dot(by_a))) > kMatrixRounding * largest;
}

std::vector<std::vector<int>> impact_groups(const FlowStructure& structure,
                                            const std::vector<int>& contacts) {
  std::vector<std::vector<int>> groups;
  for (const int contact : contacts) {
    std::vector<int> joined{contact};
    std::erase_if(groups, [&](const std::vector<int>& group) {
      const bool felt =
          std::ranges::any_of(group, [&](int other) { return feel_through_mass(structure, contact, other); });
      if (felt) joined.insert(joined.end(), group.begin(), group.end());
      return felt;
    });
    std::ranges::sort(joined);
    groups.push_back(std::move(joined));
  }
  std::ranges::sort(groups);
  return groups;
}

ImpactCoupling coupling_of(const FlowStructure& structure, const SequenceEvent& a, const SequenceEvent& b) {
  ImpactCoupling found = ImpactCoupling::none;
  if (a.contact == b.contact) return found;  // its events have an order
  for (const int j : a.pushed) {
    for (const int k : b.pushed) {
      if (j == k || feel_through_mass(structure, j, k)) return ImpactCoupling::mass;
      if (feel_through_dampers(structure, j, k)) found = ImpactCoupling::dampers;
    }
  }
  return found;
}

ImpactCoupling coupling_of(const FlowStructure& structure, const std::vector<bool>& before,
                           std::span<const SequenceEvent> events) {
  ImpactCoupling strongest = ImpactCoupling::none;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto struck =
        std::ranges::count_if(events[i].pushed, [&](int j) { return !before[static_cast<std::size_t>(j)]; });
    if (struck > 1) return ImpactCoupling::mass;
    for (std::size_t k = 0; k < i; ++k)
      strongest = std::max(strongest, coupling_of(structure, events[k], events[i]));
  }
  return strongest;
}

}  // namespace signorini
