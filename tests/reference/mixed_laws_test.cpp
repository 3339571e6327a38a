// Scenes whose contacts have different laws, against a march through time of their own.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/augmented_lagrangian/augmented_lagrangian.hpp"
#include "methods/closed_hbm/closed_hbm.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/stop_march.hpp"

namespace signorini::mixed_laws_test {
namespace {

using test::solve;
using March = test::StopMarch;

/// Three masses between springs; `stops` are its contacts and laws.
Problem chain_before(const std::string& stops, double last_mass = 1.0) {
  return parse_scene(
      "schema = 1\nname = \"chain\"\n[system]\nkind = \"chain\"\nmasses = [1.0, 1.2, " +
          std::to_string(last_mass) +
          "]\ndampers = [0.3, 0.3, 0.0]\nsprings = [1.0, 1.5, 2.0]\n[forcing]\nfrequency = "
          "0.9\n[[forcing.term]]\ndof = 0\ncos = 0.8\n[[forcing.term]]\ndof = 1\ncos = 0.3\nsin = 0.2\n" +
          stops,
      "chain.toml");
}

Eigen::VectorXd along(int dof, int size, double sign = 1.0) {
  return sign * Eigen::VectorXd::Unit(size, dof);
}

constexpr int kCount = 256, kPeriods = 60;
constexpr double kMarched = 1e-5;  // what the march errs at the springs [m]

/// By event-driven from rest, and the exact orbit next to that.
std::vector<Solution> solutions(const Problem& problem) {
  std::vector<Solution> found{solve<EventDriven>(problem, {})};
  found.push_back(ExactOrbitMethod({}).prepare(problem)->solve({.guess = found.front().trajectory}));
  return found;
}

/// x of the contacts is that of the march, which is returned.
March expect_marched(const Problem& problem, const std::vector<March::Stop>& stops) {
  March march(problem, stops);
  const Eigen::MatrixXd u = march.run(kPeriods, kCount);
  for (const Solution& solution : solutions(problem)) {
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    if (!solution.trajectory) continue;
    const Eigen::MatrixXd found = solution.trajectory->sample(kCount).x;
    for (std::size_t j = 0; j < stops.size(); ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      const Eigen::VectorXd x = u * stops[j].normal - march.compressions.col(column);
      EXPECT_LT((found.col(column) - x).cwiseAbs().maxCoeff(), kMarched) << solution.message;
    }
  }
  return march;
}

TEST(MixedLaws, RigidBesideRubber) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\nrestitution = 0.6\n[[contact]]\ndof = 2\nside = \"below\"\ngap = "
      "0.3\npenalty = 7.0\n");
  expect_marched(problem, {{.normal = along(0, 3), .gap = 0.4, .restitution = 0.6},
                           {.normal = along(2, 3, -1.0), .gap = 0.3, .stiffness = 7.0}});
}

// On different masses, and before one: there the damped stop is pushed when the rigid one is struck, and let
// go by that.
TEST(MixedLaws, RigidBesideDamped) {
  const std::string rigid = "[[contact]]\ndof = 0\ngap = 0.4\nrestitution = 0.6\n";
  const March::Stop stop{.normal = along(0, 3), .gap = 0.4, .restitution = 0.6};
  const Problem apart = chain_before(
      rigid + "[[contact]]\ndof = 2\nside = \"below\"\ngap = 0.3\npenalty = 7.0\ndamper = 0.8\n");
  expect_marched(apart, {stop, {.normal = along(2, 3, -1.0), .gap = 0.3, .stiffness = 7.0, .damping = 0.8}});
  const Problem same = parse_scene(
      "schema = 1\nname = \"s\"\n[system]\nkind = \"sdof\"\nmass = 1.0\ndamping = 0.1\nstiffness = "
      "1.0\n[forcing]\nfrequency = 2.0\n[[forcing.term]]\ndof = 0\ncos = 1.0\n[[contact]]\ndof = 0\ngap = "
      "0.2\nrestitution = 0.8\n[[contact]]\ndof = 0\ngap = 0.1\npenalty = 20.0\ndamper = 2.0\n",
      "s.toml");
  const March march =
      expect_marched(same, {{.normal = along(0, 1), .gap = 0.2, .restitution = 0.8},
                            {.normal = along(0, 1), .gap = 0.1, .stiffness = 20.0, .damping = 2.0}});
  EXPECT_GT(march.struck_while_pushing, kPeriods / 2);
}

TEST(MixedLaws, TwoRestitutions) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\n[[contact]]\ndof = 2\ngap = 0.5\nrestitution = "
      "0.3\n[law]\nrestitution = "
      "0.8\n");
  expect_marched(problem, {{.normal = along(0, 3), .gap = 0.4, .restitution = 0.8},
                           {.normal = along(2, 3), .gap = 0.5, .restitution = 0.3}});
}

// A tip without mass on its spring is that spring for the mass behind it.
TEST(MixedLaws, MasslessBesideMassive) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\n[[contact]]\ndof = 2\ngap = 0.3\nmassless = true\n[law]\nrestitution "
      "= "
      "0.6\n",
      0.0);
  // Without the spring to the tip, which the march has as its stop.
  Problem behind = problem;
  behind.edit_structure([](Structure& s) { s.stiffness.coeffRef(1, 1) -= 2.0; });
  March march(behind, {{.normal = along(0, 2), .gap = 0.4, .restitution = 0.6},
                       {.normal = along(1, 2), .gap = 0.3, .stiffness = 2.0}});
  const Eigen::MatrixXd u = march.run(kPeriods, kCount);
  for (const Solution& solution : solutions(problem)) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples found = solution.trajectory->sample(kCount);
    EXPECT_LT((found.x.col(0) - u.col(0)).cwiseAbs().maxCoeff(), kMarched);
    EXPECT_LT((found.x.col(1).array() - u.col(1).array().min(0.3)).abs().maxCoeff(), kMarched);
    EXPECT_LT((found.force.col(1).array() + 2.0 * (u.col(1).array() - 0.3).max(0.0)).abs().maxCoeff(),
              10.0 * kMarched);
  }
}

TEST(MixedLaws, SpringBesideMassless) {
  const Problem problem =
      chain_before("[[contact]]\ndof = 0\ngap = 0.4\npenalty = 5.0\n[[contact]]\ndof = 2\ngap = 0.3\n", 0.0);
  Problem behind = problem;
  behind.edit_structure([](Structure& s) { s.stiffness.coeffRef(1, 1) -= 2.0; });
  March march(behind, {{.normal = along(0, 2), .gap = 0.4, .stiffness = 5.0},
                       {.normal = along(1, 2), .gap = 0.3, .stiffness = 2.0}});
  const Eigen::MatrixXd u = march.run(kPeriods, kCount);
  for (const Solution& solution : solutions(problem)) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples found = solution.trajectory->sample(kCount);
    EXPECT_LT((found.x.col(0) - u.col(0)).cwiseAbs().maxCoeff(), kMarched);
  }
}

TEST(MixedLaws, EqualOnesAreTheSceneOfOneLaw) {
  const std::string one = "[[contact]]\ndof = 0\ngap = 0.4\n", two = "[[contact]]\ndof = 2\ngap = 0.5\n";
  for (const std::string law : {"restitution = 0.6\n", "penalty = 7.0\n"}) {
    const Problem own = chain_before(one + law + two + law),
                  common = chain_before(one + two + "[law]\n" + law);
    const Solution a = solve<ExactOrbitMethod>(own, {}), b = solve<ExactOrbitMethod>(common, {});
    ASSERT_EQ(a.verdict, Verdict::converged) << a.message;
    EXPECT_EQ(a.trajectory->sample(64).x, b.trajectory->sample(64).x);
    EXPECT_EQ(a.message, b.message);
  }
}

// x at t = 0, T / 4 and T / 2 by tests/attack/own_flow.py, which shares no code with ours.
TEST(MixedLaws, OfTheCatalogueMoveAsAnIndependentFlowDoes) {
  const Problem scene = load_scene(find_scene("chain2-housing-and-buffer"));
  for (const Solution& solution : {solve<ExactOrbitMethod>(scene, {}), solve<EventDriven>(scene, {})}) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Eigen::VectorXd x = solution.trajectory->sample(4).x.col(0);
    EXPECT_LT((x.head(3) - Eigen::Vector3d(0.16765568, 0.16253195, -0.41006704)).cwiseAbs().maxCoeff(), 1e-7);
  }
}

/// Hat functions on one grid and series of one number of harmonics.
std::vector<std::unique_ptr<Method>> methods_of_forms() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<HatLcp>(HatLcp::Options{.samples = 256}));
  methods.push_back(
      std::make_unique<FourierLipschitz>(FourierLipschitz::Options{.common = {.harmonics = 20}}));
  methods.push_back(std::make_unique<AftHbm>(AftHbm::Options{.common = {.harmonics = 20}}));
  methods.push_back(std::make_unique<AugmentedLagrangian>(AugmentedLagrangian::Options{.harmonics = 20}));
  methods.push_back(std::make_unique<PenaltyHbm>(PenaltyHbm::Options{.common = {.harmonics = 20}}));
  return methods;
}

Samples samples_of(const Method& method, const Problem& problem) {
  EXPECT_EQ(method.supports(problem).reason, "");
  const Solution solution = method.prepare(problem)->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  return solution.trajectory->sample(256);
}

// 2 x - y = 5 + l and 2 y - x = 3 - 4 (y - 0.2) at x = 0.5.
TEST(MixedLaws, UnderAConstantLoadHaveItsStaticForces) {
  Problem problem;
  problem.edit_structure([](Structure& s) {
    s.mass = Eigen::MatrixXd(Eigen::Matrix2d::Identity()).sparseView();
    s.damping = Eigen::MatrixXd(0.3 * Eigen::Matrix2d::Identity()).sparseView();
    s.stiffness = (Eigen::MatrixXd(2, 2) << 2.0, -1.0, -1.0, 2.0).finished().sparseView();
  });
  problem.force = {{.dof = 0, .harmonic = 0, .cos = 5.0}, {.dof = 1, .harmonic = 0, .cos = 3.0}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.5, .law = Restitution{0.6}},
                      {.normal = {{1, 1.0}}, .gap = 0.2, .law = Spring{4.0}}};
  const double y = 4.3 / 6.0;
  const Eigen::RowVector2d x(0.5, y), force(1.0 - y - 5.0, -4.0 * (y - 0.2));
  std::vector<std::unique_ptr<Method>> methods = methods_of_forms();
  methods.pop_back();  // whose rigid stop is a spring
  for (const auto& method : methods) {
    const Samples found = samples_of(*method, problem);
    EXPECT_LT((found.x.rowwise() - x).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((found.force.rowwise() - force).cwiseAbs().maxCoeff(), 1e-8);
  }
}

/// Oscillators that nothing couples, each with one stop of its law.
Problem uncoupled(const std::vector<ContactLaw>& laws) {
  const auto size = static_cast<int>(laws.size());
  Problem problem;
  problem.frequency = 0.9;
  problem.edit_structure([size](Structure& s) {
    s.mass = SparseMatrix(size, size);
    s.mass.setIdentity();
    s.damping = 0.2 * s.mass;
    s.stiffness = 2.0 * s.mass;
  });
  for (int i = 0; i < size; ++i) {
    problem.force.push_back({.dof = i, .cos = 1.0});
    problem.contacts.push_back({.normal = {{i, 1.0}}, .gap = 0.6, .law = laws[static_cast<std::size_t>(i)]});
  }
  return problem;
}

TEST(MixedLaws, OfUncoupledOscillatorsAreEachAsAlone) {
  const std::vector<ContactLaw> laws{Restitution{0.6}, Spring{7.0}, Restitution{0.9}};
  for (const auto& method : methods_of_forms()) {
    const Samples together = samples_of(*method, uncoupled(laws));
    for (Eigen::Index j = 0; j < 3; ++j) {
      const Samples alone = samples_of(*method, uncoupled({laws[static_cast<std::size_t>(j)]}));
      ASSERT_LT(alone.force.minCoeff(), -0.1) << "its stop is met";
      EXPECT_LT((together.x.col(j) - alone.x.col(0)).cwiseAbs().maxCoeff(), 1e-8) << j;
    }
  }
}

/// Of an answer from the orbit next to it.
double error_of(const Method& method, const Problem& problem) {
  const Solution found = method.prepare(problem)->solve({});
  EXPECT_EQ(found.verdict, Verdict::converged) << found.message;
  const Solution orbit = ExactOrbitMethod({}).prepare(problem)->solve({.guess = found.trajectory});
  EXPECT_EQ(orbit.verdict, Verdict::converged) << orbit.message;
  return test::relative_distance(*orbit.trajectory, *found.trajectory);
}

// Hat functions have the restitution of the scene; the series are asked where impacts lose nothing.
TEST(MixedLaws, OfHatFunctionsAndSeriesApproachTheOrbit) {
  const Problem scene = load_scene(find_scene("chain2-housing-and-buffer"));
  const double coarse = error_of(HatLcp({.samples = 256}), scene);
  EXPECT_LT(coarse, 0.05);
  EXPECT_LT(error_of(HatLcp({.samples = 1024}), scene), 0.4 * coarse);
  Problem elastic = scene;
  elastic.contacts.front().law = Restitution{1.0};
  const double few = error_of(FourierLipschitz({.common = {.harmonics = 10}}), elastic);
  EXPECT_LT(few, 0.2);
  EXPECT_LT(error_of(FourierLipschitz({.common = {.harmonics = 40}}), elastic), 0.4 * few);
}

TEST(MixedLaws, AreRefusedWhereOneLawIsKnownOrNone) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\nrestitution = 0.6\n[[contact]]\ndof = 2\ngap = 0.3\npenalty = 7.0\n");
  EXPECT_EQ(
      ClosedHbm({}).supports(problem).reason,
      "contacts of different laws, contact 0 with restitution 0.6 and contact 1 with a spring: the method "
      "knows one law for all");
  EXPECT_EQ(HatLcp({.plain = true}).supports(problem).reason,
            "restitution = none leaves the law of rigid contacts open, but others have one of their own");
}

TEST(MixedLaws, AreRepresentedContactByContact) {
  const Problem problem = chain_before(
      "[[contact]]\ndof = 0\ngap = 0.4\nrestitution = 0.6\n[[contact]]\ndof = 2\ngap = 0.3\npenalty = 7.0\n");
  const auto laws = [&problem](const Method& method) {
    return std::get<MixedLaws>(method.law(problem)).laws;
  };
  EXPECT_EQ(laws(HatLcp({})), (std::vector<ContactLaw>{Restitution{0.6}, Spring{7.0}}));
  EXPECT_EQ(laws(HatLcp({.scheme = HatScheme::backward})),
            (std::vector<ContactLaw>{Restitution{0.0}, Spring{7.0}}));
  EXPECT_EQ(laws(AftHbm({})), (std::vector<ContactLaw>{Restitution{1.0}, Spring{7.0}}));
}

}  // namespace
}  // namespace signorini::mixed_laws_test
