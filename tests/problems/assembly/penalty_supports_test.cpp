#include "problems/assembly/penalty_supports.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::penalty_supports_test {
namespace {

/// Three masses in a row behind the first spring, with other lines of the system.
Problem row(const std::string& lines) {
  return parse_scene(
      "schema = 1\nname = \"row\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 1.0, 1.0]\n"
      "dampers = [0.1, 0.1, 0.1]\n" +
          lines +
          "[forcing]\nfrequency = 0.9\nterm = [{ dof = 0, cos = 1.0 }, { dof = 2, cos = 1.0 }]\n"
          "[[contact]]\ndof = 2\ngap = 0.5\n[law]\nrestitution = 0.8\n",
      "row.toml");
}

TEST(PenaltySupports, OfAChainHoldTheirMassAtRest) {
  Eigen::Matrix3d K, M;
  K << 2, 0, 0, 0, 2, -1, 0, -1, 1;
  M << 0, 0, 0, 0, 1, 0, 0, 0, 1;
  for (const char* lines :
       {"springs = [1.0, 1.0, 1.0]\nground_springs = [1e20, 0.0, 0.0]\n", "springs = [1e16, 1.0, 1.0]\n"}) {
    const Problem held = row(lines);
    EXPECT_EQ(Eigen::Matrix3d(held.mass()), M) << lines;
    Eigen::Matrix3d rest = Eigen::Matrix3d(held.stiffness());
    EXPECT_GT(rest(0, 0), 0.0);
    rest(0, 0) = K(0, 0);
    EXPECT_EQ(rest, K) << lines;
    EXPECT_EQ(Eigen::Matrix3d(held.damping()).row(0).norm(), 0.0);
    ASSERT_EQ(held.force.size(), 2U);
    EXPECT_EQ(held.force[0].cos, 0.0) << "a load on it moves nothing";
    EXPECT_EQ(held.force[1].cos, 1.0);
  }
}

TEST(PenaltySupports, OfAShaftAreItsBearings) {
  const auto shaft = [](const std::string& bearing) {
    return parse_scene(
        "schema = 1\nname = \"shaft\"\n[system]\nkind = \"shaft\"\nelements = 4\nlength = 1.0\narea = 1e-3\n"
        "inertia = 1e-7\nyoung = 2e11\ndensity = 7800.0\ndisc_mass = 5.0\ndisc_node = 2\nbearing_stiffness "
        "= " +
            bearing +
            "\nbearing_damping = 10.0\ndamping = { modal = 0.02 }\n[forcing]\nfrequency = 100.0\n"
            "term = [{ dof = 8, cos = 1.0 }]\n",
        "shaft.toml");
  };
  const auto middle = [](const Problem& problem) {
    const double w = problem.base_frequency();
    const Eigen::MatrixXcd Z = Eigen::MatrixXd(problem.stiffness() - w * w * problem.mass()) +
                               std::complex<double>(0.0, w) * Eigen::MatrixXd(problem.damping());
    return CompleteComplexLuFactors(Z).inverse()(8, 8);
  };
  // Bearings so stiff that they hold the ends, yet far from rounding, are the same but for their own modes.
  const std::complex<double> stiff = middle(shaft("1e13")), held = middle(shaft("1e30"));
  EXPECT_LT(std::abs(held - stiff), 1e-3 * std::abs(stiff));
}

TEST(PenaltySupports, LinksBetweenCoordinatesAreNamedAndNotHeld) {
  const Problem linked = row("springs = [1.0, 1.0, 1.0]\nlinks = [[0, 1, 1e20, 0.0]]\n");
  EXPECT_EQ(Eigen::Matrix3d(linked.mass()), Eigen::Matrix3d::Identity());
  const std::vector<PenaltySpring> springs = penalty_springs(linked.stiffness());
  ASSERT_EQ(springs.size(), 2U);
  EXPECT_EQ(springs[0].coordinate, 0);
  EXPECT_EQ(springs[0].tied_to, 1);
  EXPECT_TRUE(penalty_explanation(linked.stiffness())
                  .starts_with("stiffness between coordinates 0 and 1 is 1e+20 N/m, "))
      << penalty_explanation(linked.stiffness());
}

/// A row whose first mass is held, with these tables of contacts.
std::string held_row(const std::string& contacts) {
  return "schema = 1\nname = \"row\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 1.0, 1.0]\n"
         "dampers = [0.1, 0.1, 0.1]\nsprings = [1e20, 1.0, 1.0]\n[forcing]\nfrequency = 0.9\n"
         "term = [{ dof = 2, cos = 1.0 }]\n" +
         contacts;
}

TEST(PenaltySupports, AreStopsForWhatMovesAlone) {
  const Problem beside =
      parse_scene(held_row("[[contact]]\nbetween = [2, 0]\ngap = 0.5\nrestitution = 0.8\n"
                           "[[contact]]\nbetween = [0, 1]\ngap = 0.4\npenalty = 20.0\ndamper = 0.5\n"),
                  "row.toml");
  ASSERT_EQ(beside.contact_count(), 2);
  EXPECT_EQ(beside.contacts[0].normal, (std::vector<std::pair<int, double>>{{2, 1.0}}));
  EXPECT_EQ(Eigen::MatrixXd(beside.stiffness())(0, 3), 0.0) << "the face feels coordinate 1 alone";
  EXPECT_EQ(Eigen::MatrixXd(beside.stiffness())(1, 3), 20.0);
  try {
    parse_scene(held_row("[[contact]]\ndof = 0\ngap = 0.5\nrestitution = 0.8\n"), "row.toml");
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(
        error.what(),
        "row.toml:11: contact[0] = on coordinate 0 (must act on coordinates that move: the stiffness of "
        "this one is a support by penalty, which holds it at rest)");
  }
}

// A consistent mass matrix: the ends that are held would pull their neighbours along with the base.
TEST(PenaltySupports, AreRefusedOnABaseThatPullsThroughTheMassMatrix) {
  const auto on_a_base = [](const char* stiffness) {
    return parse_scene(
        std::string(
            "schema = 1\nname = \"shaft\"\n[system]\nkind = \"shaft\"\nelements = 2\nlength = 1.0\n"
            "area = 1e-3\ninertia = 1e-7\nyoung = 2e11\ndensity = 7800.0\ndisc_mass = 5.0\ndisc_node = "
            "1\nbearing_damping = 10.0\ndamping = { modal = 0.02 }\nbearing_stiffness = ") +
            stiffness +
            "\n[forcing]\nfrequency = 100.0\n[base]\nacceleration = [{ cos = 1.0 }]\n"
            "direction = [[0, 1.0], [4, 1.0], [8, 1.0]]\n",
        "shaft.toml");
  };
  EXPECT_NO_THROW(on_a_base("1e7"));
  EXPECT_THROW(on_a_base("1e30"), SceneError);
  EXPECT_NO_THROW(parse_scene(held_row("[base]\nacceleration = [{ cos = 1.0 }]\n"), "row.toml"));
}

TEST(PenaltySupports, AreNoneOfSpringsWithinTwelveOrders) {
  EXPECT_TRUE(penalty_springs(row("springs = [1e11, 1.0, 1.0]\n").stiffness()).empty());
  EXPECT_EQ(penalty_explanation(row("springs = [1e11, 1.0, 1.0]\n").stiffness()), "");
}

}  // namespace
}  // namespace signorini::penalty_supports_test
