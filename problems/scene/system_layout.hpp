#pragma once
// What the system of a scene is made of, and where: what its matrices no longer tell.

#include <memory>
#include <variant>

#include "problems/assembly/beam.hpp"
#include "problems/assembly/block.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/assembly/rotor.hpp"
#include "problems/assembly/solid_mesh.hpp"

namespace signorini {

/// The model that the coordinates of a scene belong to: an oscillator is a chain of one mass; std::monostate
/// where a scene is given by its matrices; a mesh is never null. `contacts` of a model are left empty.
using SystemLayout =
    std::variant<std::monostate, Chain, Bar, Beam, BlockMesh, Rotor, Shaft, std::shared_ptr<const SolidMesh>>;

}  // namespace signorini
