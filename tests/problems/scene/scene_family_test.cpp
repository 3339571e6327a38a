// Families: one file, a scene per level.

#include "problems/scene/scene_family.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
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

constexpr std::string_view kRanges = R"(schema = 1
name = "drawn"
[[range]]
places = ["contact[0].gap", "contact[1].gap"]
from = 0.1
to = 0.4
[[range]]
places = ["system.stiffness"]
from = 1.0
to = 1e4
log = true
[[range]]
places = ["law.restitution"]
one_of = [0.0, 0.5]
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
[[contact]]
normal = [[0, -1.0]]
gap = 0.1
[law]
restitution = 0.8
)";

SceneInstance drawn(std::uint64_t seed, int number) {
  return parse_scene_with_sources(kRanges, "drawn.toml", instance_label(seed, number)).instance.value();
}

TEST(SceneInstance, WritesWhatIsDrawnToItsPlaces) {
  const SceneWithSources scene = parse_scene_with_sources(kRanges, "drawn.toml", "7-3");
  EXPECT_EQ(scene.problem.name, "drawn@7-3");
  const SceneInstance& instance = scene.instance.value();
  EXPECT_EQ(instance.scene, "drawn");
  EXPECT_EQ(instance.seed, 7U);
  EXPECT_EQ(instance.number, 3);
  ASSERT_EQ(instance.values.size(), 4U);
  EXPECT_EQ(instance.values[0].first, "contact[0].gap");
  EXPECT_DOUBLE_EQ(scene.problem.contacts.at(0).gap, instance.values[0].second);
  EXPECT_DOUBLE_EQ(scene.problem.contacts.at(1).gap, instance.values[0].second);
  EXPECT_DOUBLE_EQ(scene.problem.stiffness().coeff(0, 0), instance.values[2].second);
  EXPECT_EQ(instance, drawn(7, 3));
}

// Scenes of a seed are the same for everyone: these numbers are from another program, of std::seed_seq,
// std::mt19937_64 and FNV-1a as the standard and their authors state them.
TEST(SceneInstance, IsTheSameEverywhere) {
  const DrawnValues values = drawn(7, 3).values;
  EXPECT_DOUBLE_EQ(values[0].second, 0.385304);
  EXPECT_DOUBLE_EQ(values[2].second, 8101.39);
  EXPECT_DOUBLE_EQ(values[3].second, 0.5);
}

// By the law of large numbers: means of 400 draws, within four standard deviations.
TEST(SceneInstance, FillsItsRanges) {
  double gap = 0.0, logarithm = 0.0, second = 0.0;
  constexpr int kDraws = 400;
  for (int number = 1; number <= kDraws; ++number) {
    const DrawnValues values = drawn(1, number).values;
    EXPECT_GE(values[0].second, 0.1);
    EXPECT_LE(values[0].second, 0.4);
    gap += values[0].second / kDraws;
    logarithm += std::log10(values[2].second) / kDraws;
    second += (values[3].second == 0.5 ? 1.0 : 0.0) / kDraws;
  }
  EXPECT_NEAR(gap, 0.25, 4.0 * 0.3 / std::sqrt(12.0 * kDraws));
  EXPECT_NEAR(logarithm, 2.0, 4.0 * 4.0 / std::sqrt(12.0 * kDraws));
  EXPECT_NEAR(second, 0.5, 4.0 * 0.5 / std::sqrt(1.0 * kDraws));
}

TEST(SceneInstance, IsTheSceneAsWrittenWithoutALabel) {
  const SceneWithSources scene = parse_scene_with_sources(kRanges, "drawn.toml");
  EXPECT_EQ(scene.problem.name, "drawn");
  EXPECT_FALSE(scene.instance);
  EXPECT_DOUBLE_EQ(scene.problem.contacts.at(0).gap, 0.1);
}

TEST(SceneInstance, SaysWhatIsWrongAndWhere) {
  const auto changed = [](std::string_view from, std::string_view to, std::string_view label = "7-3") {
    std::string text(kRanges);
    return complaint(text.replace(text.find(from), from.size(), to), label);
  };
  EXPECT_NE(changed("sdof", "sdof", "0.5").find("SEED-NUMBER"), std::string::npos);
  EXPECT_NE(changed("sdof", "sdof", "7-0").find("SEED-NUMBER"), std::string::npos);
  EXPECT_EQ(changed("to = 0.4", "to = 0.1", ""), "family.toml:6: range[0].to = 0.1 (must be more than from)");
  EXPECT_EQ(changed("from = 1.0", "from = 0.0"),
            "family.toml:9: range[1].from = 0 (must be a number, above 0 for a logarithmic range)");
  EXPECT_NE(changed("contact[1].gap\"]", "contact[2].gap\"]").find("family.toml:4: range[0].places = "),
            std::string::npos);
  EXPECT_NE(changed("one_of = ", "from = 1.0\none_of = ").find("must not be there beside one_of"),
            std::string::npos);
  EXPECT_NE(changed("log = true", "log = 1").find("must be true or false"), std::string::npos);
  EXPECT_NE(changed("places = [\"law", "place = [\"law").find("unknown key"), std::string::npos);
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
