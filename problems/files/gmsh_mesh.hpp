#pragma once
// Meshes of solid bodies in Gmsh's text format, as Gmsh and most mesh programs write them.

#include <string>
#include <string_view>

#include "problems/assembly/solid_mesh.hpp"

namespace signorini {

/// Largest number of nodes that is read.
inline constexpr int kMostMeshNodes = 2'000'000;

/// Reads a mesh from the text of its file, format 4.1 in ASCII [geuzaine2009]: $MeshFormat, $PhysicalNames,
/// $Entities, $PartitionedEntities, $Nodes and $Elements in any order that defines names before use; other
/// sections are passed over. All elements of three dimensions make the body, whatever volume they are of.
/// Elements of fewer dimensions are kept where their entity belongs to a physical group of that dimension,
/// which is called by its number where it has no name; a part of a partition is in the groups of its entity.
/// Nodes that no
/// solid has are left out (points of construction), the others are in the order of their tags; no node is
/// held at rest. `name` stands for the file in messages. \throws SceneError `NAME:LINE: what = found (what is
/// required)` for anything else: another version or a binary file, an element of another shape than
/// element_shapes() has, a node that is not defined or given twice, a place that is not finite, a group on
/// nodes that no solid has, no solid element, too few or too many lines
SolidMesh read_gmsh_mesh(std::string_view text, const std::string& name);

}  // namespace signorini
