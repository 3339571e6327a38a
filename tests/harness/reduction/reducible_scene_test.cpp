#include "harness/reduction/reducible_scene.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "problems/files/toml_tree.hpp"

namespace signorini::reducible_scene_test {
namespace {

using Ratios = std::vector<double>;

/// A scene of this system, a file in the folder of the tests.
SceneSource scene_of(const std::string& system) {
  const auto file = std::filesystem::path(testing::TempDir()) / "reducible-scene.toml";
  std::ofstream(file) << "schema = 1\nname = \"reducible-scene\"\n[system]\n"
                      << system << "\n[forcing]\nfrequency = 1.0\n[[forcing.term]]\ndof = 0\ncos = 0.1\n"
                      << "[[contact]]\ndof = 1\ngap = 0.1\n[law]\npenalty = 1.0\n";
  return file;
}

SceneSource bar(int elements, const std::string& damping) {
  return scene_of("kind = \"bar\"\nelements = " + std::to_string(elements) +
                  "\nlength = 1.0\narea = 1.0\nyoung = 1.0\ndensity = 1.0\ndamping = { " + damping + " }");
}

// More coordinates than a full damping matrix would be made for.
TEST(ReadReducible, KeepsDampingRatiosAside) {
  const ReducibleScene scene = read_reducible(bar(3000, "modal = [0.01, 0.05]"));
  EXPECT_EQ(scene.ratios, Ratios({0.01, 0.05}));
  EXPECT_EQ(scene.problem.damping().norm(), 0.0);
  EXPECT_EQ((scene.problem.stiffness() - load_scene(bar(3000, "alpha = 0")).stiffness()).norm(), 0.0);
  EXPECT_EQ(read_reducible(bar(10, "modal = 0.02")).ratios, Ratios({0.02}));
}

TEST(ReadReducible, KeepsThoseOfMatricesAside) {
  const auto file = std::filesystem::path(testing::TempDir()) / "reducible-scene.mtx";
  std::ofstream(file) << "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 2.0\n2 2 3.0\n";
  const std::string matrices =
      "kind = \"matrices\"\nmass = \"reducible-scene.mtx\"\nstiffness = \"reducible-scene.mtx\"\n";
  const ReducibleScene scene = read_reducible(scene_of(matrices + "modal = 0.03"));
  EXPECT_EQ(scene.ratios, Ratios({0.03}));
  EXPECT_EQ(scene.problem.damping().norm(), 0.0);
  EXPECT_THROW(read_reducible(scene_of(matrices + "modal = 0.03\nrayleigh = { alpha = 1.0 }")), SceneError);
}

TEST(ReadReducible, ReadsOtherDampingAsItIs) {
  const ReducibleScene scene = read_reducible(bar(10, "alpha = 0.1, beta = 0.2"));
  EXPECT_TRUE(scene.ratios.empty());
  EXPECT_EQ((scene.problem.damping() - load_scene(bar(10, "alpha = 0.1, beta = 0.2")).damping()).norm(), 0.0);
  EXPECT_TRUE(read_reducible(bar(10, "modal = 0")).ratios.empty());
}

TEST(ReadReducible, RefusesWhatIsNoDampingByRatios) {
  const auto refusal = [](const SceneSource& source) -> std::string {
    try {
      (void)read_reducible(source);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_NE(refusal(bar(10, "modal = 0.01, alpha = 0.1")).find("alpha or beta is given"), std::string::npos);
  EXPECT_NE(refusal(bar(10, "modal = [0.01, -0.01]")).find("system.damping.modal[1] = -0.01"),
            std::string::npos);
  const SceneSource shaft = scene_of(
      "kind = \"shaft\"\nelements = 3\nlength = 1.0\narea = 1.0\ninertia = 1.0\nyoung = 1.0\ndensity = 1.0\n"
      "disc_mass = 2.0\ndisc_node = 1\ndisc_inertia = 0.1\nbearing_stiffness = 200.0\nbearing_damping = 2.0\n"
      "damping = { modal = 0.01 }");
  EXPECT_NE(refusal(shaft).find("must be absent beside dampers"), std::string::npos) << refusal(shaft);
}

}  // namespace
}  // namespace signorini::reducible_scene_test
