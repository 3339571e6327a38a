#include "problems/scene/scene_layout.hpp"

#include <gtest/gtest.h>

namespace signorini::scene_layout_test {
namespace {

TEST(LoadOutline, HasTheModelOfTheScene) {
  EXPECT_EQ(std::get<Chain>(load_outline(find_scene("sdof-stop")).layout).masses, std::vector<double>{1.0});
  EXPECT_EQ(std::get<Chain>(load_outline(find_scene("chain3-massless")).layout).springs,
            (std::vector{1.0, 1.0, 50.0}));
  EXPECT_EQ(std::get<Bar>(load_outline(find_scene("bar10-massless")).layout).elements, 10);
  EXPECT_EQ(std::get<Beam>(load_outline(find_scene("beam-pair")).layout).count, 2);
  EXPECT_EQ(std::get<BlockMesh>(load_outline(find_scene("block-nine-contacts")).layout).elements,
            (std::array{20, 5, 5}));
  EXPECT_EQ(std::get<Rotor>(load_outline(find_scene("rotor-12-facets")).layout).damping, 0.2);
  EXPECT_EQ(std::get<Shaft>(load_outline(find_scene("shaft-12-facets")).layout).disc_node, 2);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(load_outline(find_scene("matrices-cantilever")).layout));
}

TEST(LoadOutline, OfAFamilyIsThatOfTheLevel) {
  EXPECT_EQ(std::get<Chain>(load_outline(find_scene("mass-ratio@1e-12")).layout).masses.back(), 1e-12);
}

}  // namespace
}  // namespace signorini::scene_layout_test
