#include "methods/structure/rigid_motions.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>
#include <string>

#include "methods/structure/receptance.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/damped_stops.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/exponential.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::rigid_motions_test {
namespace {

Problem of_matrices(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness) {
  Problem problem;
  problem.edit_structure([&](Structure& s) {
    s.mass = mass.sparseView();
    s.stiffness = stiffness.sparseView();
    s.damping = SparseMatrix(mass.rows(), mass.cols());
  });
  return problem;
}

/// n masses of 2 kg, joined by springs, held nowhere.
Problem free_chain(int n, double spring) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i + 1 < n; ++i) {
    K(i, i) += spring;
    K(i + 1, i + 1) += spring;
    K(i, i + 1) = K(i + 1, i) = -spring;
  }
  return of_matrices(2.0 * Eigen::MatrixXd::Identity(n, n), K);
}

TEST(RigidMotions, AreOfUnitInertiaAndStrainNothing) {
  for (const int n : {1, 3, 40, 500}) {  // 500: by inverse iteration
    const Problem problem = free_chain(n, 1e7);
    const Eigen::MatrixXd R = rigid_motions(problem);
    ASSERT_EQ(R.cols(), 1) << n;
    EXPECT_NEAR((R.transpose() * problem.mass() * R)(0, 0), 1.0, 1e-9);
    EXPECT_LE((R.array() - R(0, 0)).abs().maxCoeff(), 1e-7 * std::abs(R(0, 0))) << n;
  }
}

TEST(RigidMotions, AreNoneOfStructuresOnSpringsHoweverDifferentTheirUnits) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3, 3);
  K.diagonal() << 1e-8, 1.0, 1e20;
  EXPECT_EQ(rigid_motions(of_matrices(Eigen::MatrixXd::Identity(3, 3), K)).cols(), 0);
}

TEST(RigidMotions, AreNotTakenForRoundingBesideAStiffLink) {
  Problem linked = free_chain(3, 1.0);
  linked.edit_structure([](Structure& s) {
    s.stiffness.coeffRef(2, 2) += 1.0;
    for (const int i : {0, 1}) s.stiffness.coeffRef(i, i) += 1e20;
    s.stiffness.coeffRef(0, 1) = s.stiffness.coeffRef(1, 0) = -1e20;
  });
  linked.frequency = 0.9;
  linked.contacts = {{.normal = {{2, 1.0}}, .gap = 0.5}};
  try {
    static_cast<void>(fourier_receptance(linked, 4));
    ADD_FAILURE() << "a K of rounding was taken";
  } catch (const SingularStiffness& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("stiffness between coordinates 0 and 1 is 1e+20 N/m, "))
        << error.what();
  }
}

TEST(RigidMotions, OfPartsAreOnePerPart) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3, 3);
  K(1, 1) = 1000.0;
  EXPECT_EQ(rigid_motions(of_matrices(Eigen::MatrixXd::Identity(3, 3), K)).cols(), 2);
}

TEST(RigidMotions, AreNoneWhereOneCarriesNoMass) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(2, 2);
  M(1, 1) = 0.0;
  EXPECT_EQ(rigid_motions(of_matrices(M, Eigen::MatrixXd::Zero(2, 2))).cols(), 0);
}

TEST(HeldStructure, DeflectsAsTheStructureWithASpringOnEachRigidMotion) {
  const Problem problem = free_chain(4, 3.0);
  const Eigen::MatrixXd R = rigid_motions(problem);
  constexpr double kRate = 1.7;
  const Eigen::MatrixXd moments = problem.mass() * R;
  const Eigen::MatrixXd held =
      Eigen::MatrixXd(problem.stiffness()) + kRate * kRate * moments * moments.transpose();
  const Eigen::MatrixXd u = HeldStructure(problem, R, kRate).solve(Eigen::MatrixXd::Identity(4, 4));
  EXPECT_LE((held * u - Eigen::MatrixXd::Identity(4, 4)).norm(), 1e-12);
}

TEST(StaticReceptance, KeepsTheMeanLoadThatContactsAreToBalance) {
  const ContactReceptance receptance = fourier_receptance(test::gear_backlash(), 3);
  ASSERT_EQ(receptance.rigid_count(), 1);
  // Both contacts feel the one motion, with opposite signs; m = 1.
  EXPECT_NEAR(receptance.rigid(0, 0), -receptance.rigid(1, 0), 1e-15);
  EXPECT_NEAR(receptance.rigid(0, 0) * receptance.rigid_load[0], 0.1, 1e-15);
}

TEST(StaticReceptance, LeavesOutMotionsThatNoContactFeels) {
  Problem problem = of_matrices(Eigen::Matrix2d::Identity(), Eigen::Vector2d(1.0, 0.0).asDiagonal());
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.2}};
  problem.set_law(Restitution{0.8});
  problem.force = {{.dof = 0, .cos = 1.0}};
  problem.frequency = 2.2;
  const ContactReceptance receptance = fourier_receptance(problem, 1);
  EXPECT_EQ(receptance.rigid_count(), 0);
  EXPECT_NEAR(receptance.receptance[0](0, 0).real(), 1.0, 1e-14);
}

TEST(StaticReceptance, OfAFreeStructureWithoutContactsHoldsNothing) {
  Problem problem = of_matrices(Eigen::Matrix2d::Identity(), Eigen::Matrix2d({{5.0, -5.0}, {-5.0, 5.0}}));
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 0.2}};
  const ContactReceptance receptance = fourier_receptance(problem, 1);
  EXPECT_EQ(receptance.rigid_count(), 0);
  EXPECT_EQ(receptance.receptance[0].size(), 0);
  problem.force.front().harmonic = 0;
  EXPECT_THROW(fourier_receptance(problem, 1), NoPeriodicMotion);
}

TEST(StaticReceptance, NamesTheDirectionAlongWhichNothingBalancesTheLoad) {
  Problem ball = test::bouncing_ball();
  ball.force.front().cos = -9.81;  // away from its one stop
  try {
    fourier_receptance(ball, 3);
    FAIL();
  } catch (const NoPeriodicMotion& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("no periodic motion"), std::string::npos) << text;
    EXPECT_NE(text.find("9.81 N"), std::string::npos) << text;
    EXPECT_NE(text.find("coordinate 0: -1"), std::string::npos) << text;
  }
}

TEST(StaticReceptance, ThrowsWhereAnIdlePartIsDriven) {
  Problem problem = of_matrices(Eigen::Matrix2d::Identity(), Eigen::Vector2d(1.0, 0.0).asDiagonal());
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.2}};
  problem.set_law(Restitution{0.8});
  problem.force = {{.dof = 1, .harmonic = 0, .cos = 3.0}};
  EXPECT_THROW(fourier_receptance(problem, 1), NoPeriodicMotion);
}

// The face that a damped stop adds behind the structure's coordinates is none of the user's.
TEST(StaticReceptance, NamesCoordinatesWithMassAlone) {
  Problem ball = test::bouncing_ball();
  ball.force.front().cos = -9.81;
  damp_stops(ball, {{.contact = 0, .normal = {{0, 1.0}}, .stiffness = 20.0, .damping = 0.5}});
  EXPECT_EQ(unbalanced_mean_load(ball),
            "no periodic motion: neither springs nor contacts balance the mean load of 9.81 N along the free "
            "motion (coordinate 0: -1)");
}

/// Two masses of 1 kg on a spring between them and none to the ground, beside one on a spring before a stop;
/// `noise` couples the second with the last.
Problem beside_an_idle_pair(double noise) {
  Eigen::Matrix3d K;
  K << 3.0, -3.0, 0.0, -3.0, 3.0, noise, 0.0, noise, 1.0;
  Problem problem = of_matrices(Eigen::Matrix3d::Identity(), K);
  problem.contacts = {{.normal = {{2, 1.0}}, .gap = 0.2}};
  problem.set_law(Restitution{0.8});
  problem.frequency = 2.2;
  return problem;
}

// Along a period, by the flow of (u, v): the pair as one is nowhere at home without what holds it.
TEST(IdleParts, AreHeldWithoutAMultiplierOfOneAtAnyFrequency) {
  for (const double noise : {0.0, 1e-15}) {
    const auto held = with_idle_parts_held(beside_an_idle_pair(noise));
    ASSERT_TRUE(held) << noise;
    Eigen::MatrixXd flow = Eigen::MatrixXd::Zero(4, 4);
    flow.topRightCorner(2, 2).setIdentity();
    flow.bottomLeftCorner(2, 2) = -Eigen::MatrixXd(held->stiffness()).topLeftCorner(2, 2);
    flow.bottomRightCorner(2, 2) = -Eigen::MatrixXd(held->damping()).topLeftCorner(2, 2);
    for (const double frequency : {2.2, 1.1, 2.2 / 3.0, 1.7}) {
      const Eigen::MatrixXd period = matrix_exponential(2.0 * std::numbers::pi / frequency * flow);
      const Eigen::Vector4d as_one(1.0, 1.0, 0.0, 0.0);
      EXPECT_LT((period * as_one).norm(), 0.9 * as_one.norm()) << frequency;
    }
  }
}

// Z_n u = f_n of the scene and of the held one, whose Z_n is another.
TEST(IdleParts, MoveUnderTheirLoadAsIfNothingHeldThem) {
  Problem problem = beside_an_idle_pair(0.0);
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 0.7, .sin = 0.2}, {.dof = 1, .harmonic = 3, .sin = -0.4}};
  const auto held = with_idle_parts_held(problem);
  ASSERT_TRUE(held);
  for (const int harmonic : {1, 3}) {
    const double w = harmonic * problem.frequency;
    const auto response = [&](const Problem& scene) -> Eigen::VectorXcd {
      const Eigen::MatrixXcd Z = Eigen::MatrixXd(scene.stiffness() - w * w * scene.mass()) +
                                 std::complex<double>(0.0, w) * Eigen::MatrixXd(scene.damping());
      return CompleteComplexLuFactors(Z).inverse() * load_harmonic(scene, harmonic);
    };
    EXPECT_LE((response(*held) - response(problem)).norm(), 1e-12 * response(problem).norm()) << harmonic;
  }
  problem.force.push_back({.dof = 0, .harmonic = 0, .cos = 1.0});  // it flies away
  EXPECT_FALSE(with_idle_parts_held(problem));
}

}  // namespace
}  // namespace signorini::rigid_motions_test
