#include <gtest/gtest.h>

#include "harness/extend/plugins/command_method.hpp"
#include "harness/extend/plugins/curve_exchange.hpp"
#include "harness/plan/scene_choice.hpp"
#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::branch_file_test {
namespace {

constexpr const char* kDescription =
    "schema = 1\nname = \"mine\"\ntitle = \"Branches of my program\"\nladder = \"\"\nbranches = "
    "\"mine.jsonl\"\n"
    "[represents]\nrestitution = \"scene\"\n";
constexpr const char* kBranch =
    R"({"scene": "sdof-stop", "sequence": "mine", "points": [{"omega": 2.0, "coefficients": [[0.0, 1.0, 0.0]]},)"
    R"( {"omega": 2.5, "coefficients": [[0.0, 2.0, 0.0]]}]})"
    "\n";

class BranchFile : public testing::Test {
 protected:
  MethodEntry loaded(const std::string& branches) {
    static_cast<void>(folder_.write("mine.jsonl", branches));
    return load_command_method(folder_.write("mine.toml", kDescription));
  }
  std::string complaint(const std::string& branches) {
    try {
      static_cast<void>(loaded(branches));
    } catch (const SceneError& error) {
      const std::string what = error.what();
      return what.substr(what.find("mine."));
    }
    return "accepted";
  }

  test::TemporaryFolder folder_;
};

TEST_F(BranchFile, IsAMethodOfCurvesAlone) {
  const std::unique_ptr<Method> method = loaded(std::string("\n") + kBranch).make({});
  const Problem problem = read_scene(find_scene("sdof-stop")).problem;
  EXPECT_FALSE(method->supports(problem).ok);
  ASSERT_NE(method->curve(), nullptr);
  const ParametrisedScene scene = over_frequency(problem, 1.5, 3.0);
  ASSERT_TRUE(method->curve()->follows(scene).ok);
  const BranchDiagram diagram = method->curve()->follow(scene, {});
  ASSERT_EQ(diagram.branches.size(), 1U);
  EXPECT_NEAR(diagram.branches[0].points.at(1).amplitude.at(0), 2.0, 1e-12);
}

TEST_F(BranchFile, DoesNotFollowWhatItDoesNotHold) {
  const std::unique_ptr<Method> method = loaded(kBranch).make({});
  const auto reason = [&](const char* scene) {
    return method->curve()->follows(over_frequency(read_scene(find_scene(scene)).problem, 1.5, 3.0)).reason;
  };
  EXPECT_EQ(reason("sdof-stop-e08"), "its file has no branch of sdof-stop-e08");
  EXPECT_EQ(reason("sdof-penalty-soft"), "its description names no law for this scene's");
}

TEST_F(BranchFile, SaysWhereItIsWrong) {
  EXPECT_EQ(complaint(std::string(kBranch) + "{\"points\": []}\n"),
            "mine.jsonl:2: scene = missing (must be the name of the scene)");
  EXPECT_EQ(complaint("{\"scene\": \"sdof-stop\"}\n"), "mine.jsonl:1: key 'points' not found");
  EXPECT_NE(complaint("no JSON\n").find("mine.jsonl:1: "), std::string::npos);
  const auto both = folder_.write(
      "both.toml",
      std::string("schema = 1\nname = \"both\"\ntitle = \"b\"\nladder = \"\"\nbranches = \"mine.jsonl\"\n") +
          "command = [\"sh\"]\n[represents]\nrestitution = 1.0\n");
  EXPECT_THROW(static_cast<void>(load_command_method(both)), SceneError);
}

TEST_F(BranchFile, ThatIsNoneOfItsSceneIsToldAsUnfinished) {
  const std::unique_ptr<Method> method =
      loaded(R"({"scene": "sdof-stop", "points": [{"omega": 2.0, "x": [[1.0, 0.0], [1.0, 0.0]]}]})").make({});
  const Problem problem = read_scene(find_scene("sdof-stop")).problem;
  EXPECT_EQ(method->curve()->follow(over_frequency(problem, 1.5, 3.0), {}).unfinished,
            "its file of branches: x = 2 lists (must be one for each of 1 contacts)");
}

}  // namespace
}  // namespace signorini::branch_file_test
