#include <gtest/gtest.h>

#include "problems/assembly/block.hpp"

namespace signorini::block_mesh_test {
namespace {

/// 2 x 3 x 1 bricks of 0.5 m x 0.2 m x 0.3 m: 3 x 4 x 2 nodes, of which those at x = 0 are clamped.
const BlockMesh kMesh{.elements = {2, 3, 1}, .lengths = {1.0, 0.6, 0.3}};

TEST(BlockMesh, CountsCoordinatesOfNodesThatCanMove) {
  EXPECT_EQ(kMesh.clamped(), 3 * 4 * 2);
  EXPECT_EQ(kMesh.size(), 3 * 2 * 4 * 2);
  EXPECT_DOUBLE_EQ(kMesh.spacing(1), 0.2);
}

TEST(BlockMesh, NumbersNodesAlongZFirstThenYThenX) {
  EXPECT_EQ(kMesh.number({0, 0, 0}), 0);
  EXPECT_EQ(kMesh.number({0, 0, 1}), 1);
  EXPECT_EQ(kMesh.number({0, 1, 0}), 2);
  EXPECT_EQ(kMesh.number({1, 0, 0}), 8);
  EXPECT_EQ(kMesh.coordinate({1, 0, 0}, 0), 0) << "the first node that can move";
  EXPECT_EQ(kMesh.coordinate({1, 1, 0}, 2), 3 * 2 + 2);
}

TEST(BlockMesh, FindsThePlaceOfEveryCoordinate) {
  for (int coordinate = 0; coordinate < kMesh.size(); ++coordinate) {
    const auto [node, axis] = kMesh.place(coordinate);
    EXPECT_GE(node[0], 1);
    EXPECT_EQ(kMesh.coordinate(node, axis), coordinate);
  }
}

TEST(ForEachNode, VisitsABoxInTheOrderOfTheNumbers) {
  std::vector<int> numbers;
  for_each_node({0, 1, 0}, {1, 2, 1}, [&](const Node& node) { numbers.push_back(kMesh.number(node)); });
  EXPECT_EQ(numbers, (std::vector<int>{2, 3, 4, 5, 10, 11, 12, 13}));
}

TEST(ContactsOnFace, PointOutwardsAtTheNodesOfThePatch) {
  const Face bottom{.axis = 2, .upper = false};
  EXPECT_EQ(bottom.axes(), (std::array<int, 2>{0, 1}));
  // Along x all of it, along y from 0.2 m to 0.4 m: nodes (1..2, 1..2, 0), the clamped ones left out.
  const std::vector<Contact> made = contacts_on_face(kMesh, bottom, {{{0.0, 1.0}, {0.2, 0.4}}}, 0.01);
  ASSERT_EQ(made.size(), 4U);
  EXPECT_EQ(made[0].normal, (std::vector<std::pair<int, double>>{{kMesh.coordinate({1, 1, 0}, 2), -1.0}}));
  EXPECT_EQ(made[3].normal, (std::vector<std::pair<int, double>>{{kMesh.coordinate({2, 2, 0}, 2), -1.0}}));
  EXPECT_EQ(made[3].gap, 0.01);
  EXPECT_TRUE(contacts_on_face(kMesh, bottom, {{{0.6, 0.9}, {0.0, 0.6}}}, 0.01).empty())
      << "no node lies between 0.5 m and 1 m";
}

// A quarter of the force on a brick's face goes to each of its corners.
TEST(LoadOnFace, SpreadsOneNewtonEvenly) {
  double sum = 0.0, corner = 0.0, inner = 0.0;
  for (const auto& [coordinate, share] : load_on_face(kMesh, {.axis = 0, .upper = true}, 1)) {
    const auto [node, axis] = kMesh.place(coordinate);
    EXPECT_EQ(node[0], 2);
    EXPECT_EQ(axis, 1);
    sum += share;
    if (node == Node{2, 0, 0}) corner = share;
    if (node == Node{2, 1, 0}) inner = share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_NEAR(corner, 1.0 / 12.0, 1e-15);
  EXPECT_NEAR(inner, 1.0 / 6.0, 1e-15);
}

}  // namespace
}  // namespace signorini::block_mesh_test
