#include "problems/assembly/solid_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "problems/linear_algebra/lu.hpp"
#include "problems/validation.hpp"

namespace signorini {

namespace {

// Places of an element's nodes, 3 x n [m].
Eigen::Matrix3Xd places_of(const SolidMesh& mesh, std::span<const int> nodes) {
  Eigen::Matrix3Xd places(3, std::ssize(nodes));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = mesh.nodes[static_cast<std::size_t>(nodes[i])];
  return places;
}

[[noreturn]] void refuse_element(const Eigen::Matrix3Xd& places, const std::string& requirement) {
  const Eigen::Vector3d middle = places.rowwise().mean();
  throw InvalidProblem("system.mesh",
                       fmt::format("an element about ({:g}, {:g}, {:g})", middle.x(), middle.y(), middle.z()),
                       requirement);
}

// Of all nodes, the integral of their shape functions over elements of any dimension.
void add_shares(const SolidMesh& mesh, const ElementList& elements, Eigen::VectorXd& shares) {
  const std::vector<QuadraturePoint> rule = quadrature(*elements.shape);
  for (int element = 0; element < elements.count(); ++element) {
    const std::span<const int> nodes = elements.of(element);
    const Eigen::Matrix3Xd places = places_of(mesh, nodes);
    for (const QuadraturePoint& point : rule) {
      const Eigen::MatrixXd edges = places * point.functions.rightCols(elements.shape->dimension);
      const double measure = std::sqrt(determinant(edges.transpose() * edges));  // 1 of a point
      for (std::size_t i = 0; i < nodes.size(); ++i)
        shares[nodes[i]] += point.weight * measure * point.functions(static_cast<Eigen::Index>(i), 0);
    }
  }
}

}  // namespace

std::vector<int> nodes_of(const MeshGroup& group) {
  std::vector<int> nodes;
  for (const ElementList& elements : group)
    nodes.insert(nodes.end(), elements.nodes.begin(), elements.nodes.end());
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

SolidMesh held_at(SolidMesh mesh, const std::vector<std::string>& groups) {
  std::vector<bool> at_rest(mesh.nodes.size(), false);
  std::fill_n(at_rest.begin(), mesh.held, true);
  for (const std::string& group : groups) {
    for (const int node : nodes_of(mesh.groups.at(group))) at_rest[static_cast<std::size_t>(node)] = true;
  }
  const std::vector<Eigen::Vector3d> before = mesh.nodes;
  std::vector<int> now(before.size());
  int next = 0;
  for (const bool resting : {true, false}) {
    for (std::size_t node = 0; node < before.size(); ++node) {
      if (at_rest[node] != resting) continue;
      mesh.nodes[static_cast<std::size_t>(next)] = before[node];
      now[node] = next++;
    }
    if (resting) mesh.held = next;
  }
  const auto renumber = [&](std::vector<ElementList>& lists) {
    for (ElementList& elements : lists) {
      for (int& node : elements.nodes) node = now[static_cast<std::size_t>(node)];
    }
  };
  renumber(mesh.solids);
  for (auto& [name, group] : mesh.groups) renumber(group);
  return mesh;
}

std::vector<Contact> contacts_on_group(const SolidMesh& mesh, const MeshGroup& group, int axis, bool upward,
                                       double gap) {
  std::vector<Contact> contacts;
  for (const int node : nodes_of(group)) {
    if (node < mesh.held) continue;
    contacts.push_back({.normal = {{mesh.coordinate(node, axis), upward ? 1.0 : -1.0}}, .gap = gap});
  }
  return contacts;
}

std::vector<std::pair<int, double>> load_on_group(const SolidMesh& mesh, const MeshGroup& group, int axis) {
  int dimension = 0;
  for (const ElementList& elements : group) dimension = std::max(dimension, elements.shape->dimension);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(std::ssize(mesh.nodes));
  for (const ElementList& elements : group) {
    if (elements.shape->dimension == dimension) add_shares(mesh, elements, shares);
  }
  const double whole = shares.sum();
  std::vector<std::pair<int, double>> load;
  if (!(whole > 0.0) || !std::isfinite(whole)) return load;
  constexpr double kRounding = 1e-12;  // corners of faces of the second degree may have no share
  const double least = kRounding * shares.cwiseAbs().maxCoeff();
  for (int node = mesh.held; node < shares.size(); ++node) {
    if (std::abs(shares[node]) > least) load.emplace_back(mesh.coordinate(node, axis), shares[node] / whole);
  }
  return load;
}

void for_each_solid(
    const SolidMesh& mesh,
    const std::function<void(std::span<const int> nodes, const std::vector<ElementPoint>& points)>& visit) {
  for (const ElementList& elements : mesh.solids) {
    const std::vector<QuadraturePoint> rule = quadrature(*elements.shape);
    std::vector<ElementPoint> points(rule.size());
    for (int element = 0; element < elements.count(); ++element) {
      const std::span<const int> nodes = elements.of(element);
      const Eigen::Matrix3Xd places = places_of(mesh, nodes);
      double hand = 0.0;  // the sign of the first determinant: meshes may count nodes the other way round
      for (std::size_t i = 0; i < rule.size(); ++i) {
        const Eigen::Matrix3d jacobian = places * rule[i].functions.rightCols<3>();
        const double determinant = jacobian.determinant();
        if (i == 0) hand = determinant < 0.0 ? -1.0 : 1.0;
        if (!(hand * determinant > 0.0) || !std::isfinite(determinant))
          refuse_element(places, "must have a volume, and not be turned inside out anywhere within");
        points[i].volume = rule[i].weight * hand * determinant;
        points[i].values = rule[i].functions.col(0);
        points[i].gradients = rule[i].functions.rightCols<3>() * jacobian.inverse();
      }
      visit(nodes, points);
    }
  }
}

}  // namespace signorini
