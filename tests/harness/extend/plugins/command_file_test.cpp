#include <gtest/gtest.h>

#include <fstream>

#include "harness/extend/plugins/command_method.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::command_file_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription = R"(schema = 1
name = "shell"
title = "A command for tests"
ladder = "level=1|2"
command = ["sh", "script.sh"]
most_contacts = 3
[represents]
restitution = 0.5
massless = "scene"
[[option]]
name = "level"
default = 1
least = 1
most = 3
unit = "[-]"
meaning = "1..3"
[[option]]
name = "form"
default = "a"
choices = ["a", "b"]
unit = "[-]"
meaning = "words"
)";

/// A folder with a description and the script that it names.
fs::path folder_with(const std::string& description, const std::string& script = "exit 0\n") {
  const fs::path folder = test::fresh_folder("command-file");
  std::ofstream(folder / "method.toml") << description;
  std::ofstream(folder / "script.sh") << script;
  return folder;
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kDescription;
  return text.replace(text.find(from), from.size(), to);
}

TEST(ReadCommandFile, TakesEveryKey) {
  const fs::path folder = folder_with(kDescription);
  const CommandDescription description = read_command_file(folder / "method.toml");
  EXPECT_EQ(description.name, "shell");
  EXPECT_EQ(description.ladder, "level=1|2");
  EXPECT_EQ(description.words, (std::vector<std::string>{"sh", (folder / "script.sh").string()}));
  EXPECT_EQ(description.most_contacts, 3);
  EXPECT_FALSE(description.most_coordinates.has_value());
  ASSERT_EQ(description.options.size(), 2U);
  EXPECT_EQ(std::get<long>(description.options[0].value), 1);
  EXPECT_EQ(description.options[0].least, 1.0);
  EXPECT_EQ(description.options[0].most, 3.0);
  EXPECT_EQ(std::get<std::string>(description.options[1].value), "a");
  EXPECT_EQ(description.options[1].choices, (std::vector<std::string>{"a", "b"}));
}

TEST(ReadCommandFile, HashesTheDescriptionAndTheFilesThatItNames) {
  const auto hash = [](const std::string& description, const std::string& script) {
    return read_command_file(folder_with(description, script) / "method.toml").sha256;
  };
  const std::string first = hash(kDescription, "exit 0\n");
  EXPECT_EQ(hash(kDescription, "exit 0\n"), first);
  EXPECT_NE(hash(kDescription, "exit 1\n"), first);
  EXPECT_NE(hash(replaced("1..3", "one to three"), "exit 0\n"), first);
}

TEST(ReadCommandFile, RefusesAProgramThatCannotBeRun) {
  const fs::path folder = folder_with(replaced("\"sh\"", "\"no-such-program-anywhere\""));
  EXPECT_THROW(static_cast<void>(read_command_file(folder / "method.toml")), SceneError);
}

TEST(RepresentedLaws, AreEmptyWhereTheDescriptionNamesNone) {
  const RepresentedLaws laws = read_command_file(folder_with(kDescription) / "method.toml").represents;
  EXPECT_EQ(std::get<Restitution>(laws.on(Restitution{0.8}).value()).e, 0.5);
  EXPECT_TRUE(std::holds_alternative<Massless>(laws.on(Massless{}).value()));
  EXPECT_FALSE(laws.on(Penalty{{1e4}}).has_value());
  EXPECT_FALSE(laws.on(std::monostate{}).has_value());
  EXPECT_EQ(laws.text(), "restitution 0.5, massless");
}

TEST(RepresentedLaws, MayBeThatOfTheSceneOrUndetermined) {
  RepresentedLaws laws;
  laws.restitution = RepresentedLaws::SceneRestitution{};
  EXPECT_EQ(std::get<Restitution>(laws.on(Restitution{0.8}).value()).e, 0.8);
  laws.restitution = Undetermined{};
  EXPECT_TRUE(std::holds_alternative<Undetermined>(laws.on(Restitution{0.8}).value()));
}

TEST(RepresentedLaws, OfDifferentContactsAreAskedForAndEachRepresented) {
  const Law mixed = MixedLaws{{Restitution{0.8}, Spring{3.0}}};
  RepresentedLaws laws{.restitution = Restitution{0.5}, .penalty = true};
  EXPECT_FALSE(laws.on(mixed).has_value());
  laws.mixed = true;
  EXPECT_EQ(std::get<MixedLaws>(laws.on(mixed).value()).laws,
            (std::vector<ContactLaw>{Restitution{0.5}, Spring{3.0}}));
  EXPECT_FALSE(laws.on(MixedLaws{{Restitution{0.8}, Massless{}}}).has_value());
}

}  // namespace
}  // namespace signorini::command_file_test
