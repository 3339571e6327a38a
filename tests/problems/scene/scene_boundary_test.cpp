#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_system.hpp"

namespace signorini::scene_boundary_test {
namespace {

const std::string kFile = "scene.toml";

/// Five coordinates without faces.
SystemDescription points() { return {.kind = "chain", .size = 5}; }

/// A block of 2 x 1 x 1 bricks.
SystemDescription block() {
  const BlockMesh mesh{.elements = {2, 1, 1}, .lengths = {2.0, 1.0, 1.0}};
  return {.kind = "block", .size = mesh.size(), .layout = mesh};
}

FromTables<Contact> contacts(const std::string& text, const SystemDescription& system = points()) {
  const TomlNode tree = parse_toml(text, "file.toml");
  return read_contacts(SceneField(tree, kFile)["contact"], system);
}

FromTables<ForceTerm> load(const std::string& text, const SystemDescription& system = points()) {
  const TomlNode tree = parse_toml(text, "file.toml");
  return read_load(SceneField(tree, kFile)["term"], system, 1.0);
}

std::string refusal(const std::function<void()>& read) {
  try {
    read();
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(ReadContacts, TakesADofAsANormalOfOneCoordinate) {
  const auto made =
      contacts("[[contact]]\ndof = 3\ngap = 0.1\n[[contact]]\nnormal = [[0, 0.8], [4, -0.6]]\ngap = 0");
  ASSERT_EQ(made.things.size(), 2U);
  EXPECT_EQ(made.things[0].normal, (std::vector<std::pair<int, double>>{{3, 1.0}}));
  EXPECT_EQ(made.things[0].gap, 0.1);
  EXPECT_EQ(made.things[1].normal, (std::vector<std::pair<int, double>>{{0, 0.8}, {4, -0.6}}));
}

TEST(ReadContacts, KnowsTheTableThatMadeEachOfARing) {
  const auto made =
      contacts("[[contact]]\ndof = 0\ngap = 1\n[[contact]]\ndofs = [1, 2]\nfacets = 4\ngap = 0.5");
  EXPECT_EQ(made.tables, (std::vector<int>{0, 1, 1, 1, 1}));
  for (std::size_t j = 1; j < 5; ++j) {
    double length2 = 0.0;
    for (const auto& [dof, coefficient] : made.things[j].normal) length2 += coefficient * coefficient;
    EXPECT_NEAR(length2, 1.0, 1e-15);
    EXPECT_EQ(made.things[j].gap, 0.5);
  }
}

TEST(ReadContacts, PutsOneOnEveryNodeOfAFace) {
  const auto made = contacts("[[contact]]\nface = \"z+\"\ngap = 0.2", block());
  EXPECT_EQ(made.things.size(), 4U) << "two by two nodes can move";
  EXPECT_EQ(made.tables, (std::vector<int>{0, 0, 0, 0}));
}

TEST(ReadContacts, RefusesWhatContradictsItself) {
  EXPECT_EQ(refusal([] { contacts("[[contact]]\ndof = 5\ngap = 0"); }),
            "scene.toml:2: contact[0].dof = 5 (must be a coordinate of the system, 0..4)");
  EXPECT_EQ(refusal([] { contacts("[[contact]]\ndof = 1\nnormal = [[1, 1.0]]\ngap = 0"); }),
            "scene.toml:3: contact[0].normal = [[1, 1]] (must be absent: dof is given)");
  EXPECT_EQ(refusal([] { contacts("[[contact]]\nface = \"z+\"\ngap = 0"); }),
            "scene.toml:2: contact[0].face = \"z+\" (must be absent: only a block has faces)");
  EXPECT_NE(refusal([] { contacts("[[contact]]\nface = \"x-\"\ngap = 0", block()); }).find("x- is clamped"),
            std::string::npos);
}

TEST(ReadContacts, OfASceneWithoutAnyAreNone) { EXPECT_TRUE(contacts("a = 1").things.empty()); }

TEST(ReadLoad, TakesHarmonicOneUnlessToldOtherwise) {
  const auto made = load("[[term]]\ndof = 2\ncos = 1.5\n[[term]]\ndof = 0\nharmonic = 3\nsin = -2");
  ASSERT_EQ(made.things.size(), 2U);
  EXPECT_EQ(made.things[0].harmonic, 1);
  EXPECT_EQ(made.things[0].cos, 1.5);
  EXPECT_EQ(made.things[0].sin, 0.0);
  EXPECT_EQ(made.things[1].harmonic, 3);
  EXPECT_EQ(made.things[1].sin, -2.0);
}

TEST(ReadLoad, SpreadsAForceOverAFace) {
  const auto made = load("[[term]]\nface = \"x+\"\ndirection = \"y\"\ncos = 8\nsin = 4", block());
  double cos = 0.0, sin = 0.0;
  for (const ForceTerm& term : made.things) {
    EXPECT_EQ(term.dof % 3, 1) << "along y";
    cos += term.cos;
    sin += term.sin;
  }
  EXPECT_NEAR(cos, 8.0, 1e-14);
  EXPECT_NEAR(sin, 4.0, 1e-14);
  EXPECT_EQ(refusal([] { load("[[term]]\ndof = 1\ndirection = \"y\"\ncos = 1"); }),
            "scene.toml:3: term[0].direction = \"y\" (must be absent: neither a face nor a group is given)");
}

}  // namespace
}  // namespace signorini::scene_boundary_test
