#pragma once
// Boxes of elements of any shape that a solid can have, and meshes as Gmsh writes them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "problems/assembly/solid_mesh.hpp"

namespace signorini::test {

/// The types in Gmsh of all elements of three dimensions: tetrahedra of 4 and 10 nodes, hexahedra of 8
/// and 27.
inline constexpr std::array kSolidTypes{4, 11, 5, 12};

/// A box 0..lengths cut into cells, each of them one cube or six tetrahedra (of which three count their nodes
/// the other way round). Nodes are counted along z first, then y, then x. Groups are its faces "x-" to "z+".
class BoxMesh : public SolidMesh {
 public:
  BoxMesh(int gmsh_type, const std::array<int, 3>& cells, const Eigen::Vector3d& lengths)
      : shape_(*shape_of_gmsh_type(gmsh_type)), cells_(cells) {
    for (int i = 0; i <= end(0); ++i) {
      for (int j = 0; j <= end(1); ++j) {
        for (int k = 0; k <= end(2); ++k)
          nodes.emplace_back(
              lengths.cwiseProduct(Eigen::Vector3d(1.0 * i / end(0), 1.0 * j / end(1), 1.0 * k / end(2))));
      }
    }
    solids = {elements_on(Eigen::Vector3d::Zero(), {0, 1, 2}, shape_)};
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool upper : {false, true}) {
        const Eigen::Vector3d from =
            upper ? Eigen::Vector3d(end(axis) * Eigen::Vector3d::Unit(axis)) : Eigen::Vector3d::Zero();
        const std::vector<int> within = axis == 0 ? std::vector{1, 2} : std::vector{0, 3 - axis};
        groups[std::string(1, "xyz"[axis]) + (upper ? '+' : '-')] = {elements_on(from, within, face_shape())};
      }
    }
  }

  /// Number of the last node along an axis.
  [[nodiscard]] int end(int axis) const { return shape_.degree * cells_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] int number(const Eigen::Vector3d& node) const {
    return static_cast<int>(std::lround((node.x() * (end(1) + 1) + node.y()) * (end(2) + 1) + node.z()));
  }

 private:
  [[nodiscard]] const ElementShape& face_shape() const {
    return *std::ranges::find_if(element_shapes(), [&](const ElementShape& face) {
      return face.dimension == 2 && face.degree == shape_.degree && face.simplex == shape_.simplex;
    });
  }

  // All cells of as many axes, beginning at a node.
  [[nodiscard]] ElementList elements_on(const Eigen::Vector3d& from, const std::vector<int>& axes,
                                        const ElementShape& shape) const {
    ElementList list{.shape = &shape};
    std::vector<int> cell(axes.size(), 0);
    const std::function<void(std::size_t)> choose = [&](std::size_t place) {
      if (place < axes.size()) {
        for (int i = 0; i < cells_[static_cast<std::size_t>(axes[place])]; ++i) {
          cell[place] = i;
          choose(place + 1);
        }
        return;
      }
      Eigen::Vector3d corner = from;
      for (std::size_t a = 0; a < axes.size(); ++a) corner[axes[a]] += shape.degree * cell[a];
      add_cell(corner, axes, list);
    };
    choose(0);
    return list;
  }

  void add_cell(const Eigen::Vector3d& corner, std::vector<int> axes, ElementList& list) const {
    const ElementShape& shape = *list.shape;
    const Eigen::MatrixXd reference = reference_nodes(shape);
    do {  // a simplex for every way from the lowest corner to the highest, along the axes in turn
      Eigen::MatrixXd edges = Eigen::MatrixXd::Zero(3, shape.dimension);
      for (int a = 0; a < shape.dimension; ++a) {
        for (int column = a; column < (shape.simplex ? shape.dimension : a + 1); ++column)
          edges(axes[static_cast<std::size_t>(a)], column) = shape.degree;
      }
      for (int node = 0; node < shape.nodes; ++node) {
        const Eigen::VectorXd at =
            shape.simplex ? reference.col(node) : Eigen::VectorXd(0.5 * (reference.col(node).array() + 1.0));
        list.nodes.push_back(number(corner + edges * at));
      }
    } while (shape.simplex && std::ranges::next_permutation(axes).found);
  }

  const ElementShape& shape_;
  std::array<int, 3> cells_;
};

/// The box with its nodes moved within it, corners, edges and faces along themselves: its volume is kept.
inline BoxMesh distorted_box(int gmsh_type, const std::array<int, 3>& cells, const Eigen::Vector3d& lengths) {
  BoxMesh mesh(gmsh_type, cells, lengths);
  for (Eigen::Vector3d& node : mesh.nodes) {
    const Eigen::Vector3d share = std::numbers::pi * node.cwiseQuotient(lengths);
    for (int axis = 0; axis < 3; ++axis)
      node[axis] += 0.06 * lengths[axis] * std::sin(share[axis]) *
                    (1.0 + std::cos(share[(axis + 1) % 3]) - 0.7 * std::cos(share[(axis + 2) % 3]));
  }
  return mesh;
}

/// The text of a mesh in Gmsh's format, its groups on an entity each, tags of nodes from 1.
inline std::string gmsh_text(const SolidMesh& mesh) {
  std::string names, elements, nodes;
  std::array<std::string, 4> entities;
  std::array<int, 4> counts{};
  int tag = 0, blocks = 0, element_tag = 0;
  const auto add_block = [&](const ElementList& list, int entity) {
    ++blocks;
    elements += fmt::format("{} {} {} {}\n", list.shape->dimension, entity, list.shape->gmsh, list.count());
    for (int i = 0; i < list.count(); ++i) {
      elements += fmt::format("{}", ++element_tag);
      for (const int node : list.of(i)) elements += fmt::format(" {}", node + 1);
      elements += '\n';
    }
  };
  for (const auto& [name, group] : mesh.groups) {
    const auto dimension = static_cast<std::size_t>(group.front().shape->dimension);
    names += fmt::format("{} {} \"{}\"\n", dimension, ++tag, name);
    entities[dimension] += fmt::format("{} 0 0 0 {} 1 {}{}\n", tag, dimension == 0 ? "" : "1 1 1", tag,
                                       dimension == 0 ? "" : " 0");
    ++counts[dimension];
    add_block(group.front(), tag);
  }
  for (const ElementList& list : mesh.solids) add_block(list, 1);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) nodes += fmt::format("{}\n", i + 1);
  for (const Eigen::Vector3d& node : mesh.nodes)
    nodes += fmt::format("{} {} {}\n", node.x(), node.y(), node.z());
  return fmt::format(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n{0}\n{1}$EndPhysicalNames\n"
      "$Entities\n{2} {3} {4} 1\n{5}{6}{7}1 0 0 0 1 1 1 0 0\n$EndEntities\n"
      "$Nodes\n1 {8} 1 {8}\n3 1 0 {8}\n{9}$EndNodes\n$Elements\n{10} {11} 1 {11}\n{12}$EndElements\n",
      tag, names, counts[0], counts[1], counts[2], entities[0], entities[1], entities[2], mesh.nodes.size(),
      nodes, blocks, element_tag, elements);
}

}  // namespace signorini::test
