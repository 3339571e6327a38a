#include "harness/schematic/sharp_edges.hpp"

#include <algorithm>
#include <map>

namespace signorini {

namespace {

using Corners = std::vector<int>;

// Corners of the faces of an element, around each of them.
const std::vector<Corners>& faces_of(const ElementShape& shape) {
  static const std::vector<Corners> tetrahedron{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  static const std::vector<Corners> hexahedron{{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                               {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 2, 6, 5}};
  return shape.simplex ? tetrahedron : hexahedron;
}

// A face that no other element shares.
struct SurfaceFace {
  Corners corners = {};                              // around it
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // outwards, of length 1
};

std::vector<SurfaceFace> surface_of(const SolidMesh& mesh) {
  const auto place = [&](int node) { return mesh.nodes[static_cast<std::size_t>(node)]; };
  const auto middle = [&](const auto& nodes) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int node : nodes) sum += place(node);
    return Eigen::Vector3d(sum / static_cast<double>(nodes.size()));
  };
  std::map<Corners, std::vector<SurfaceFace>> faces;  // by their corners in order
  for (const ElementList& elements : mesh.solids) {
    for (int element = 0; element < elements.count(); ++element) {
      const std::span<const int> nodes = elements.of(element);
      const Eigen::Vector3d inside = middle(nodes);
      for (const Corners& corners : faces_of(*elements.shape)) {
        SurfaceFace face;
        for (const int corner : corners) face.corners.push_back(nodes[static_cast<std::size_t>(corner)]);
        const Eigen::Vector3d first = place(face.corners[0]);
        face.normal = (place(face.corners[1]) - first).cross(place(face.corners.back()) - first).normalized();
        if (face.normal.dot(middle(face.corners) - inside) < 0.0) face.normal = -face.normal;
        Corners key = face.corners;
        std::ranges::sort(key);
        faces[key].push_back(std::move(face));
      }
    }
  }
  std::vector<SurfaceFace> surface;
  for (auto& [key, same] : faces) {
    if (same.size() == 1) surface.push_back(std::move(same.front()));
  }
  return surface;
}

}  // namespace

std::vector<std::pair<int, int>> sharp_edges(const SolidMesh& mesh, const Eigen::Vector3d& towards) {
  constexpr double kFlat = 0.82;                                       // cosine of 35 degrees
  std::map<std::pair<int, int>, std::vector<Eigen::Vector3d>> beside;  // normals of the faces at an edge
  for (const SurfaceFace& face : surface_of(mesh)) {
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const auto [low, high] = std::minmax(face.corners[i], face.corners[(i + 1) % face.corners.size()]);
      beside[{low, high}].push_back(face.normal);
    }
  }
  std::vector<std::pair<int, int>> sharp;
  for (const auto& [edge, normals] : beside) {
    const bool turns = normals.size() != 2 || normals[0].dot(normals[1]) < kFlat;
    const bool seen =
        std::ranges::any_of(normals, [&](const auto& normal) { return normal.dot(towards) > 0.0; });
    if (turns && seen) sharp.push_back(edge);
  }
  return sharp;
}

}  // namespace signorini
