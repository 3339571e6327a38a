#pragma once
// An elastic block of brick elements, its faces and its nodes.

#include <array>
#include <utility>
#include <vector>

#include "problems/assembly/elements.hpp"
#include "problems/problem.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// Place of a node along x, y and z, each from 0.
using Node = std::array<int, 3>;

/// The box 0 <= x <= lengths[0] and so on, cut into equal bricks, clamped on its face x = 0. Coordinate 3 n +
/// a is the displacement along axis a of node n [m]; the nodes (i, j, k) that can move, i >= 1, are counted
/// n = ((i - 1) (elements[1] + 1) + j) (elements[2] + 1) + k: along z first, then y, then x.
struct BlockMesh {
  std::array<int, 3> elements = {1, 1, 1};          ///< along x, y and z, >= 1
  std::array<double, 3> lengths = {1.0, 1.0, 1.0};  ///< > 0 [m]

  /// Nd, three per node that can move.
  [[nodiscard]] int size() const;
  /// Coordinates of the clamped face, which come first when all nodes are counted.
  [[nodiscard]] int clamped() const;
  /// Length of a brick along an axis [m].
  [[nodiscard]] double spacing(int axis) const;
  /// Number of a node when all are counted, those at x = 0 first, in the same order.
  [[nodiscard]] int number(const Node& node) const;
  /// Coordinate of a node with i >= 1 along an axis.
  [[nodiscard]] int coordinate(const Node& node, int axis) const;
  /// Node and axis of a coordinate.
  [[nodiscard]] std::pair<Node, int> place(int coordinate) const;
};

/// Calls visit(node) for the nodes from `first` to `last` along each axis, both included, in the order of
/// their numbers.
template <class Visit>
void for_each_node(const Node& first, const Node& last, Visit visit) {
  for (int i = first[0]; i <= last[0]; ++i) {
    for (int j = first[1]; j <= last[1]; ++j) {
      for (int k = first[2]; k <= last[2]; ++k) visit(Node{i, j, k});
    }
  }
}

/// A face of a box: the lower or the upper end of an axis.
struct Face {
  int axis = 0;       ///< 0, 1 or 2, to which the face is normal
  bool upper = true;  ///< whether it is the end at the larger coordinate

  /// The two axes within the face, rising.
  [[nodiscard]] std::array<int, 2> axes() const;
};

/// A rectangle on a face: from and to along each of the two axes of the face, both included [m].
using Patch = std::array<std::pair<double, double>, 2>;

/// One contact for every node of the patch that can move, in the order of their coordinates: its displacement
/// along the outward normal of the face is limited by `gap`. A node within a millionth of a brick of the
/// patch is on it. The face is not the clamped one. Empty if the patch holds no node.
std::vector<Contact> contacts_on_face(const BlockMesh& mesh, const Face& face, const Patch& patch,
                                      double gap);

/// Forces at the nodes, by coordinate, of a force of 1 N spread evenly over a face and acting along
/// `direction`: the consistent load of the bricks [-]. What falls on the clamped edge is left out.
std::vector<std::pair<int, double>> load_on_face(const BlockMesh& mesh, const Face& face, int direction);

/// An isotropic block of linear elasticity, clamped on its face x = 0. Coordinates are those of the mesh.
/// The bricks are plain trilinear ones: they bend too stiffly where they are long compared to the waves of
/// the motion, and as `poisson` nears 0.5 they lock.
struct Block {
  BlockMesh mesh;                                      ///< its bricks, which give lengths and coordinates
  double young = 1.0;                                  ///< > 0 [N/m^2]
  double poisson = 0.0;                                ///< between -1 and 0.5 [-]
  double density = 1.0;                                ///< > 0 [kg/m^3]
  ContactMass contact_mass = ContactMass::consistent;  ///< how mass is spread over the nodes
  std::vector<int> contacts = {};  ///< coordinates that contacts touch; of use for ContactMass::massless only
};

/// M and K, at most 81 entries in a row, and D = 0, in time and memory proportional to Nd. Element matrices
/// by 2 x 2 x 2 Gauss points, exact for bricks. Lumped: a brick gives an eighth of its mass to each node.
/// Massless: the displacement a contact touches, along an axis say, follows the straight line along that axis
/// through its two nearest nodes without contact there (clamped ones included): all motions linear in x, y
/// and z are kept, and with them the free block's total mass, first and second moments.
/// \throws InvalidProblem (system.contact_mass) if such a line has less than two nodes left
Structure assemble(const Block& block);

/// M before clamping: the nodes at x = 0 come first, numbered like the others.
SparseMatrix unclamped_mass(const Block& block);

/// K before clamping, in the same order.
SparseMatrix unclamped_stiffness(const Block& block);

}  // namespace signorini
