#pragma once
// The edges of a solid that a line drawing shows.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "problems/assembly/solid_mesh.hpp"

namespace signorini {

/// Edges of the surface of a mesh, as pairs of nodes, where it turns by more than 35 degrees and at least one
/// of the faces beside faces the reader. Faces are taken plane, through their corners. \param towards
/// direction from the solid to the reader, of any length
std::vector<std::pair<int, int>> sharp_edges(const SolidMesh& mesh, const Eigen::Vector3d& towards);

}  // namespace signorini
