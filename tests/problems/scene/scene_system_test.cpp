#include "problems/scene/scene_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace signorini::scene_system_test {
namespace {

SystemDescription read(const std::string& system) {
  const std::string file = "scene.toml";
  const TomlNode tree = parse_toml("[system]\n" + system, "file.toml");
  return read_system(SceneField(tree, file)["system"]);
}

std::string refusal(const std::string& system) {
  try {
    read(system);
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(ReadSystem, AssemblesEveryKindOfAtLeastOneCoordinate) {
  const SystemDescription sdof = read("kind = \"sdof\"\nmass = 2\ndamping = 0.1\nstiffness = 3");
  EXPECT_EQ(sdof.kind, "sdof");
  EXPECT_EQ(sdof.size, 1);
  EXPECT_EQ(sdof.definiteness, Definiteness::to_be_checked);
  const Structure one = *sdof.assemble({});
  EXPECT_EQ(one.mass.coeff(0, 0), 2.0);
  EXPECT_EQ(one.damping.coeff(0, 0), 0.1);
  EXPECT_EQ(one.stiffness.coeff(0, 0), 3.0);
  EXPECT_EQ(read("kind = \"rotor\"\nmass = 2\ndamping = 0.1\nstiffness = 3").size, 2);
}

TEST(ReadSystem, TrustsFiniteElementsAndSpreadsTheirMassByTheContacts) {
  const SystemDescription bar = read(
      "kind = \"bar\"\nelements = 4\nlength = 1\narea = 1\nyoung = 1\ndensity = 1\n"
      "damping = { alpha = 0.1 }\ncontact_mass = \"massless\"");
  EXPECT_EQ(bar.size, 4);
  EXPECT_EQ(bar.definiteness, Definiteness::by_construction);
  EXPECT_GT(bar.assemble({})->mass.coeff(3, 3), 0.0);
  EXPECT_EQ(bar.assemble({3})->mass.coeff(3, 3), 0.0);
}

TEST(ReadSystem, RefusesUnknownKindsAndKeys) {
  EXPECT_NE(refusal("kind = \"plate\"").find("scene.toml:2: system.kind = \"plate\" (must be "),
            std::string::npos);
  EXPECT_NE(refusal("kind = \"sdof\"\nmas = 2").find("system.mas = 2 (unknown key; known: "),
            std::string::npos);
}

TEST(SystemFieldAsWritten, IsTheKeyThatTheKindUses) {
  const std::string file = "scene.toml";
  const TomlNode tree = parse_toml("[system]\nmasses = [1]\nstiffness = 2", "file.toml");
  const SceneField document(tree, file);
  EXPECT_EQ(system_field_as_written(document, "system.mass").path(), "system.masses");
  EXPECT_EQ(system_field_as_written(document, "system.stiffness").path(), "system.stiffness");
  EXPECT_EQ(system_field_as_written(document, "law.restitution").path(), "law.restitution");
}

}  // namespace
}  // namespace signorini::scene_system_test
