#pragma once
// Which contacts feel each other's impacts.

#include <span>
#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/linear_flow/flow_structure.hpp"

namespace signorini {

/// Whether an impulse at one of two contacts changes the velocity of the other: w_j^T M^-1 w_k is not zero,
/// to rounding.
bool feel_through_mass(const FlowStructure& structure, int j, int k);

/// Whether an impulse at one of two contacts changes the acceleration of the other by dampers:
/// w_j^T M^-1 D M^-1 w_k or its transpose is not zero, to rounding.
bool feel_through_dampers(const FlowStructure& structure, int j, int k);

/// The parts of a set of contacts that feel each other through the mass, at first or at second hand: an
/// impulse in one of them changes no velocity of the others. Each ascending, in the order of their first.
std::vector<std::vector<int>> impact_groups(const FlowStructure& structure, const std::vector<int>& contacts);

/// How impacts of one instant feel each other.
enum class ImpactCoupling {
  none,     ///< not at all: what follows is the same in any order, and so is its derivative
  dampers,  ///< what follows is the same, its derivative is another one for each order
  mass,     ///< the second meets another speed: what follows is not continuous
};

/// Of two entries of a sequence at one instant; none where one of them takes no impulse.
ImpactCoupling coupling_of(const FlowStructure& structure, const SequenceEvent& a, const SequenceEvent& b);

/// Of all entries of one instant, the strongest; mass where one entry is struck by several contacts.
/// \param before  contacts closed before, Nc
ImpactCoupling coupling_of(const FlowStructure& structure, const std::vector<bool>& before,
                           std::span<const SequenceEvent> events);

}  // namespace signorini
