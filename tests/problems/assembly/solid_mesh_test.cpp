#include "problems/assembly/solid_mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numeric>

#include "problems/validation.hpp"
#include "tests/problems/assembly/box_meshes.hpp"

namespace signorini::solid_mesh_test {
namespace {

using test::BoxMesh;
using test::distorted_box;
using test::kSolidTypes;

const Eigen::Vector3d kLengths(1.2, 0.5, 0.3);
const double kVolume = kLengths.prod();

/// A mesh of places and of one list of elements, a group of it.
SolidMesh patch(int gmsh_type, const std::vector<Eigen::Vector3d>& places) {
  SolidMesh mesh{.nodes = places, .solids = {}, .groups = {}};
  ElementList elements{.shape = shape_of_gmsh_type(gmsh_type)};
  elements.nodes.resize(places.size());
  std::iota(elements.nodes.begin(), elements.nodes.end(), 0);
  mesh.groups["patch"] = {elements};
  return mesh;
}

/// The one element of a list, of its reference nodes put anywhere.
SolidMesh single_solid(int gmsh_type, const Eigen::Matrix3d& map, const Eigen::Vector3d& shift) {
  SolidMesh mesh;
  ElementList elements{.shape = shape_of_gmsh_type(gmsh_type)};
  const Eigen::Matrix3Xd reference = reference_nodes(*elements.shape);
  for (int node = 0; node < elements.shape->nodes; ++node) {
    mesh.nodes.emplace_back(map * reference.col(node) + shift);
    elements.nodes.push_back(node);
  }
  mesh.solids = {elements};
  return mesh;
}

/// By node, the shares along z of a force of 1 N on a group.
Eigen::VectorXd shares(const SolidMesh& mesh, const std::string& group) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(std::ssize(mesh.nodes));
  for (const auto& [dof, share] : load_on_group(mesh, mesh.groups.at(group), 2)) {
    const auto [node, axis] = mesh.place(dof);
    EXPECT_EQ(axis, 2);
    EXPECT_GE(node, mesh.held);
    result[node] += share;
  }
  return result;
}

void expect_near(const Eigen::VectorXd& found, const Eigen::VectorXd& expected) {
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-14) << found.transpose();
}

double volume(const SolidMesh& mesh) {
  double sum = 0.0;
  for_each_solid(mesh, [&](std::span<const int>, const std::vector<ElementPoint>& points) {
    for (const ElementPoint& point : points) {
      EXPECT_GT(point.volume, 0.0);
      sum += point.volume;
    }
  });
  return sum;
}

std::string refusal(const SolidMesh& mesh) {
  try {
    volume(mesh);
    return "";
  } catch (const InvalidProblem& error) {
    return error.what();
  }
}

TEST(SolidMesh, CountsThreeCoordinatesPerNodeThatCanMove) {
  const SolidMesh mesh = held_at(BoxMesh(5, {3, 2, 4}, kLengths), {"x-"});
  EXPECT_EQ(mesh.held, 15);
  EXPECT_EQ(mesh.size(), 3 * 3 * 15);
  EXPECT_EQ(mesh.coordinate(15, 0), 0);
  EXPECT_EQ(mesh.coordinate(17, 2), 8);
  EXPECT_LT(mesh.coordinate(14, 2), 0) << "at rest";
  for (int dof = 0; dof < mesh.size(); ++dof) {
    const auto [node, axis] = mesh.place(dof);
    EXPECT_EQ(mesh.coordinate(node, axis), dof);
  }
}

TEST(NodesOf, AreThoseOfAllItsElementsOnce) {
  const MeshGroup group{{.shape = shape_of_gmsh_type(2), .nodes = {7, 3, 5, 5, 3, 9}},
                        {.shape = shape_of_gmsh_type(15), .nodes = {1, 7}}};
  EXPECT_EQ(nodes_of(group), (std::vector<int>{1, 3, 5, 7, 9}));
  EXPECT_TRUE(nodes_of({}).empty());
}

TEST(HeldAt, PutsHeldNodesFirstAndKeepsTheGeometry) {
  for (const int type : kSolidTypes) {
    const BoxMesh before = distorted_box(type, {2, 1, 1}, kLengths);
    const SolidMesh after = held_at(held_at(before, {"x+"}), {"z-"});
    const auto at_rest = [](const Eigen::Vector3d& place) {
      return std::abs(place.x() - kLengths.x()) < 1e-12 || std::abs(place.z()) < 1e-12;
    };
    for (int node = 0; node < std::ssize(after.nodes); ++node)
      EXPECT_EQ(at_rest(after.nodes[static_cast<std::size_t>(node)]), node < after.held) << node;
    const auto expect_same_places = [&](const ElementList& one, const ElementList& other) {
      ASSERT_EQ(one.nodes.size(), other.nodes.size());
      EXPECT_EQ(one.shape, other.shape);
      for (std::size_t i = 0; i < one.nodes.size(); ++i)
        EXPECT_EQ(before.nodes[static_cast<std::size_t>(one.nodes[i])],
                  after.nodes[static_cast<std::size_t>(other.nodes[i])]);
    };
    expect_same_places(before.solids.front(), after.solids.front());
    for (const auto& [name, group] : before.groups)
      expect_same_places(group.front(), after.groups.at(name).front());
  }
}

TEST(HeldAt, KeepsTheOrderOfTheOthersAndHoldsInOneGoAsInTwo) {
  const BoxMesh box(11, {2, 2, 1}, kLengths);
  const SolidMesh once = held_at(box, {"x+", "z-"});
  const SolidMesh nothing = held_at(box, {});
  EXPECT_EQ(nothing.held, 0);
  EXPECT_EQ(nothing.nodes, box.nodes);
  std::vector<Eigen::Vector3d> expected;
  for (const bool resting : {true, false}) {
    for (const Eigen::Vector3d& place : box.nodes) {
      if ((place.x() == kLengths.x() || place.z() == 0.0) == resting) expected.push_back(place);
    }
  }
  EXPECT_EQ(once.nodes, expected);
}

TEST(ContactsOnGroup, AreOnItsNodesThatCanMove) {
  const SolidMesh mesh = held_at(BoxMesh(12, {2, 1, 1}, kLengths), {"x-"});
  const auto above = contacts_on_group(mesh, mesh.groups.at("z+"), 2, true, 0.25);
  ASSERT_EQ(above.size(), 4U * 3U) << "of 5 x 3 nodes 3 are at rest";
  int last = -1;
  for (const Contact& contact : above) {
    ASSERT_EQ(contact.normal.size(), 1U);
    const auto [dof, coefficient] = contact.normal[0];
    const auto [node, axis] = mesh.place(dof);
    EXPECT_EQ(axis, 2);
    EXPECT_EQ(coefficient, 1.0);
    EXPECT_EQ(contact.gap, 0.25);
    EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(node)].z(), kLengths.z());
    EXPECT_GT(dof, last) << "in the order of their coordinates";
    last = dof;
  }
  const auto below = contacts_on_group(mesh, mesh.groups.at("y-"), 0, false, -0.1);
  ASSERT_EQ(below.size(), 4U * 3U);
  EXPECT_EQ(below[0].normal[0].first % 3, 0);
  EXPECT_EQ(below[0].normal[0].second, -1.0);
  EXPECT_TRUE(contacts_on_group(mesh, mesh.groups.at("x-"), 0, false, 0.0).empty());
}

TEST(LoadOnGroup, IsTheConsistentOneOfEachShape) {
  const Eigen::Vector3d o(0.1, 0.2, 0.3), a(2.0, 0.1, 0.0), b(0.4, 1.0, 0.7);
  const auto at = [&](double s, double t) { return Eigen::Vector3d(o + s * a + t * b); };
  expect_near(shares(patch(1, {o, a}), "patch"), Eigen::Vector2d(0.5, 0.5));
  expect_near(shares(patch(8, {o, at(1, 0), at(0.5, 0)}), "patch"), Eigen::Vector3d(1, 1, 4) / 6.0);
  expect_near(shares(patch(2, {o, a, b}), "patch"), Eigen::Vector3d::Constant(1.0 / 3.0));
  Eigen::VectorXd triangle(6);
  triangle << 0, 0, 0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0;
  const SolidMesh six = patch(9, {o, at(1, 0), at(0, 1), at(0.5, 0), at(0.5, 0.5), at(0, 0.5)});
  expect_near(shares(six, "patch"), triangle);
  expect_near(shares(patch(3, {o, at(1, 0), at(1, 1), at(0, 1)}), "patch"), Eigen::Vector4d::Constant(0.25));
  Eigen::VectorXd quadrangle(9);
  quadrangle << 1, 1, 1, 1, 4, 4, 4, 4, 16;
  expect_near(shares(patch(10, {o, at(1, 0), at(1, 1), at(0, 1), at(0.5, 0), at(1, 0.5), at(0.5, 1),
                                at(0, 0.5), at(0.5, 0.5)}),
                     "patch"),
              quadrangle / 36.0);
  expect_near(shares(patch(15, {o, a, b, o}), "patch"), Eigen::Vector4d::Constant(0.25));
}

// A trapezium of unlike sides: the moments of the force are those of an even traction.
TEST(LoadOnGroup, OfASkewQuadrangleActsInItsMiddle) {
  const SolidMesh mesh = patch(3, {{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 1, 0}});
  const Eigen::VectorXd load = shares(mesh, "patch");
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (int node = 0; node < 4; ++node) middle += load[node] * mesh.nodes[static_cast<std::size_t>(node)];
  EXPECT_NEAR(load.sum(), 1.0, 1e-14);
  EXPECT_NEAR(middle.x(), 19.0 / 15.0, 1e-14);
  EXPECT_NEAR(middle.y(), 7.0 / 15.0, 1e-14);
}

TEST(LoadOnGroup, SumsToOneAndWorksLikeAnEvenTraction) {
  for (const int type : kSolidTypes) {
    const BoxMesh mesh(type, {3, 2, 2}, kLengths);
    for (const auto& [name, group] : mesh.groups) {
      const Eigen::VectorXd load = shares(mesh, name);
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (int node = 0; node < load.size(); ++node)
        middle += load[node] * mesh.nodes[static_cast<std::size_t>(node)];
      Eigen::Vector3d expected = 0.5 * kLengths;
      const auto axis = static_cast<Eigen::Index>(std::string("xyz").find(name[0]));
      expected[axis] = name[1] == '+' ? kLengths[axis] : 0.0;
      EXPECT_NEAR(load.sum(), 1.0, 1e-14) << name;
      EXPECT_LT((middle - expected).norm(), 1e-14) << name;
    }
  }
}

TEST(LoadOnGroup, LeavesOutWhatFallsOnNodesAtRest) {
  const SolidMesh mesh = held_at(BoxMesh(5, {3, 1, 1}, kLengths), {"x-"});
  EXPECT_NEAR(shares(mesh, "z+").sum(), 5.0 / 6.0, 1e-14) << "half a brick's share of three";
  EXPECT_TRUE(load_on_group(mesh, mesh.groups.at("x-"), 1).empty());
}

// The corners of triangles of 6 nodes have no share but rounding.
TEST(LoadOnGroup, LeavesOutNodesWithoutAShare) {
  const BoxMesh mesh(11, {2, 2, 2}, kLengths);
  for (const auto& [dof, share] : load_on_group(mesh, mesh.groups.at("z+"), 2))
    EXPECT_GT(share, 1e-12) << "coordinate " << dof;
}

TEST(LoadOnGroup, IsOnWhatHasTheMostDimensions) {
  SolidMesh mesh = patch(2, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}});
  mesh.groups["patch"] = {{.shape = shape_of_gmsh_type(15), .nodes = {3}},
                          {.shape = shape_of_gmsh_type(2), .nodes = {0, 1, 2}},
                          {.shape = shape_of_gmsh_type(1), .nodes = {2, 3}}};
  expect_near(shares(mesh, "patch"), Eigen::Vector4d(1, 1, 1, 0) / 3.0);
  mesh.groups["patch"].erase(mesh.groups["patch"].begin() + 1);
  expect_near(shares(mesh, "patch"), Eigen::Vector4d(0, 0, 0.5, 0.5));
  EXPECT_TRUE(load_on_group(mesh, {{.shape = shape_of_gmsh_type(2), .nodes = {0, 0, 1}}}, 0).empty())
      << "no area";
}

TEST(ForEachSolid, HasTheVolumeOfTheBody) {
  for (const int type : kSolidTypes) {
    EXPECT_NEAR(volume(BoxMesh(type, {2, 3, 1}, kLengths)), kVolume, 1e-14 * kVolume) << type;
    EXPECT_NEAR(volume(distorted_box(type, {3, 2, 2}, kLengths)), kVolume, 1e-14 * kVolume) << type;
  }
}

TEST(ForEachSolid, TakesElementsCountedTheOtherWayRound) {
  Eigen::Matrix3d map;
  map << 1.0, 0.2, -0.1, 0.3, 0.8, 0.2, 0.0, 0.1, 0.6;
  Eigen::Matrix3d mirror = map;
  mirror.col(2) *= -1.0;
  for (const int type : kSolidTypes) {
    const double reference = shape_of_gmsh_type(type)->simplex ? 1.0 / 6.0 : 8.0;
    for (const Eigen::Matrix3d& way : {map, mirror}) {
      const SolidMesh mesh = single_solid(type, way, Eigen::Vector3d(1, 2, 3));
      const double exact = std::abs(way.determinant()) * reference;
      EXPECT_NEAR(volume(mesh), exact, 1e-14 * exact) << type;
    }
  }
}

// Of the function a . x: its values and its gradient, at every point of every element.
TEST(ForEachSolid, HasValuesAndGradientsInSpace) {
  const Eigen::Vector3d slope(0.7, -1.3, 0.4);
  for (const int type : kSolidTypes) {
    const BoxMesh mesh = distorted_box(type, {2, 2, 2}, kLengths);
    int elements = 0;
    double moment = 0.0;
    for_each_solid(mesh, [&](std::span<const int> nodes, const std::vector<ElementPoint>& points) {
      ++elements;
      Eigen::VectorXd values(std::ssize(nodes));
      for (std::size_t i = 0; i < nodes.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = slope.dot(mesh.nodes[static_cast<std::size_t>(nodes[i])]);
      for (const ElementPoint& point : points) {
        EXPECT_LT((point.gradients.transpose() * values - slope).norm(), 1e-12 * slope.norm()) << type;
        moment += point.volume * point.values.dot(values);
      }
    });
    EXPECT_EQ(elements, mesh.solids.front().count()) << type;
    if (shape_of_gmsh_type(type)->degree > 1) continue;
    const double exact = kVolume * slope.dot(kLengths) / 2.0;
    EXPECT_NEAR(moment, exact, 1e-13 * kVolume) << type;
  }
}

TEST(ForEachSolid, RefusesFlatAndInsideOutElementsAndNamesTheirPlace) {
  const std::string required = " (must have a volume, and not be turned inside out anywhere within)";
  const Eigen::Matrix3d flat = Eigen::Vector3d(1.0, 1.0, 0.0).asDiagonal();
  EXPECT_EQ(refusal(single_solid(4, flat, {1, 2, 3})),
            "system.mesh = an element about (1.25, 2.25, 3)" + required);
  EXPECT_EQ(refusal(single_solid(5, flat, {1, 2, 3})), "system.mesh = an element about (1, 2, 3)" + required);

  SolidMesh turned = single_solid(5, Eigen::Matrix3d::Identity(), {1, 2, 3});
  EXPECT_EQ(refusal(turned), "");
  turned.nodes[6] = {0.0, 1.0, 2.0};  // its last corner beyond the first
  EXPECT_EQ(refusal(turned), "system.mesh = an element about (0.75, 1.75, 2.75)" + required);

  SolidMesh bent = single_solid(11, Eigen::Matrix3d::Identity(), {0, 0, 0});
  bent.nodes[4] = {1.4, 0.0, 0.0};  // the middle of an edge outside of it
  EXPECT_NE(refusal(bent).find("system.mesh = an element about (0.3"), std::string::npos) << refusal(bent);

  SolidMesh huge = single_solid(4, Eigen::Matrix3d::Identity(), {0, 0, 0});
  huge.nodes[1] = {std::numeric_limits<double>::max(), 0.0, 0.0};
  huge.nodes[2] = {0.0, std::numeric_limits<double>::max(), 0.0};
  EXPECT_NE(refusal(huge), "") << "a volume beyond numbers";

  BoxMesh one_bad = BoxMesh(5, {2, 1, 1}, kLengths);
  one_bad.nodes[static_cast<std::size_t>(one_bad.number({2, 1, 1}))] = {0.0, -1.0, -1.0};
  EXPECT_NE(refusal(one_bad), "") << "the second of two";
}

}  // namespace
}  // namespace signorini::solid_mesh_test
