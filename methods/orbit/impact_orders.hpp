#pragma once
// The Floquet multipliers of an orbit, and what becomes of them where impacts happen at one instant.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "methods/flow/impact_groups.hpp"
#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

/// Events within this phase of each other are at one instant: those that a symmetry brings together are so to
/// rounding [rad]
inline constexpr double kOneInstant = 1e-8;

/// What an orbit whose simultaneous impacts feel each other is without: multipliers.
inline constexpr const char* kDependsOnOrder = "depends on the order of simultaneous impacts";

/// One order in which simultaneous impacts can follow each other, as a neighbour of the orbit meets them.
struct ImpactOrder {
  /// Of each instant at which impacts feel each other their contacts in the order of the impacts, those of
  /// the scene.
  std::vector<std::vector<int>> contacts = {};
  double largest = 0.0;  ///< multiplier of the part of the period map that belongs to it, in magnitude [-]
};

/// The multipliers of an orbit, or why it has none.
struct OrbitMultipliers {
  /// Ns. Where the order matters those of the order in which a direction expands, which proves that the orbit
  /// is unstable; empty where none is known to, and where undefined.
  Eigen::VectorXcd values = {};
  std::string undefined = {};            ///< why there are none, one clause; else empty
  std::vector<ImpactOrder> orders = {};  ///< where the order matters and the motion is continuous
};

/// How the simultaneous impacts of an orbit feel each other, the strongest at any instant.
ImpactCoupling simultaneous_coupling(const ContactDynamics& dynamics, const OrbitGuess& orbit);

/// Eigenvalues of the monodromy matrix of an orbit. Impacts at one instant that do not feel each other have
/// the product of their saltations, in any order. Coupled by dampers the period map is continuous and
/// piecewise linear, one part A for each order: where all are equal, to 1e-9, that is the monodromy matrix;
/// where a real eigenvalue of one, above 1, has an eigenvector that meets the stops in the order of its own
/// part, states along it leave the orbit, which is unstable; else nothing is decided. Coupled through the
/// mass the map is not continuous. More than 128 orders are not tried.
///
/// \param orbit      solution of `equations`
/// \param equations  evaluated there
/// \throws std::runtime_error if the time is up
OrbitMultipliers multipliers_of_orbit(OrbitModel& model, const OrbitGuess& orbit,
                                      const OrbitEquations& equations, const Expired& expired = {});

/// "depends on the order of simultaneous impacts; largest multiplier 0.7 (contacts 0 1), 0.7 (1 0)"; empty
/// where it does not.
std::string describe_orders(const OrbitMultipliers& multipliers);

/// The events in another order, with the contacts that are closed after each as each of them changes those.
/// \param before  contacts closed before the first, Nc
/// \param order   of the indices of `events`
std::vector<SequenceEvent> reordered(const std::vector<SequenceEvent>& events,
                                     const std::vector<bool>& before, const std::vector<std::size_t>& order);

/// All orders of the events of a sequence in which simultaneous impacts that do not feel each other through
/// the mass change places, the given one first: of those whose motions may differ, that is of pairs which
/// feel each other by dampers or, where `all`, of all. Empty where they are more than 128.
/// \param phases  of the events [rad], to kOneInstant
std::vector<std::vector<std::size_t>> impact_orders(const FlowStructure& structure,
                                                    const std::vector<SequenceEvent>& events,
                                                    const std::vector<double>& phases, bool all);

}  // namespace signorini
