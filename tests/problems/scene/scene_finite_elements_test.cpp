#include <gtest/gtest.h>

#include "problems/scene/scene_system.hpp"

namespace signorini::scene_finite_elements_test {
namespace {

DampingModel read(const std::string& value, int size = 3) {
  const std::string file = "scene.toml";
  const TomlNode tree = parse_toml("damping = " + value, "file.toml");
  return read_damping(SceneField(tree, file)["damping"], size);
}

std::string refusal(const std::string& value, int size = 3) {
  try {
    read(value, size);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(ReadDamping, TakesRayleighsCoefficientsAbsentOnesAsZero) {
  const auto both = std::get<ProportionalDamping>(read("{ alpha = 0.5, beta = 1e-3 }"));
  EXPECT_EQ(both.alpha, 0.5);
  EXPECT_EQ(both.beta, 1e-3);
  EXPECT_EQ(std::get<ProportionalDamping>(read("{ beta = 2 }")).alpha, 0.0);
}

TEST(ReadDamping, TakesOneRatioOrOneForEachMode) {
  EXPECT_EQ(std::get<ModalDamping>(read("{ modal = 0.02 }")).ratios, std::vector<double>{0.02});
  EXPECT_EQ(std::get<ModalDamping>(read("{ modal = [0.1, 0, 0.3] }")).ratios,
            (std::vector<double>{0.1, 0.0, 0.3}));
}

TEST(ReadDamping, RefusesWhatIsNeitherOrBoth) {
  EXPECT_EQ(refusal("{}"),
            "scene.toml:1: damping = {} (must be { alpha = .., beta = .. } or { modal = .. })");
  EXPECT_EQ(refusal("{ modal = 0.1, beta = 1 }"),
            "scene.toml:1: damping.modal = 0.1 (must be absent: alpha or beta is given)");
  EXPECT_EQ(refusal("{ alpha = -1 }"), "scene.toml:1: damping.alpha = -1 (must be a number >= 0 [1/s])");
  EXPECT_EQ(refusal("{ modal = [0.1, 0.2, 0.3, 0.4] }"),
            "scene.toml:1: damping.modal = 4 values (has at most 3 modes)");
  EXPECT_NE(refusal("{ modal = 0.1 }", kMostModalCoordinates + 1).find("use alpha and beta"),
            std::string::npos);
}

}  // namespace
}  // namespace signorini::scene_finite_elements_test
