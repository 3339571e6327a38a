#include <gtest/gtest.h>

#include <cmath>

#include "tests/problems/scene/moving_scenes.hpp"

namespace signorini::scene_motion_test {
namespace {

using test::oscillator_with;
using test::refusal_of;

constexpr const char* kStop = "[[contact]]\ndof = 0\ngap = 0.1\n";
constexpr const char* kLaw = "[law]\nrestitution = 0.5\n";

TEST(ReadStopMotion, IsThatOfEachContactOfItsTable) {
  const Problem problem = parse_scene(
      oscillator_with(std::string(kStop) +
                      "gap_term = [{ cos = 0.02 }, { harmonic = 3, cos = -0.01, sin = 0.005 }]\n" + kLaw),
      "scene.toml");
  const Eigen::VectorXcd motion = stop_motion(problem, 0);
  ASSERT_EQ(motion.size(), 4);
  EXPECT_EQ(motion[1], 0.02);
  EXPECT_EQ(motion[3], std::complex<double>(-0.01, -0.005));
  EXPECT_EQ(problem.contacts[0].gap, 0.1);
}

TEST(ReadStopMotion, MovesARingByItsCentre) {
  const Problem problem = parse_scene(R"(schema = 1
name = "disc"
[system]
kind = "rotor"
mass = 1.0
damping = 0.1
stiffness = 1.0
[forcing]
frequency = 3.0
[[contact]]
dofs = [0, 1]
facets = 8
gap = 0.1
centre_term = [{ harmonic = 2, cos = [0.01, 0.0], sin = [0.0, -0.02] }]
[law]
penalty = 10.0
)",
                                      "scene.toml");
  for (int j = 0; j < 8; ++j) {
    const double angle = std::acos(-1.0) * j / 4.0;
    const std::complex<double> expected(0.01 * std::cos(angle), 0.02 * std::sin(angle));
    EXPECT_LT(std::abs(stop_motion(problem, j)[2] - expected), 1e-16) << j;
  }
}

TEST(ReadStopMotion, RefusesWhatIsNoMotion) {
  const auto refused = [](const std::string& term) { return refusal_of(kStop + term + "\n" + kLaw); };
  EXPECT_EQ(refused("gap_term = [{ harmonic = 0, cos = 0.1 }]"),
            "scene.toml:13: contact[0].gap_term[0].harmonic = 0 (must be a whole number, 1..10000)");
  EXPECT_EQ(refused("gap_term = 0.1"),
            "scene.toml:13: contact[0].gap_term = 0.1 (must be a list of tables { harmonic = .., cos = .., "
            "sin = .. "
            "}, the motion of the stop [m])");
  EXPECT_EQ(refused("gap_term = [{ cos = inf }]"),
            "scene.toml:13: contact[0].gap_term[0].cos = inf (must be a finite number)");
  EXPECT_EQ(refused("centre_term = [{ cos = [1, 0] }]").substr(0, 60),
            std::string("scene.toml:13: contact[0].centre_term = [{cos = [1, 0]}] (must").substr(0, 60));
  EXPECT_NE(refused("gap_term = [{ cos = 1e70 }]").find("scene.toml:10: contact"), std::string::npos);
}

TEST(ReadStopMotion, RefusesStopsThatApproachEachOther) {
  EXPECT_EQ(
      refusal_of("[[contact]]\ndof = 0\ngap = 0.1\ngap_term = [{ cos = 0.02 }]\n[[contact]]\nnormal = [[0, "
                 "-1.0]]\ngap = 0.1\ngap_term = [{ cos = 0.02 }]\n[law]\nrestitution = 1\n"),
      "scene.toml:13: contact[0].gap_term = a motion of its own (stops on the same coordinates must move as "
      "one body: none may approach another)");
}

TEST(ReadBase, IsTheInertiaOfAllMassesUnlessToldOtherwise) {
  const Problem problem = parse_scene(
      oscillator_with("[base]\ndisplacement = [{ cos = 0.3 }]\nacceleration = [{ harmonic = 0, cos = "
                      "9.81 }, { harmonic = 2, sin = 1.0 }]\n"),
      "scene.toml");
  const double time = 0.3;
  const double acceleration = -4.0 * 0.3 * std::cos(2.0 * time) + 9.81 + std::sin(4.0 * time);
  EXPECT_NEAR(load_at(problem, time)[0], -2.0 * acceleration, 1e-13);
}

TEST(ReadBase, RefusesWhatIsNoMotionOfABase) {
  EXPECT_EQ(refusal_of("[base]\n"), "scene.toml:10: base = {} (must hold displacement or acceleration)");
  EXPECT_EQ(refusal_of("[base]\ndirection = [[1, 1.0]]\ndisplacement = [{ cos = 0.3 }]\n"),
            "scene.toml:11: base.direction[0][0] = 1 (must be a coordinate of the system, 0..0)");
  EXPECT_EQ(
      refusal_of("[base]\nacceleration = [{ harmonic = 0, sin = 0.3 }]\n"),
      "scene.toml:11: base.acceleration[0].sin = 0.3 (must be 0 or absent: at harmonic 0 a sine is nothing)");
}

}  // namespace
}  // namespace signorini::scene_motion_test
