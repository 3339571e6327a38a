// Families: one file, a scene per level.

#include "problems/scene/scene_family.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>
#include <set>

#include "problems/scene/scene_file.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::test::scene_family_test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFamily = R"(schema = 1
name = "softer"
title = "A spring that gives way"
[family]
parameter = "stiffness of the spring [N/m]"
levels = [1.0, 1e-4, 1e-8]
[family.values]
"system.stiffness" = [1.0, 1e-4, 1e-8]
"contact[0].gap" = [0.2, 0.3, 0.4]
[system]
kind = "sdof"
mass = 1.0
damping = 0.1
stiffness = 7.0
[forcing]
frequency = 2.0
[[contact]]
dof = 0
gap = 0.1
[law]
restitution = 0.5
)";

std::string replaced(std::string_view from, std::string_view to) {
  std::string text(kFamily);
  return text.replace(text.find(from), from.size(), to);
}

// What the reader says of a level, "" if nothing.
std::string complaint(std::string_view text, std::string_view level) {
  try {
    parse_scene(text, "family.toml", level);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(SceneFamily, GivesEachLevelItsValuesAndItsName) {
  const Problem scene = parse_scene(kFamily, "family.toml", "1e-4");
  EXPECT_EQ(scene.name, "softer@1e-4");
  EXPECT_EQ(scene.title, "A spring that gives way");
  EXPECT_DOUBLE_EQ(scene.stiffness().coeff(0, 0), 1e-4);
  EXPECT_DOUBLE_EQ(scene.contacts.at(0).gap, 0.3);
  EXPECT_DOUBLE_EQ(scene.mass().coeff(0, 0), 1.0);
  const FamilyLevel expected{.family = "softer",
                             .parameter = "stiffness of the spring [N/m]",
                             .level = 1e-4,
                             .severity = 2,
                             .levels = 3};
  EXPECT_EQ(parse_scene_with_sources(kFamily, "family.toml", "1e-4").family, expected);
  EXPECT_EQ(parse_scene_with_sources(kFamily, "family.toml", "0.0001").family, expected);
}

TEST(SceneFamily, LabelsALevelByTheShortestTextThatReadsBack) {
  EXPECT_EQ(level_label(1e-8), "1e-8");
  EXPECT_EQ(level_label(1.5e-10), "1.5e-10");
  EXPECT_EQ(level_label(1e20), "1e20");
  EXPECT_EQ(level_label(0.5), "0.5");
  EXPECT_EQ(level_label(0.0), "0");
  EXPECT_EQ(level_label(1e6), "1e6");
  EXPECT_EQ(level_label(150), "150");
  EXPECT_EQ(level_label(-2.5), "-2.5");
}

TEST(SceneFamily, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint(kFamily, ""),
            "family.toml:6: family.levels = [1, 0.0001, 1e-08] (must hold the level asked for, none, as in "
            "NAME@1)");
  EXPECT_EQ(
      complaint(kFamily, "2"),
      "family.toml:6: family.levels = [1, 0.0001, 1e-08] (must hold the level asked for, 2, as in NAME@1)");
  EXPECT_EQ(complaint(replaced("1e-4, 1e-8]\n[family.values]", "1e-4, 1.0]\n[family.values]"), "1"),
            "family.toml:6: family.levels[2] = 1 (must be a list of different numbers, easiest first)");
  EXPECT_EQ(
      complaint(replaced("[0.2, 0.3, 0.4]", "[0.2, 0.3]"), "1"),
      "family.toml:9: family.values.contact[0].gap = [0.2, 0.3] (must be a list of 3 values, one per level, "
      "for something that stands in this file)");
  EXPECT_EQ(
      complaint(replaced("contact[0].gap", "contact[1].gap"), "1"),
      "family.toml:9: family.values.contact[1].gap = [0.2, 0.3, 0.4] (must be a list of 3 values, one per "
      "level, for something that stands in this file)");
  EXPECT_EQ(complaint(replaced("0.3", "\"wide\""), "1e-4"),
            "family.toml:9: contact[0].gap = \"wide\" (must be a finite number [m])");
  EXPECT_EQ(complaint(replaced("parameter", "driver"), "1"),
            "family.toml:5: family.driver = \"stiffness of the spring [N/m]\" (unknown key; known: "
            "parameter, levels, "
            "values)");
}

TEST(SceneFamily, RefusesAMalformedIndexInsteadOfDrivingAnotherContact) {
  for (const std::string path : {"contact[x].gap", "contact[].gap", "contact[0x].gap", "contact[-1].gap",
                                 "contact[0]gap", "contact[0", "contact[99999999999999999999].gap"}) {
    EXPECT_EQ(complaint(replaced("contact[0].gap", path), "1"),
              "family.toml:9: family.values." + path +
                  " = [0.2, 0.3, 0.4] (must be a list of 3 values, one per level, for something that stands "
                  "in this file)");
  }
}

TEST(SceneFamily, HasNoLevelWhereThereIsNone) {
  std::string plain(kFamily);
  const std::size_t begin = plain.find("[family]");
  plain.erase(begin, plain.find("[system]") - begin);
  EXPECT_EQ(parse_scene(plain, "plain.toml").name, "softer");
  EXPECT_FALSE(parse_scene_with_sources(plain, "plain.toml").family.has_value());
  EXPECT_EQ(complaint(plain, "1"),
            "family.toml:1: family = missing (must be there for the scene to have a level 1)");
}

// Families of the suite hard show where methods break, others what a published study varied.
TEST(ShippedFamilies, DriveValidLevelsFiveAtLeastWhereTheyAreHard) {
  std::map<std::string, std::set<double>> levels, hard;
  for (const SceneSource& source : shipped_scenes()) {
    if (source.level.empty()) continue;  // a scene by itself
    SCOPED_TRACE(source.file.string() + "@" + source.level);
    const Problem scene = load_scene(source);
    const SceneHeader header = load_header(source);
    ASSERT_TRUE(header.family.has_value());
    EXPECT_EQ(header.name, scene.name);
    EXPECT_EQ(source.file.stem(), header.family->family);
    EXPECT_EQ(scene.name, header.family->family + "@" + source.level);
    EXPECT_TRUE(header.carries("hard") || !header.reference.empty());
    EXPECT_EQ(find_scene(scene.name), source);
    EXPECT_EQ(find_scene(source.file.string() + "@" + source.level), source);
    levels[header.family->family].insert(header.family->level);
    if (header.carries("hard")) hard[header.family->family].insert(header.family->level);
  }
  EXPECT_GE(hard.size(), 14U);
  for (const auto& [family, values] : hard) EXPECT_GE(values.size(), 5U) << family;
  for (const auto& [family, values] : levels) EXPECT_GE(values.size(), 3U) << family;
}

// All dimensionless numbers of the oscillator are those of the first level.
TEST(ShippedFamilies, StateOneSceneInSeveralUnits) {
  const auto numbers = [](const Problem& scene) {
    const double m = scene.mass().coeff(0, 0), w = scene.frequency, gap = scene.contacts.at(0).gap;
    return Eigen::Vector3d(scene.stiffness().coeff(0, 0) / (m * w * w), scene.damping().coeff(0, 0) / (m * w),
                           scene.force.at(0).cos / (m * w * w * gap));
  };
  const Eigen::Vector3d expected = numbers(load_scene(find_scene("units@1")));
  int others = 0;
  for (const SceneSource& source : shipped_scenes()) {
    if (source.file.stem() != "units" || source.level == "1") continue;
    ++others;
    EXPECT_LE((numbers(load_scene(source)) - expected).norm(), 1e-14 * expected.norm()) << source.level;
  }
  EXPECT_GE(others, 4);
}

TEST(SceneFamily, HasAtMostAThousandLevels) {
  std::string levels;
  for (int i = 0; i < 300000; ++i) levels += std::to_string(i) + ", ";
  const TemporaryFolder folder;
  const fs::path file = folder.write("many.toml", "[family]\nlevels = [" + levels + "]\n");
  try {
    load_levels(file);
    ADD_FAILURE();
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what()),
              file.string() + ":2: family.levels = 300000 levels (must be at most 1000)");
  }
}

}  // namespace
}  // namespace signorini::test::scene_family_test
