// One number of a scene file left free.

#include "problems/scene/varied_scene.hpp"

#include <gtest/gtest.h>

namespace signorini::test::varied_scene_test {
namespace {

TEST(VariedScene, HasTheNumberOfItsPlaceAndOthersAsTheyAre) {
  const VariedScene gap(find_scene("sdof-stop"), "contact[0].gap");
  EXPECT_EQ(gap.value(), 0.2);
  EXPECT_EQ(gap.at(0.35).contacts[0].gap, 0.35);
  EXPECT_EQ(gap.at(0.35).frequency, 2.2);
  const VariedScene load(find_scene("sdof-stop"), "forcing.term[0].cos");
  EXPECT_EQ(load.at(0.7).force[0].cos, 0.7);
  const VariedScene spring(find_scene("chain2-stop"), "system.springs[1]");
  const double before = spring.at(spring.value()).stiffness().coeff(1, 1);
  EXPECT_DOUBLE_EQ(spring.at(spring.value() + 0.25).stiffness().coeff(1, 1), before + 0.25);
}

TEST(VariedScene, OfAFamilyHasItsLevel) {
  const std::string file = find_scene("restitution@0.5").file.string();
  const VariedScene gap({file, "0.5"}, "contact[0].gap");
  EXPECT_EQ(std::get<Restitution>(gap.at(gap.value()).law()).e, 0.5);
}

TEST(VariedScene, RefusesPlacesWithoutANumber) {
  for (const char* place : {"name", "contact", "contact[1].gap", "system.none", "contact[x].gap", ""})
    EXPECT_THROW(VariedScene(find_scene("sdof-stop"), place), SceneError) << place;
}

// Next to a bound of the format a curve looks one step beyond.
TEST(VariedScene, ChecksWhatItIsAskedFor) {
  const VariedScene law(find_scene("sdof-stop"), "law.restitution");
  EXPECT_THROW(law.at(1.01), SceneError);
  EXPECT_EQ(std::get<Restitution>(law.unchecked(1.01).law()).e, 1.01);
}

}  // namespace
}  // namespace signorini::test::varied_scene_test
