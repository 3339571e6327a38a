#pragma once
// Branches of exact orbits with the orbits behind their points.

#include <string>
#include <vector>

#include "methods/curve.hpp"
#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

/// Orbits of one sequence of events.
struct OrbitBranch : Branch {
  std::vector<OrbitGuess> orbits = {};          ///< of each point: state at a section, and the events
  std::vector<OrbitGuess> special_orbits = {};  ///< of each special point
};

/// A BranchDiagram of them.
struct OrbitDiagram {
  std::vector<OrbitBranch> branches = {};
  std::string unfinished = {};          ///< as of a BranchDiagram
  std::vector<std::string> notes = {};  ///< likewise

  /// What is told of it.
  [[nodiscard]] BranchDiagram told() const { return {{branches.begin(), branches.end()}, unfinished, notes}; }
};

}  // namespace signorini
