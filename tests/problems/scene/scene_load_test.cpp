#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "problems/files/toml_tree.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/problems/scene/moving_scenes.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::scene_load_test {
namespace {

using test::oscillator_with;
using test::refusal_of;

Problem loaded(const std::string& terms) { return parse_scene(oscillator_with(terms), "scene.toml"); }

TEST(ReadLoad, TakesAFrequencyThatIsAHarmonic) {
  const Problem problem = loaded("[[forcing.term]]\ndof = 0\nfrequency = 6.0\ncos = 1\n");
  ASSERT_EQ(problem.force.size(), 1U);
  EXPECT_EQ(problem.force[0].harmonic, 3) << "of 2 rad/s";
}

TEST(ReadLoad, SaysHowToWriteTwoFrequenciesWithACommonPeriod) {
  EXPECT_EQ(refusal_of("[[forcing.term]]\ndof = 0\nfrequency = 3.0\ncos = 1\n"),
            "scene.toml:12: forcing.term[0].frequency = 3 (is 3/2 of forcing.frequency: write "
            "forcing.frequency = 1, "
            "and of what was a harmonic h harmonic = 2 h, here harmonic = 3)");
}

TEST(ReadLoad, RefusesTwoFrequenciesWithoutACommonPeriod) {
  EXPECT_EQ(
      refusal_of("[[forcing.term]]\ndof = 0\nfrequency = 2.8284271247461903\ncos = 1\n"),
      "scene.toml:12: forcing.term[0].frequency = 2.8284271247461903 (must be p/q of forcing.frequency, q <= "
      "64: a load of two frequencies without a common period has no periodic motion)");
  EXPECT_EQ(refusal_of("[[forcing.term]]\ndof = 0\nfrequency = 4\nharmonic = 2\ncos = 1\n"),
            "scene.toml:13: forcing.term[0].harmonic = 2 (must be absent: frequency is given)");
}

TEST(ReadLoad, TurnsSamplesIntoHarmonics) {
  // 1 + 2 cos(a) at five instants.
  std::string samples;
  for (int i = 0; i < 5; ++i)
    samples += std::to_string(1.0 + 2.0 * std::cos(2.0 * std::acos(-1.0) * i / 5.0)) + ", ";
  const SceneWithSources scene = parse_scene_with_sources(
      oscillator_with("[[forcing.term]]\ndof = 0\nsamples = [" + samples + "]\n"), "scene.toml");
  ASSERT_EQ(scene.sampled_loads.size(), 1U);
  EXPECT_EQ(scene.sampled_loads[0].field, "forcing.term[0]");
  EXPECT_NEAR(load_harmonic(scene.problem, 0)[0].real(), 1.0, 1e-6) << "six digits were written";
  EXPECT_NEAR(std::abs(load_harmonic(scene.problem, 1)[0] - 2.0), 0.0, 1e-6);
}

TEST(ReadLoad, ReadsSamplesFromAFileBesideTheScene) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "f.csv") << "t,f\n0,0\n0.785398163,1\n1.570796327,0\n2.356194490,-1\n";
  std::ofstream(folder.path() / "own.toml")
      << oscillator_with("[[forcing.term]]\ndof = 0\nfile = \"f.csv\"\n");
  const Problem problem = load_scene(folder.path() / "own.toml");
  EXPECT_NEAR(std::abs(load_harmonic(problem, 1)[0] - std::complex<double>(0.0, -1.0)), 0.0, 1e-14);
}

TEST(ReadLoad, RefusesSamplesThatAreTooFewOrNoNumbers) {
  EXPECT_EQ(refusal_of("[[forcing.term]]\ndof = 0\nsamples = [1, 2]\n"),
            "scene.toml:12: forcing.term[0].samples = 2 samples (must be 3..20001)");
  EXPECT_EQ(refusal_of("[[forcing.term]]\ndof = 0\nsamples = [1, nan, 2]\n"),
            "scene.toml:12: forcing.term[0].samples[1] = nan (must be a finite number [N])");
  EXPECT_EQ(
      refusal_of("[[forcing.term]]\ndof = 0\nsamples = [1, 2, 3, 4]\nharmonics = 2\n"),
      "scene.toml:13: forcing.term[0].harmonics = 2 (must be a whole number, 0..1: 4 samples determine no "
      "more)");
  EXPECT_EQ(refusal_of("[[forcing.term]]\ndof = 0\nsamples = [1, 2, 3]\ncos = 2\n"),
            "scene.toml:13: forcing.term[0].cos = 2 (must be absent: the load is given by samples)");
  EXPECT_NE(refusal_of("[[forcing.term]]\ndof = 0\nfile = \"gone.csv\"\n").find("it is missing"),
            std::string::npos);
}

TEST(ReadLoad, GrowsWithAPowerOfTheFrequency) {
  Problem problem = loaded("[[forcing.term]]\ndof = 0\ncos = 0.5\nomega_power = 2\n");
  EXPECT_TRUE(load_grows(problem));
  EXPECT_EQ(load_harmonic(problem, 1)[0], 2.0) << "0.5 kg m at 2 rad/s";
  problem.frequency = 4.0;
  EXPECT_EQ(load_harmonic(problem, 1)[0], 8.0);
  EXPECT_EQ(load_harmonic_rate(problem, 1)[0], 4.0);
  EXPECT_EQ(refusal_of("[[forcing.term]]\ndof = 0\ncos = 0.5\nomega_power = 3\n"),
            "scene.toml:13: forcing.term[0].omega_power = 3 (must be 0, 1 or 2)");
}

TEST(ReadUnbalance, IsAForceThatTurns) {
  const Problem problem = parse_scene(R"(schema = 1
name = "disc"
[system]
kind = "rotor"
mass = 1.0
damping = 0.1
stiffness = 1.0
[forcing]
frequency = 3.0
[[forcing.unbalance]]
dofs = [0, 1]
moment = 0.2
phase = 0.5
)",
                                      "scene.toml");
  for (const double time : {0.0, 0.4}) {
    const double angle = 3.0 * time + 0.5;
    EXPECT_LT((load_at(problem, time) - 1.8 * Eigen::Vector2d(std::cos(angle), std::sin(angle))).norm(),
              1e-14);
  }
}

}  // namespace
}  // namespace signorini::scene_load_test
