#include "problems/assembly/block.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "problems/validation.hpp"

namespace signorini {

namespace {

// Row 3 c + a: displacement along axis a of corner c; corner 4 p + 2 q + r is at (p, q, r).
using BrickMatrix = Eigen::Matrix<double, 24, 24>;
using Strains = Eigen::Matrix<double, 6, 24>;
using Stress = Eigen::Matrix<double, 6, 6>;

Node corner(int c) { return {c / 4, c / 2 % 2, c % 2}; }

// Shape functions (row 0) and their derivatives by x, y and z (rows 1..3) of the eight corners at a point
// given in parts of the brick, 0..1.
Eigen::Matrix<double, 4, 8> shape_functions(const BlockMesh& mesh, const std::array<double, 3>& point) {
  Eigen::Matrix<double, 4, 8> result;
  for (int c = 0; c < 8; ++c) {
    result.col(c).setOnes();
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const bool far = corner(c)[a] == 1;
      const double value = far ? point[a] : 1.0 - point[a];
      const double slope = (far ? 1.0 : -1.0) / mesh.spacing(axis);
      for (int row = 0; row < 4; ++row) result(row, c) *= row == axis + 1 ? slope : value;
    }
  }
  return result;
}

// Hooke's law for xx, yy, zz, and the engineering shear strains yz, zx, xy.
Stress elasticity(const Block& block) {
  const double shear = block.young / (2.0 * (1.0 + block.poisson));
  const double lame = 2.0 * shear * block.poisson / (1.0 - 2.0 * block.poisson);
  Stress E = Stress::Zero();
  E.topLeftCorner<3, 3>().setConstant(lame);
  E.topLeftCorner<3, 3>().diagonal().array() += 2.0 * shear;
  E.bottomRightCorner<3, 3>().diagonal().setConstant(shear);
  return E;
}

Strains strains(const Eigen::Matrix<double, 4, 8>& shape) {
  Strains B = Strains::Zero();
  for (int c = 0; c < 8; ++c) {
    for (int a = 0; a < 3; ++a) {
      B(a, 3 * c + a) = shape(1 + a, c);
      // The shear strain in the plane across axis a.
      const int b = (a + 1) % 3;
      const int d = (a + 2) % 3;
      B(3 + a, 3 * c + b) = shape(1 + d, c);
      B(3 + a, 3 * c + d) = shape(1 + b, c);
    }
  }
  return B;
}

// Integral over one brick, by Gauss's rule of 2 x 2 x 2 points, of what `integrand` makes of the shape
// functions.
template <class Integrand>
BrickMatrix integral(const BlockMesh& mesh, Integrand integrand) {
  const double offset = 0.5 / std::sqrt(3.0);
  const double weight = mesh.spacing(0) * mesh.spacing(1) * mesh.spacing(2) / 8.0;
  BrickMatrix sum = BrickMatrix::Zero();
  for (int g = 0; g < 8; ++g) {
    std::array<double, 3> point{};
    for (std::size_t a = 0; a < 3; ++a) point[a] = 0.5 + (corner(g)[a] == 1 ? offset : -offset);
    sum += weight * integrand(shape_functions(mesh, point));
  }
  return 0.5 * (sum + sum.transpose());  // symmetric to the last bit
}

BrickMatrix brick_stiffness(const Block& block) {
  const Stress E = elasticity(block);
  return integral(block.mesh, [&](const Eigen::Matrix<double, 4, 8>& shape) -> BrickMatrix {
    const Strains B = strains(shape);
    return B.transpose() * E * B;
  });
}

BrickMatrix brick_mass(const Block& block) {
  if (block.contact_mass == ContactMass::lumped) {
    const BlockMesh& mesh = block.mesh;
    return block.density * mesh.spacing(0) * mesh.spacing(1) * mesh.spacing(2) / 8.0 *
           BrickMatrix::Identity();
  }
  return integral(block.mesh, [&](const Eigen::Matrix<double, 4, 8>& shape) -> BrickMatrix {
    Eigen::Matrix<double, 3, 24> N = Eigen::Matrix<double, 3, 24>::Zero();
    for (int c = 0; c < 8; ++c) N.middleCols<3>(3 * c).diagonal().setConstant(shape(0, c));
    return block.density * N.transpose() * N;
  });
}

// The sum over the bricks that hold both nodes of their element matrices: rows of `row`, columns of `column`.
Eigen::Matrix3d coupling(const BlockMesh& mesh, const BrickMatrix& brick, const Node& row,
                         const Node& column) {
  Node first;  // lowest corners of the first and the last brick
  Node last;
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = std::max({row[a] - 1, column[a] - 1, 0});
    last[a] = std::min({row[a], column[a], mesh.elements[a] - 1});
  }
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for_each_node(first, last, [&](const Node& low) {
    const auto corner_of = [&](const Node& node) {
      return 4 * (node[0] - low[0]) + 2 * (node[1] - low[1]) + node[2] - low[2];
    };
    sum += brick.block<3, 3>(3 * corner_of(row), 3 * corner_of(column));
  });
  return sum;
}

// Sum of one brick matrix over the mesh, column by column: no list of triplets, which would be many times
// the matrix.
SparseMatrix sum_of_bricks(const BlockMesh& mesh, const BrickMatrix& brick) {
  const int size = mesh.clamped() * (mesh.elements[0] + 1);
  SparseMatrix A(size, size);
  Eigen::Index pairs = 1;  // of neighbouring nodes, a node with itself included
  for (const int bricks : mesh.elements) pairs *= 3 * bricks + 1;
  A.reserve(9 * pairs);
  std::vector<std::pair<int, Eigen::Matrix3d>> neighbours;
  for_each_node({0, 0, 0}, mesh.elements, [&](const Node& node) {
    Node first;
    Node last;
    for (std::size_t a = 0; a < 3; ++a) {
      first[a] = std::max(node[a] - 1, 0);
      last[a] = std::min(node[a] + 1, mesh.elements[a]);
    }
    neighbours.clear();
    for_each_node(first, last, [&](const Node& other) {
      neighbours.emplace_back(mesh.number(other), coupling(mesh, brick, other, node));
    });
    for (int axis = 0; axis < 3; ++axis) {
      const int column = 3 * mesh.number(node) + axis;
      A.startVec(column);
      for (const auto& [number, block] : neighbours) {
        for (int b = 0; b < 3; ++b) {
          if (block(b, axis) != 0.0) A.insertBack(3 * number + b, column) = block(b, axis);
        }
      }
    }
  });
  A.finalize();
  return A;
}

// Contact coordinates on the line along their axis through two nodes without contact; all nodes counted.
std::vector<Follower> followers(const Block& block) {
  const BlockMesh& mesh = block.mesh;
  std::vector<bool> touched(static_cast<std::size_t>(mesh.size() + mesh.clamped()), false);
  for (const int dof : block.contacts) touched[static_cast<std::size_t>(dof + mesh.clamped())] = true;
  std::vector<Follower> result;
  for (const int dof : block.contacts) {
    const auto [node, axis] = mesh.place(dof);
    const auto a = static_cast<std::size_t>(axis);
    const auto coordinate_at = [&, node = node, axis = axis](int place) {
      Node other = node;
      other[a] = place;
      return 3 * mesh.number(other) + axis;
    };
    std::vector<bool> contact;  // along the line
    for (int place = 0; place <= mesh.elements[a]; ++place) {
      contact.push_back(touched[static_cast<std::size_t>(coordinate_at(place))]);
    }
    const auto [near, far] = nearest_free_nodes(contact, node[a]);
    if (far < 0) {
      throw InvalidProblem("system.contact_mass", "massless",
                           "must leave two nodes without contact behind each other at every contact, to "
                           "carry its mass");
    }
    const double along = static_cast<double>(node[a] - near) / (far - near);
    result.push_back({.dof = coordinate_at(node[a]),
                      .leaders = {{coordinate_at(near), 1.0 - along}, {coordinate_at(far), along}}});
  }
  return result;
}

constexpr double kOnEdge = 1e-6;  // of a brick's length: rounding of the file's numbers

// Calls visit(node) for every node of a face that can move, in the order of coordinates.
template <class Visit>
void for_each_node_of(const BlockMesh& mesh, const Face& face, Visit visit) {
  Node first = {1, 0, 0};
  Node last = mesh.elements;
  const auto axis = static_cast<std::size_t>(face.axis);
  first[axis] = last[axis] = face.upper ? mesh.elements[axis] : 0;
  for_each_node(first, last, visit);
}

// Nodes of the mesh at both ends of an axis bear half as much as those between.
double share(const BlockMesh& mesh, const Node& node, int axis) {
  const auto a = static_cast<std::size_t>(axis);
  const bool end = node[a] == 0 || node[a] == mesh.elements[a];
  return (end ? 0.5 : 1.0) / mesh.elements[a];
}

}  // namespace

int BlockMesh::size() const { return elements[0] * clamped(); }

int BlockMesh::clamped() const { return 3 * (elements[1] + 1) * (elements[2] + 1); }

double BlockMesh::spacing(int axis) const {
  const auto a = static_cast<std::size_t>(axis);
  return lengths[a] / elements[a];
}

int BlockMesh::number(const Node& node) const {
  return (node[0] * (elements[1] + 1) + node[1]) * (elements[2] + 1) + node[2];
}

int BlockMesh::coordinate(const Node& node, int axis) const { return 3 * number(node) + axis - clamped(); }

std::pair<Node, int> BlockMesh::place(int coordinate) const {
  const int n = (coordinate + clamped()) / 3;
  const int wide = elements[1] + 1;
  const int deep = elements[2] + 1;
  return {{n / deep / wide, n / deep % wide, n % deep}, coordinate % 3};
}

std::array<int, 2> Face::axes() const { return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2}; }

std::vector<Contact> contacts_on_face(const BlockMesh& mesh, const Face& face, const Patch& patch,
                                      double gap) {
  const auto within = [&](const Node& node, std::size_t side) {
    const int axis = face.axes()[side];
    const double place = node[static_cast<std::size_t>(axis)];  // in bricks
    const double h = mesh.spacing(axis);
    return place >= patch[side].first / h - kOnEdge && place <= patch[side].second / h + kOnEdge;
  };
  std::vector<Contact> contacts;
  for_each_node_of(mesh, face, [&](const Node& node) {
    if (!within(node, 0) || !within(node, 1)) return;
    contacts.push_back({.normal = {{mesh.coordinate(node, face.axis), face.upper ? 1.0 : -1.0}}, .gap = gap});
  });
  return contacts;
}

std::vector<std::pair<int, double>> load_on_face(const BlockMesh& mesh, const Face& face, int direction) {
  std::vector<std::pair<int, double>> load;
  const std::array<int, 2> axes = face.axes();
  for_each_node_of(mesh, face, [&](const Node& node) {
    load.emplace_back(mesh.coordinate(node, direction),
                      share(mesh, node, axes[0]) * share(mesh, node, axes[1]));
  });
  return load;
}

SparseMatrix unclamped_mass(const Block& block) {
  if (block.contact_mass != ContactMass::massless) return sum_of_bricks(block.mesh, brick_mass(block));
  return redistributed(sum_of_bricks(block.mesh, brick_mass(block)), followers(block));
}

SparseMatrix unclamped_stiffness(const Block& block) {
  return sum_of_bricks(block.mesh, brick_stiffness(block));
}

Structure assemble(const Block& block) {
  const int fixed = block.mesh.clamped();
  Structure structure{.mass = {}, .damping = {block.mesh.size(), block.mesh.size()}, .stiffness = {}};
  // A statement each: what is not clamped is gone before the next matrix is made.
  clamped(unclamped_mass(block), fixed).swap(structure.mass);
  clamped(unclamped_stiffness(block), fixed).swap(structure.stiffness);
  return structure;
}

}  // namespace signorini
