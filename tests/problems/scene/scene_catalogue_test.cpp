// Scenes by name: problems/scene/scene_catalogue.cpp.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "problems/scene/scene_file.hpp"
#include "tests/problems/scene/malformed_scenes.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::test::scene_catalogue_test {
namespace {

namespace fs = std::filesystem;

// The catalogue of a test; restores the environment.
class CatalogueAt {
 public:
  explicit CatalogueAt(const fs::path& folder) {
    if (const char* before = std::getenv(kVariable)) before_ = before;
    ::setenv(kVariable, folder.c_str(), 1);
  }
  ~CatalogueAt() { before_.empty() ? ::unsetenv(kVariable) : ::setenv(kVariable, before_.c_str(), 1); }
  CatalogueAt(const CatalogueAt&) = delete;
  CatalogueAt& operator=(const CatalogueAt&) = delete;

 private:
  static constexpr const char* kVariable = "SIGNORINI_PROBLEMS";
  std::string before_;
};

template <class Action>
std::string scene_error(Action action) {
  try {
    action();
    return "";
  } catch (const SceneError& error) {
    return error.what();
  }
}

TEST(FindScene, TakesANameOrAPath) {
  const TemporaryFolder folder;
  const fs::path stop = folder.write("catalogue/sdof-stop.toml", kOscillator);
  const fs::path own = folder.write("own.toml", kOscillator);
  const CatalogueAt catalogue(folder.path());

  EXPECT_EQ(problems_folder(), folder.path());
  EXPECT_EQ(find_scene("sdof-stop"), stop);
  EXPECT_EQ(find_scene(stop.string()), stop);
  EXPECT_EQ(find_scene(own.string()), own);
}

TEST(FindScene, SuggestsNamesThatASlipMayHaveMeant) {
  const TemporaryFolder folder;
  for (const char* name : {"sdof-stop", "sdof-stop-e0", "chain2", "zebra"}) {
    static_cast<void>(folder.write("catalogue/" + std::string(name) + ".toml", kOscillator));
  }
  const CatalogueAt catalogue(folder.path());
  const auto refusal = [](const std::string& name) { return scene_error([&] { find_scene(name); }); };

  EXPECT_EQ(refusal("sdof-stp"),
            "scene = sdof-stp (must be a catalogue scene or a TOML file; did you mean sdof-stop?)");
  EXPECT_EQ(refusal("sdof-stop-e"),
            "scene = sdof-stop-e (must be a catalogue scene or a TOML file; did you mean sdof-stop-e0, "
            "sdof-stop?)");
  EXPECT_EQ(refusal("elsewhere/chain2.toml"),
            "scene = elsewhere/chain2.toml (must exist: there is no such file; did you mean chain2?)");
  EXPECT_EQ(refusal("rotor"), "scene = rotor (must be a catalogue scene or a TOML file)");
  EXPECT_EQ(refusal(""), "scene =  (must be a catalogue scene or a TOML file)");
  EXPECT_EQ(refusal("../catalogue"), "scene = ../catalogue (must exist: there is no such file)");
}

TEST(CatalogueScenes, AreTheTomlFilesInOrderOfName) {
  const TemporaryFolder folder;
  for (const char* name : {"b.toml", "a-2.toml", "a.toml", "notes.md"}) {
    static_cast<void>(folder.write("catalogue/" + std::string(name), ""));
  }
  const CatalogueAt catalogue(folder.path());

  std::vector<std::string> names;
  for (const fs::path& path : shipped_files("catalogue")) names.push_back(path.stem().string());
  EXPECT_EQ(names, (std::vector<std::string>{"a", "a-2", "b"}));
}

TEST(ProblemsFolder, MustExistWhereTheEnvironmentNamesIt) {
  const CatalogueAt catalogue("/nowhere/at/all");
  EXPECT_EQ(scene_error([] { problems_folder(); }),
            "SIGNORINI_PROBLEMS = /nowhere/at/all (must be a folder with a folder catalogue)");
}

}  // namespace
}  // namespace signorini::test::scene_catalogue_test
