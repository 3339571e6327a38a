#pragma once
// The mesh of a solid body of any form: its nodes, its elements, and named groups of these.

#include <Eigen/Core>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "problems/assembly/element_shapes.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Elements of one shape.
struct ElementList {
  const ElementShape* shape = nullptr;  ///< one of element_shapes()
  std::vector<int> nodes = {};          ///< shape->nodes of them for each element, one after the other

  /// Number of elements.
  [[nodiscard]] int count() const { return static_cast<int>(nodes.size()) / shape->nodes; }
  /// The nodes of an element.
  [[nodiscard]] std::span<const int> of(int element) const {
    const auto n = static_cast<std::size_t>(shape->nodes);
    return std::span(nodes).subspan(n * static_cast<std::size_t>(element), n);
  }
};

/// A named part of a mesh: points, lines and faces.
using MeshGroup = std::vector<ElementList>;

/// A mesh of solid elements. Nodes that are held at rest come first. Coordinate 3 n + a is the displacement
/// along axis a of the n-th node that can move [m].
struct SolidMesh {
  std::vector<Eigen::Vector3d> nodes;                    ///< places [m]; each is on an element
  std::vector<ElementList> solids;                       ///< of three dimensions, any shape once
  std::map<std::string, MeshGroup, std::less<>> groups;  ///< of fewer dimensions
  int held = 0;                                          ///< nodes at rest

  /// Nd, three per node that can move.
  [[nodiscard]] int size() const { return 3 * (static_cast<int>(nodes.size()) - held); }
  /// Coordinate of a node along an axis; negative of a node at rest.
  [[nodiscard]] int coordinate(int node, int axis) const { return 3 * (node - held) + axis; }
  /// Node and axis of a coordinate.
  [[nodiscard]] std::pair<int, int> place(int coordinate) const {
    return {coordinate / 3 + held, coordinate % 3};
  }
};

/// The nodes of a group, rising, each once.
std::vector<int> nodes_of(const MeshGroup& group);

/// The mesh with all nodes of these groups at rest, besides those that were; the others keep their order.
/// Each name is one of mesh.groups.
SolidMesh held_at(SolidMesh mesh, const std::vector<std::string>& groups);

/// One contact for every node of the group that can move, in the order of their coordinates: its displacement
/// along the axis, upwards or downwards, is limited by `gap`.
std::vector<Contact> contacts_on_group(const SolidMesh& mesh, const MeshGroup& group, int axis, bool upward,
                                       double gap);

/// Forces at the nodes, by coordinate, of a force of 1 N spread evenly over a group and acting along an
/// axis: the consistent load on what has the most dimensions in the group, faces say; of points alone, equal
/// shares [-]. What falls on nodes at rest is left out.
std::vector<std::pair<int, double>> load_on_group(const SolidMesh& mesh, const MeshGroup& group, int axis);

/// An element at a point of its quadrature rule, in space.
struct ElementPoint {
  double volume = 0.0;             ///< weight of the point times the volume of the element there [m^3]
  Eigen::VectorXd values = {};     ///< shape functions, n [-]
  Eigen::MatrixXd gradients = {};  ///< their gradients in space, n x 3 [1/m]
};

/// Calls visit(nodes, points) for every solid element: its nodes, and the element at all points of its rule.
/// \throws InvalidProblem (system.mesh) for an element without volume at a point, or turned inside out within
void for_each_solid(
    const SolidMesh& mesh,
    const std::function<void(std::span<const int> nodes, const std::vector<ElementPoint>& points)>& visit);

}  // namespace signorini
