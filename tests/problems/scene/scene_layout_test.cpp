#include "problems/scene/scene_layout.hpp"

#include <gtest/gtest.h>

namespace signorini::scene_layout_test {
namespace {

TEST(LoadLayout, IsTheModelOfTheScene) {
  EXPECT_EQ(std::get<Chain>(load_layout(find_scene("sdof-stop"))).masses, std::vector<double>{1.0});
  EXPECT_EQ(std::get<Chain>(load_layout(find_scene("chain3-massless"))).springs,
            (std::vector{1.0, 1.0, 50.0}));
  EXPECT_EQ(std::get<Bar>(load_layout(find_scene("bar10-massless"))).elements, 10);
  EXPECT_EQ(std::get<Beam>(load_layout(find_scene("beam-pair"))).count, 2);
  EXPECT_EQ(std::get<BlockMesh>(load_layout(find_scene("block-nine-contacts"))).elements,
            (std::array{20, 5, 5}));
  EXPECT_EQ(std::get<Rotor>(load_layout(find_scene("rotor-12-facets"))).damping, 0.2);
  EXPECT_EQ(std::get<Shaft>(load_layout(find_scene("shaft-12-facets"))).disc_node, 2);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(load_layout(find_scene("matrices-cantilever"))));
}

TEST(LoadLayout, OfAFamilyIsThatOfTheLevel) {
  EXPECT_EQ(std::get<Chain>(load_layout(find_scene("mass-ratio@1e-12"))).masses.back(), 1e-12);
}

}  // namespace
}  // namespace signorini::scene_layout_test
