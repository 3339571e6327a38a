// Scenes by name, file, folder and glob, mixed.

#include "harness/plan/scene_choice.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "harness/failure.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::scene_choice_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

fs::path write_oscillator(const fs::path& file, const std::string& name) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "schema = 1\nname = \"" << name
                      << "\"\ntitle = \"t\"\n[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.1\nstiffness "
                         "= 1.0\n[forcing]\nfrequency = 2.0\n[[forcing.term]]\ndof = 0\ncos = 1.0\n"
                         "[[contact]]\ndof = 0\ngap = 10.0\n[law]\nrestitution = 1.0\n";
  return file;
}

class ChooseScenes : public testing::Test {
 protected:
  fs::path folder_ = test::fresh_folder("scene-choice");
  std::vector<SceneSource> shipped_{write_oscillator(folder_ / "shipped" / "alpha.toml", "alpha"),
                                    write_oscillator(folder_ / "shipped" / "beta.toml", "beta")};
  fs::path one_ = write_oscillator(folder_ / "own" / "one.toml", "one");
  fs::path two_ = write_oscillator(folder_ / "own" / "two-b.toml", "two");
  Suite suite_{.name = "s", .scenes = {"*"}};

  [[nodiscard]] Names names(const Names& words) const {
    Names found;
    for (const Scene& scene : choose_scenes(suite_, words, shipped_)) found.push_back(scene.problem.name);
    return found;
  }
  template <class Error>
  [[nodiscard]] std::string refusal(const Names& words) const {
    try {
      static_cast<void>(names(words));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ChooseScenes, AreAllOfTheSuiteWhereNothingIsAskedFor) {
  EXPECT_EQ(names({}), (Names{"alpha", "beta"}));
}

TEST_F(ChooseScenes, DrawsInstancesOfFilesWithRanges) {
  std::ofstream(one_, std::ios::app) << "[[range]]\nplaces = [\"contact[0].gap\"]\nfrom = 0.1\nto = 0.4\n";
  const auto drawn = [&](const Instances& instances) {
    return choose_scenes(suite_, {one_.string() + ":beta"}, shipped_, instances);
  };
  const std::vector<Scene> scenes = drawn({.count = 2, .seed = 7});
  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_EQ(scenes[0].problem.name, "one@7-1");
  EXPECT_EQ(scenes[1].problem.name, "one@7-2");
  EXPECT_EQ(scenes[1].word, one_.string() + "@7-2");
  EXPECT_EQ(scenes[2].problem.name, "beta");
  EXPECT_NE(scenes[0].sha256, scenes[1].sha256);
  EXPECT_NE(scenes[0].problem.contacts[0].gap, scenes[1].problem.contacts[0].gap);
  EXPECT_EQ(digest_of({one_, "7-2"}), scenes[1].sha256);
  EXPECT_EQ(drawn({}).front().problem.name, "one") << "as it is written";
  suite_.files = {one_.string()};
  suite_.instances = 5;
  EXPECT_EQ(count_scenes(suite_, shipped_), 7U);
}

TEST_F(ChooseScenes, MixesOwnFilesWithNames) {
  EXPECT_EQ(names({one_.string() + ":beta"}), (Names{"one", "beta"}));
  EXPECT_EQ(names({"beta:" + one_.string(), two_.string()}), (Names{"one", "two", "beta"}));
  EXPECT_EQ(names({one_.string()}), (Names{"one"})) << "nothing of the suite";
}

TEST_F(ChooseScenes, TakesOfOtherScenesWhatNoSceneOfTheSuiteMatches) {
  suite_.scenes = {"alpha"};
  EXPECT_EQ(names({}), (Names{"alpha"}));
  EXPECT_EQ(names({"beta"}), (Names{"beta"}));
  EXPECT_EQ(names({"beta:alpha"}), (Names{"alpha", "beta"}));
  EXPECT_EQ(names({"*a"}), (Names{"alpha"})) << "the suite has a match of its own";
  EXPECT_EQ(count_scenes(suite_, shipped_), 1U);
}

TEST_F(ChooseScenes, TakesFoldersAndGlobsOfFilesEachFileOnce) {
  EXPECT_EQ(names({(folder_ / "own").string()}), (Names{"one", "two"}));
  EXPECT_EQ(names({(folder_ / "own").string() + "/:" + one_.string()}), (Names{"one", "two"}));
  EXPECT_EQ(names({(folder_ / "own" / "*-b.toml").string()}), (Names{"two"}));
}

TEST_F(ChooseScenes, LeavesOutByNameWhateverAskedForIt) {
  EXPECT_EQ(names({"*-al*"}), (Names{"beta"}));
  EXPECT_EQ(names({(folder_ / "own").string() + ":-tw*"}), (Names{"one"}));
  EXPECT_EQ(names({(folder_ / "own").string() + ":*-tw*:al*"}), (Names{"one", "beta"}));
}

TEST_F(ChooseScenes, CallsOwnScenesByTheirFile) {
  const std::vector<Scene> scenes = choose_scenes(suite_, {one_.string() + ":beta"}, shipped_);
  EXPECT_EQ(scenes[0].word, one_.string());
  EXPECT_EQ(scenes[1].word, "beta");
}

TEST_F(ChooseScenes, TakesFilesThatASuiteNames) {
  suite_.files = {(folder_ / "own").string()};
  suite_.scenes = {"al*"};
  EXPECT_EQ(names({}), (Names{"one", "two", "alpha"}));
  EXPECT_EQ(names({"t*"}), (Names{"two"}));
  EXPECT_EQ(choose_scenes(suite_, {"two"}, shipped_).front().word, two_.string());
}

TEST_F(ChooseScenes, RefusesWhatMatchesNothingAndSaysWhatIsNear) {
  EXPECT_EQ(refusal<NothingMatched>({"alpha:bta"}),
            "scenes = bta (matches no scene of suite s and none that ships; did you mean beta?; see "
            "`signorini list scenes`)");
  EXPECT_EQ(refusal<NothingMatched>({(folder_ / "own" / "x*.toml").string()}),
            "scenes = " + (folder_ / "own" / "x*.toml").string() + " (matches no file)");
  fs::create_directories(folder_ / "empty");
  EXPECT_NE(refusal<NothingMatched>({(folder_ / "empty").string()}).find("there is none"), std::string::npos);
  EXPECT_NE(refusal<NothingMatched>({"*-*"}).find("leaves no scene"), std::string::npos);
  EXPECT_NE(refusal<std::runtime_error>({(folder_ / "no.toml").string()}).find("there is no such file"),
            std::string::npos);
}

TEST_F(ChooseScenes, RefusesTwoScenesOfOneName) {
  const fs::path twin = write_oscillator(folder_ / "twin.toml", "beta");
  const std::string text = refusal<UsageError>({twin.string() + ":beta"});
  EXPECT_EQ(text, "scenes = beta (must have another name than " + twin.string() + ": both are named beta)");
}

TEST(NamesPath, IsToldFromANameByASlashTomlOrAFolder) {
  EXPECT_TRUE(names_path("own.toml"));
  EXPECT_TRUE(names_path("own.toml@1e-4"));
  EXPECT_TRUE(names_path("folder/"));
  EXPECT_TRUE(names_path("."));
  EXPECT_FALSE(names_path("sdof-stop"));
  EXPECT_FALSE(names_path("grazing@*"));
}

TEST(SceneFiles, OfAFamilyAreItsLevelsUnlessOneIsGiven) {
  const std::string family = (problems_folder() / "families" / "grazing.toml").string();
  const std::vector<SceneSource> all = scene_files(family), one = scene_files(family + "@0.1");
  EXPECT_EQ(all.size(), load_levels(family).size());
  EXPECT_GT(all.size(), 1U);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one.front().level, "0.1");
}

}  // namespace
}  // namespace signorini::scene_choice_test
