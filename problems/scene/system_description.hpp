#pragma once
// The result of reading a [system] table, of whatever kind.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/assembly/block_mesh.hpp"
#include "problems/structure.hpp"
#include "problems/validation.hpp"

namespace signorini {

/// A [system] table that has been read and checked. Contacts name coordinates and the mass of a structure may
/// depend on where its contacts are: the matrices come last.
struct SystemDescription {
  std::string kind = {};                                    ///< as the scene names it, "beam"
  int size = 0;                                             ///< Nd
  std::optional<BlockMesh> mesh = {};                       ///< whose faces contacts and loads may name
  Definiteness definiteness = Definiteness::to_be_checked;  ///< whether M and K are known to be definite
  std::vector<std::filesystem::path> files = {};            ///< Matrix Market files it was read from
  /// The matrices, given the coordinates that contacts touch.
  /// \throws InvalidProblem if contacts there and the system do not go together
  std::function<Structure(const std::vector<int>& contact_coordinates)> assemble = {};
};

}  // namespace signorini
