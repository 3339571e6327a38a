#include "problems/assembly/block.hpp"

namespace signorini {

namespace {

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

}  // namespace signorini
