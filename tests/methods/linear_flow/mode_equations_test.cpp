#include "methods/linear_flow/mode_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "tests/support/exact_scenes.hpp"

namespace signorini::mode_equations_test {
namespace {

Problem chain(const Law& law) {
  Problem problem = test::stopped_chain(4, 0.5, 2);
  problem.law = law;
  return problem;
}

const Law kRigid = Restitution{0.5};
const Law kSprings = Penalty{{7.0, 30.0}};

State some_state(int n) {
  return {.u = Eigen::VectorXd::LinSpaced(n, 0.4, -0.3), .v = Eigen::VectorXd::LinSpaced(n, -0.2, 0.6)};
}

TEST(ModeEquations, OutputsAreDisplacementsAndTheForcesOfClosedContacts) {
  for (const Law& law : {kRigid, kSprings}) {
    const ContactDynamics dynamics(chain(law));
    const ModeEquations equations(dynamics, dynamics.mode({false, true}));
    EXPECT_EQ(equations.force_row(0), -1);
    ASSERT_EQ(equations.force_row(1), 2);
    const State state = some_state(4);
    const double time = 0.3;
    Eigen::VectorXd y(8);
    y << state.u, state.v;
    Eigen::VectorXd output = equations.output_of_state * y;
    for (Eigen::Index h = 0; h < equations.harmonics(); ++h) {
      const auto wave = std::polar(1.0, equations.rates()[static_cast<std::size_t>(h)] * time);
      output += (equations.output_of_load.col(h) * wave).real();
    }
    const MotionDerivatives motion = dynamics.derivatives(equations.mode, time, state, 2);
    EXPECT_NEAR(output[0], motion.x(0, 0), 1e-14);
    EXPECT_NEAR(output[1], motion.x(1, 0), 1e-14);
    EXPECT_NEAR(output[2], motion.lambda(1, 0), 1e-13);
  }
}

TEST(ModeEquations, ReducedLoadBalancesAStructureAtRestOnItsStops) {
  // With q = 0 what is left of the load is f_0 - K u_g in the free directions.
  const ContactDynamics dynamics(chain(kRigid));
  const ModeEquations equations(dynamics, dynamics.mode({true, true}));
  const Eigen::VectorXd expected =
      equations.form.basis.transpose() *
      (equations.form.load.col(0).real() - dynamics.structure().stiffness * equations.form.offset);
  EXPECT_LT((equations.reduced_load(0).real() - expected).norm(), 1e-14);
  EXPECT_LT(
      (equations.reduced_load(1) - equations.form.basis.transpose() * equations.form.load.col(1)).norm(),
      1e-14);
}

struct Structure3 {
  Eigen::Matrix3d M, D, K;
};

// Three masses with damping that shares no modes with the springs.
Structure3 structure(double stiffest) {
  return {.M = Eigen::Vector3d(1.0, 2.0, 0.5).asDiagonal(),
          .D = (Eigen::Matrix3d() << 0.3, -0.1, 0.0, -0.1, 0.1, 0.0, 0.0, 0.0, 0.02).finished(),
          .K = (Eigen::Matrix3d() << stiffest, -1.0, 0.0, -1.0, 3.0, -2.0, 0.0, -2.0, 2.5).finished()};
}

MassForm mass_form_of(const Structure3& s) {
  return {s.M.cast<long double>(), s.D.cast<long double>(), s.K.cast<long double>()};
}

EnergyForm form_of(const Structure3& s, double rate) { return {mass_form_of(s), rate}; }

std::vector<std::complex<double>> sorted_eigenvalues(const Eigen::MatrixXd& A) {
  const Eigen::VectorXcd values = A.eigenvalues();
  std::vector<std::complex<double>> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::pair(std::abs(a), a.imag()) < std::pair(std::abs(b), b.imag());
  });
  return sorted;
}

TEST(EnergyForm, HasTheEigenvaluesOfTheFirstOrderSystem) {
  const Structure3 s = structure(4.0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6, 6);
  A.topRightCorner(3, 3).setIdentity();
  A.bottomLeftCorner(3, 3) = -s.M.inverse() * s.K;
  A.bottomRightCorner(3, 3) = -s.M.inverse() * s.D;
  const EnergyForm form = form_of(s, 0.7);
  ASSERT_TRUE(form.definite);
  const auto expected = sorted_eigenvalues(A), found = sorted_eigenvalues(form.B.cast<double>());
  for (std::size_t k = 0; k < 6; ++k) EXPECT_LT(std::abs(found[k] - expected[k]), 1e-13);
}

TEST(EnergyForm, IsNearlySkewWithoutDampingHoweverStiffTheStructure) {
  for (const double stiffest : {4.0, 1e6, 1e12}) {
    Structure3 s = structure(stiffest);
    s.D.setZero();
    const double rate = 0.7;
    const Eigen::MatrixXd B = form_of(s, rate).B.cast<double>();
    // B + B^T holds s^2 E^-T alone, at most s^2 / s.
    EXPECT_LE((B + B.transpose()).norm(), std::sqrt(2.0 * 3.0) * rate) << stiffest;
  }
}

TEST(EnergyForm, FactorsStiffnessAndMass) {
  const Structure3 s = structure(4.0);
  const EnergyForm form = form_of(s, 0.7);
  const Eigen::MatrixXd L = mass_form_of(s).L.cast<double>(), E = form.E.cast<double>();
  EXPECT_LT((L * L.transpose() - s.M).norm(), 1e-15 * s.M.norm());
  const Eigen::MatrixXd scaled = L.inverse() * s.K * L.inverse().transpose();
  EXPECT_LT((E * E.transpose() - scaled - 0.49 * Eigen::Matrix3d::Identity()).norm(), 1e-13);
  EXPECT_LT((form.z_of_e.cast<double>() * E.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(EnergyForm, SaysWhereTheEnergyIsNotDefinite) {
  Structure3 s = structure(4.0);
  s.K(2, 2) = -5.0;
  const EnergyForm form = form_of(s, 0.7);
  EXPECT_FALSE(form.definite);
  // The first-order system is there all the same.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6, 6);
  A.topRightCorner(3, 3).setIdentity();
  A.bottomLeftCorner(3, 3) = -s.M.inverse() * s.K;
  A.bottomRightCorner(3, 3) = -s.M.inverse() * s.D;
  const auto expected = sorted_eigenvalues(A), found = sorted_eigenvalues(form.B.cast<double>());
  for (std::size_t k = 0; k < 6; ++k) EXPECT_LT(std::abs(found[k] - expected[k]), 1e-13);
}

}  // namespace
}  // namespace signorini::mode_equations_test
