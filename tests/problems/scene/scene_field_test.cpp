#include "problems/scene/scene_field.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace signorini::scene_field_test {
namespace {

class Fields : public testing::Test {
 protected:
  [[nodiscard]] SceneField document() const { return {tree_, file_}; }

  static std::string refusal(const std::function<void()>& read) {
    try {
      read();
      return "";
    } catch (const SceneError& error) {
      return error.what();
    }
  }

 private:
  std::string file_ = "scene.toml";
  TomlNode tree_ = parse_toml(
      "[forcing]\nfrequency = 2\n[[forcing.term]]\ndof = 3\n[[forcing.term]]\ndof = -1\nname = \"a\\nb\"\n"
      "kind = \"c\"\n",
      file_);
};

TEST_F(Fields, AreFoundByTheirPath) {
  EXPECT_EQ(document().at("forcing.term[1].dof").path(), "forcing.term[1].dof");
  EXPECT_EQ(document().at("forcing.term[0].dof").whole("whole", 0, 9), 3);
  EXPECT_FALSE(document().at("forcing.term[2].dof").given());
  EXPECT_FALSE(document().at("nothing.at.all").given());
  EXPECT_TRUE(document()["forcing"]["term"].is_array());
  EXPECT_EQ(document()["forcing"].keys(), (std::vector<std::string>{"frequency", "term"}));
}

TEST_F(Fields, NameFileLineAndValueInARefusal) {
  EXPECT_EQ(refusal([&] { (void)document().at("forcing.term[1].dof").whole("must be 0..9", 0, 9); }),
            "scene.toml:6: forcing.term[1].dof = -1 (must be 0..9)");
  EXPECT_EQ(refusal([&] { (void)document().at("forcing.term[1].name").text("must be one line"); }),
            "scene.toml:7: forcing.term[1].name = \"a\\nb\" (must be one line)");
}

TEST_F(Fields, ThatAreMissingAreRefusedAtTheTableThatShouldHoldThem) {
  EXPECT_EQ(refusal([&] { (void)document().at("forcing.term[0].harmonic").number("is required"); }),
            "scene.toml:3: forcing.term[0].harmonic = missing (is required)");
  EXPECT_EQ(document().at("forcing.phase").number_or(0.25, "a number"), 0.25);
  EXPECT_EQ(document().at("forcing.subharmonic").whole_or(7, "whole", 1, 9), 7);
}

TEST_F(Fields, TakeWholeNumbersForNumbersAndNotTheOtherWay) {
  EXPECT_EQ(document().at("forcing.frequency").number("a number"), 2.0);
  EXPECT_NE(refusal([&] { (void)document().at("forcing.frequency").number("at least 3", 3.0); }), "");
  EXPECT_NE(refusal([&] { (void)document().at("forcing.frequency").text("text"); }), "");
}

TEST_F(Fields, AreOneOfSomeWords) {
  const SceneField kind = document().at("forcing.term[1].kind");
  EXPECT_EQ(kind.one_of({"b", "c"}), "c");
  EXPECT_EQ(refusal([&] {
              (void)kind.one_of({"a", "b"}, ": no others");
            }),
            "scene.toml:8: forcing.term[1].kind = \"c\" (must be \"a\" or \"b\": no others)");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "\"a\", \"b\" or \"c\"");
}

TEST_F(Fields, SayTheRangeOfAWholeNumber) {
  const SceneField dof = document().at("forcing.term[0].dof");
  EXPECT_EQ(dof.in_range("a mass", 0, 3), 3);
  EXPECT_EQ(refusal([&] { (void)dof.in_range("a mass", 0, 2); }),
            "scene.toml:4: forcing.term[0].dof = 3 (must be a mass, 0..2)");
}

TEST_F(Fields, ThatMustBeAbsentAreRefused) {
  const SceneField forcing = document()["forcing"];
  EXPECT_TRUE(forcing.has_any({"phase", "term"}));
  EXPECT_FALSE(forcing.has_any({"phase"}));
  EXPECT_EQ(refusal([&] { forcing.forbid({"phase"}, "none has one"); }), "");
  EXPECT_EQ(refusal([&] {
              forcing.forbid({"phase", "frequency"}, "all rest");
            }),
            "scene.toml:2: forcing.frequency = 2 (must be absent: all rest)");
  EXPECT_EQ(forcing["term"].items_or_none("a list").size(), 2U);
  EXPECT_TRUE(forcing["phase"].items_or_none("a list").empty());
}

TEST_F(Fields, AllowKnownKeysOnly) {
  EXPECT_EQ(refusal([&] { document()["forcing"].allow_only({"frequency", "term"}, "a table"); }), "");
  EXPECT_EQ(refusal([&] { document()["forcing"].allow_only({"term"}, "a table"); }),
            "scene.toml:2: forcing.frequency = 2 (unknown key; known: term)");
  EXPECT_EQ(refusal([&] { document().at("forcing.frequency").allow_only({"term"}, "must be a table"); }),
            "scene.toml:2: forcing.frequency = 2 (must be a table)");
}

}  // namespace
}  // namespace signorini::scene_field_test
