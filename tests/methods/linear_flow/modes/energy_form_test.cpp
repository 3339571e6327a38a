#include "methods/linear_flow/modes/energy_form.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

namespace signorini::energy_form_test {
namespace {

using Eigen::MatrixXd;
using extended::rounded;
using extended::widened;

constexpr double kRate = 0.7;

struct Structure3 {
  MatrixXd M, D, K;
};

// Three masses, two of which share a rod, with damping that shares no modes with the springs.
Structure3 structure(double stiffest) {
  Structure3 s{.M = MatrixXd(3, 3), .D = MatrixXd(3, 3), .K = MatrixXd(3, 3)};
  s.M << 1.0, 0.2, 0.0, 0.2, 2.0, 0.0, 0.0, 0.0, 0.5;
  s.D << 0.3, -0.1, 0.0, -0.1, 0.1, 0.0, 0.0, 0.0, 0.02;
  s.K << stiffest, -1.0, 0.0, -1.0, 3.0, -2.0, 0.0, -2.0, 2.5;
  return s;
}

MassForm mass_form_of(const Structure3& s) { return {widened(s.M), widened(s.D), widened(s.K)}; }

double distance(const MatrixXd& A, const MatrixXd& B) { return (A - B).norm() / (1.0 + B.norm()); }

MatrixXd congruent(const MatrixXd& L, const MatrixXd& A) { return L * (A * L.transpose()); }

TEST(MassForm, HasUnitMasses) {
  const Structure3 s = structure(4.0);
  const MassForm form = mass_form_of(s);
  ASSERT_TRUE(form.definite);
  EXPECT_EQ(form.size(), 3);
  const MatrixXd L = rounded(form.L), I = MatrixXd::Identity(3, 3);
  EXPECT_LT(distance(congruent(L, I), s.M), 1e-15);
  EXPECT_LT(distance(congruent(L, rounded(form.damping)), s.D), 1e-15);
  EXPECT_LT(distance(congruent(L, rounded(form.stiffness)), s.K), 1e-15);
  EXPECT_LT(distance(rounded(form.q_of_z) * L.transpose(), I), 1e-15);
  Structure3 massless = s;
  massless.M(2, 2) = 0.0;
  EXPECT_FALSE(mass_form_of(massless).definite);
}

// (e, z') = (E^T L^T q, L^T q') obeys (e, z')' = B (e, z'): e' = E^T z' and L z'' = -K q - D q'.
void expect_first_order_system(const Structure3& s) {
  const MassForm mass = mass_form_of(s);
  const EnergyForm form(mass, kRate);
  const MatrixXd L = rounded(mass.L), E = rounded(form.E), B = rounded(form.B);
  EXPECT_EQ(B.topLeftCorner(3, 3).norm(), 0.0);
  EXPECT_EQ((B.topRightCorner(3, 3) - E.transpose()).norm(), 0.0);
  EXPECT_LT(distance(congruent(L, B.bottomLeftCorner(3, 3) * E.transpose()), -s.K), 1e-14);
  EXPECT_LT(distance(congruent(L, B.bottomRightCorner(3, 3)), -s.D), 1e-14);
  EXPECT_LT(distance(rounded(form.z_of_e) * E.transpose(), MatrixXd::Identity(3, 3)), 1e-14);
}

TEST(EnergyForm, IsTheFirstOrderSystemInItsCoordinates) { expect_first_order_system(structure(4.0)); }

TEST(EnergyForm, KeepsWhatCirculates) {
  Structure3 s = structure(4.0);
  s.K(0, 2) += 0.3;
  s.K(1, 0) -= 0.1;
  EXPECT_TRUE(EnergyForm(mass_form_of(s), kRate).definite);
  expect_first_order_system(s);
}

TEST(EnergyForm, IsNearlySkewWithoutDampingHoweverStiffTheStructure) {
  for (const double stiffest : {4.0, 1e6, 1e12}) {
    Structure3 s = structure(stiffest);
    s.D.setZero();
    const MatrixXd B = rounded(EnergyForm(mass_form_of(s), kRate).B);
    // B + B^T holds s^2 E^-T alone, at most s^2 / s.
    EXPECT_LE((B + B.transpose()).norm(), std::sqrt(2.0 * 3.0) * kRate) << stiffest;
  }
}

TEST(EnergyForm, FactorsTheShiftedStiffness) {
  const Structure3 s = structure(4.0);
  const MassForm mass = mass_form_of(s);
  const EnergyForm form(mass, kRate);
  ASSERT_TRUE(form.definite);
  const MatrixXd E = rounded(form.E), shifted = s.K + kRate * kRate * s.M;
  EXPECT_LT(distance(congruent(rounded(mass.L), E * E.transpose()), shifted), 1e-14);
}

TEST(EnergyForm, SaysWhereTheEnergyIsNotDefinite) {
  Structure3 s = structure(4.0);
  s.K(2, 2) = -5.0;
  EXPECT_FALSE(EnergyForm(mass_form_of(s), kRate).definite);
  expect_first_order_system(s);  // it is there all the same
}

}  // namespace
}  // namespace signorini::energy_form_test
