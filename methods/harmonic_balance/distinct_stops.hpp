#pragma once
// Rigid stops that are given more than once: one constraint, whose force has no unique distribution.

#include <memory>
#include <optional>
#include <vector>

#include "methods/method.hpp"

namespace signorini {

/// A scene in which each rigid stop stands once.
struct DistinctStops {
  Problem problem = {};          ///< with one contact for each of them
  std::vector<int> places = {};  ///< for each contact of the scene, its stop among these
};

/// The distinct stops of a scene; nothing where no rigid stop stands twice. Each spring stands for itself:
/// two equal ones are twice as stiff as one. Stops are the same where normal and gap are equal, entry by
/// entry.
std::optional<DistinctStops> distinct_stops(const Problem& problem);

/// A motion with one contact for each distinct stop as a motion of the whole scene. All contacts of a stop
/// have its displacement and equal shares of its force, the one choice that no order of the contacts changes.
std::shared_ptr<const Trajectory> on_all_contacts(std::shared_ptr<const Trajectory> motion,
                                                  const DistinctStops& stops);

/// A motion of the scene with one contact for each distinct stop, which has the force of all its contacts.
std::shared_ptr<const Trajectory> on_distinct_stops(std::shared_ptr<const Trajectory> motion,
                                                    const DistinctStops& stops);

}  // namespace signorini
