#include "harness/schematic/sharp_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

#include "tests/problems/assembly/box_meshes.hpp"

namespace signorini::sharp_edges_test {
namespace {

using test::BoxMesh;
using test::kSolidTypes;

constexpr std::array kCells{3, 2, 1};
const Eigen::Vector3d kLengths(1.2, 0.5, 0.3);
const Eigen::Vector3d kTowards(0.4, -1.0, 0.6);

using Edges = std::set<std::pair<int, int>>;

Edges edges(const SolidMesh& mesh, const Eigen::Vector3d& towards) {
  const auto found = sharp_edges(mesh, towards);
  Edges result(found.begin(), found.end());
  EXPECT_EQ(result.size(), found.size()) << "each once";
  return result;
}

// Which of the three pairs of faces of the box a point is on: the lower, the upper, or neither.
std::array<int, 3> sides(const Eigen::Vector3d& place) {
  std::array<int, 3> result{};
  for (int axis = 0; axis < 3; ++axis) {
    result[static_cast<std::size_t>(axis)] = place[axis] < 1e-9                    ? -1
                                             : place[axis] > kLengths[axis] - 1e-9 ? 1
                                                                                   : 0;
  }
  return result;
}

// Every edge from corner to corner of a cell, along an edge of the box one of whose two faces the reader
// sees.
Edges expected_outline(const BoxMesh& mesh, int degree, const Eigen::Vector3d& towards) {
  Edges result;
  for (int axis = 0; axis < 3; ++axis) {
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    for (const int one : {-1, 1}) {
      for (const int other : {-1, 1}) {
        if (!(one * towards[first] > 0.0 || other * towards[second] > 0.0)) continue;
        for (int cell = 0; cell < kCells[static_cast<std::size_t>(axis)]; ++cell) {
          Eigen::Vector3d from;
          from[axis] = degree * cell;
          from[first] = one < 0 ? 0 : mesh.end(first);
          from[second] = other < 0 ? 0 : mesh.end(second);
          const Eigen::Vector3d to = from + degree * Eigen::Vector3d::Unit(axis);
          result.insert({mesh.number(from), mesh.number(to)});
        }
      }
    }
  }
  return result;
}

TEST(SharpEdges, OfABoxAreTheNineOfItsOutlineThatTheReaderSees) {
  for (const int type : kSolidTypes) {
    const int degree = shape_of_gmsh_type(type)->degree;
    const BoxMesh mesh(type, kCells, kLengths);
    const Edges seen = edges(mesh, kTowards);
    EXPECT_EQ(seen.size(), 3U * (3 + 2 + 1)) << "of four each along x, y and z three";
    EXPECT_EQ(seen, expected_outline(mesh, degree, kTowards)) << type;
    EXPECT_EQ(seen, edges(mesh, 1e-6 * kTowards)) << "whatever its length";
  }
}

TEST(SharpEdges, OfABoxFromBehindAreTheOthersAndTheRim) {
  for (const int type : kSolidTypes) {
    const BoxMesh mesh(type, kCells, kLengths);
    const Edges front = edges(mesh, kTowards), behind = edges(mesh, -kTowards);
    EXPECT_EQ(behind, expected_outline(mesh, shape_of_gmsh_type(type)->degree, -kTowards)) << type;
    Edges common, all = front;
    std::ranges::set_intersection(front, behind, std::inserter(common, common.end()));
    all.insert(behind.begin(), behind.end());
    EXPECT_EQ(common.size(), 2U * (3 + 2 + 1)) << "the rim, that both see";
    EXPECT_EQ(all.size(), 4U * (3 + 2 + 1)) << "all twelve";
  }
}

TEST(SharpEdges, OfABoxFromAboveAreThoseOfItsTop) {
  const BoxMesh mesh(4, kCells, kLengths);
  const Edges seen = edges(mesh, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(seen.size(), 2U * (3 + 2));
  for (const auto& [from, to] : seen) {
    for (const int node : {from, to}) EXPECT_EQ(sides(mesh.nodes[static_cast<std::size_t>(node)])[2], 1);
  }
}

// A roof whose two sides turn by an angle at its ridge.
TEST(SharpEdges, AreWhereTheSurfaceTurnsByMoreThan35Degrees) {
  for (const int type : kSolidTypes) {
    for (const double degrees : {20.0, 33.0, 37.0, 60.0}) {
      BoxMesh mesh(type, {2, 1, 1}, kLengths);
      const double rise = 0.5 * kLengths.x() * std::tan(0.5 * degrees * std::numbers::pi / 180.0);
      for (Eigen::Vector3d& node : mesh.nodes) {
        const double share = 1.0 - std::abs(2.0 * node.x() / kLengths.x() - 1.0);
        node.z() += rise * share * node.z() / kLengths.z();
      }
      const int degree = shape_of_gmsh_type(type)->degree;
      const std::pair ridge{mesh.number(Eigen::Vector3d(degree, 0, degree)),
                            mesh.number(Eigen::Vector3d(degree, degree, degree))};
      EXPECT_EQ(edges(mesh, Eigen::Vector3d::UnitZ()).contains(ridge), degrees > 35.0)
          << type << ": " << degrees;
      EXPECT_FALSE(edges(mesh, -Eigen::Vector3d::UnitZ()).contains(ridge)) << "it is turned away";
    }
  }
}

TEST(SharpEdges, OfNothingAreNone) { EXPECT_TRUE(sharp_edges(SolidMesh{}, kTowards).empty()); }

}  // namespace
}  // namespace signorini::sharp_edges_test
