#include "problems/damped_stops.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "problems/scene/scene_file.hpp"
#include "problems/validation.hpp"
#include "tests/problems/chain_problems.hpp"
#include "tests/problems/scene/moving_scenes.hpp"

namespace signorini::damped_stops_test {
namespace {

using test::oscillator_with;
using test::refusal_of;

Problem three_masses_between_stops() {
  Problem problem = test::three_masses();
  problem.contacts = {{.normal = {{2, 1.0}}, .gap = 0.3}, {.normal = {{0, 1.0}, {1, -2.0}}, .gap = 0.1}};
  return problem;
}

// Balance of forces at any state, element by element.
TEST(DampStops, JoinEachFaceToWhatItStops) {
  const Problem bare = three_masses_between_stops();
  Problem problem = bare;
  const std::vector<DampedStop> stops{
      {.contact = 0, .normal = bare.contacts[0].normal, .stiffness = 50.0, .damping = 2.0},
      {.contact = 1, .normal = bare.contacts[1].normal, .stiffness = 70.0, .damping = 3.0}};
  damp_stops(problem, stops);
  EXPECT_TRUE(std::holds_alternative<Massless>(problem.law()));
  EXPECT_NO_THROW(validate(problem));
  ASSERT_EQ(problem.size(), 5);
  Eigen::VectorXd u(5), v(5);
  u << 0.3, -0.2, 0.5, 0.45, 0.6;
  v << 1.0, 0.4, -0.7, 0.2, 0.1;
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(5);
  expected.head(3) = bare.stiffness() * u.head(3) + bare.damping() * v.head(3);
  const Eigen::MatrixXd W = contact_directions(bare);
  for (int j = 0; j < 2; ++j) {
    const double k = j == 0 ? 50.0 : 70.0, c = j == 0 ? 2.0 : 3.0;
    const double push = k * (W.col(j).dot(u.head(3)) - u[3 + j]) + c * (W.col(j).dot(v.head(3)) - v[3 + j]);
    expected.head(3) += push * W.col(j);
    expected[3 + j] -= push;
  }
  const Eigen::VectorXd found = problem.stiffness() * u + problem.damping() * v;
  EXPECT_LT((found - expected).norm(), 1e-14 * expected.norm());
  const Eigen::MatrixXd mass(problem.mass());
  EXPECT_EQ(mass.topLeftCorner(3, 3), Eigen::MatrixXd(bare.mass()));
  EXPECT_EQ(mass.bottomRows(2).norm() + mass.rightCols(2).norm(), 0.0);
  EXPECT_EQ(problem.contacts[1].normal, (std::vector<std::pair<int, double>>{{4, 1.0}}));
  EXPECT_EQ(problem.contacts[1].gap, 0.1);
  EXPECT_EQ(contacts_of_structure(problem.contacts, stops)[1].normal, bare.contacts[1].normal);
  EXPECT_EQ(contacts_of_structure(bare.contacts, {})[0].normal, bare.contacts[0].normal);
}

TEST(DampStops, RefuseWhatValidateWouldNotSeeAfterwards) {
  const auto refusal = [](double stiffness, double damping, int contact,
                          const std::vector<std::pair<int, double>>& normal = {{2, 1.0}}) -> std::string {
    Problem problem = three_masses_between_stops();
    try {
      damp_stops(problem,
                 {{.contact = contact, .normal = normal, .stiffness = stiffness, .damping = damping}});
      return "";
    } catch (const InvalidProblem& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal(1.0, 0.0, 1), "contact[1].damper = 0 (must be a positive number [N s/m])");
  EXPECT_EQ(refusal(-2.0, 1.0, 1), "contact[1].penalty = -2 (must be a positive number [N/m])");
  EXPECT_EQ(refusal(1.0, 1.0, 0, {{2, 1.0}, {2, -1.0}}),
            "contact[0].normal[1][0] = 2 (must name each coordinate once)");
  EXPECT_EQ(refusal(1.0, 1.0, 0, {{2, 0.0}}),
            "contact[0].normal = zero vector (needs a nonzero coefficient)");
}

constexpr const char* kStop = "[[contact]]\ndof = 0\ngap = 0.1\n[[contact]]\nnormal = [[0, -1]]\ngap = 0.1\n";

TEST(ReadDampedStops, TakesOneNumberOrOnePerContact) {
  const Problem problem = parse_scene(
      oscillator_with(std::string(kStop) + "[law]\npenalty = 20.0\ndamping = [0.5, 0.7]\n"), "scene.toml");
  EXPECT_TRUE(std::holds_alternative<Massless>(problem.law()));
  ASSERT_EQ(problem.size(), 3);
  EXPECT_EQ(problem.stiffness().coeff(1, 1), 20.0);
  EXPECT_EQ(problem.stiffness().coeff(2, 2), 20.0);
  EXPECT_EQ(problem.damping().coeff(1, 1), 0.5);
  EXPECT_EQ(problem.damping().coeff(2, 2), 0.7);
  EXPECT_EQ(problem.damping().coeff(0, 2), 0.7) << "the second stop is below";
}

TEST(ReadDampedStops, MoveWithTheirStopsAndTheBase) {
  const Problem problem = parse_scene(
      oscillator_with(
          "[base]\ndisplacement = [{ cos = 0.3 }]\n[[contact]]\ndof = 0\ngap = 0.1\ngap_term = [{ "
          "cos = 0.02 }]\n[law]\npenalty = 20.0\ndamping = 0.5\n"),
      "scene.toml");
  EXPECT_EQ(stop_motion(problem, 0)[1], 0.02);
  // m w^2 b of the base, and what a face that moves by r hands on: k r - c r' at the mass.
  const Eigen::VectorXd load = load_at(problem, 0.0);
  EXPECT_NEAR(load[0], 2.0 * 4.0 * 0.3 + 20.0 * 0.02, 1e-13);
  EXPECT_NEAR(load[1], -20.0 * 0.02, 1e-14);
}

TEST(ReadDampedStops, RefusesWhatIsNone) {
  const auto refused = [](const std::string& law) { return refusal_of(kStop + ("[law]\n" + law)); };
  EXPECT_EQ(refused("damping = 0.5\n"),
            "scene.toml:17: law.damping = 0.5 (must be absent: no penalty, a spring beside it, is given)");
  EXPECT_EQ(refused("penalty = 1.0\ndamping = [1.0]\n"),
            "scene.toml:18: law.damping = 1 values (must be one number, or one per contact: 2)");
  EXPECT_EQ(refused("penalty = 1.0\ndamping = -1.0\n"),
            "scene.toml:18: law.damping = -1 (must be a positive number [N s/m])");
  EXPECT_EQ(refused("penalty = 1.0\ndamping = [1.0, \"a\"]\n"),
            "scene.toml:18: law.damping[1] = \"a\" (must be a positive number [N s/m])");
  EXPECT_EQ(refused("restitution = 1.0\ndamping = 1.0\n"),
            "scene.toml:18: law.damping = 1 (must be absent: no penalty, a spring beside it, is given)");
}

}  // namespace
}  // namespace signorini::damped_stops_test
