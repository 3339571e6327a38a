#include "problems/assembly/shaft.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace signorini {
namespace {

constexpr double kPi = std::numbers::pi;

// Of unit length and bending stiffness; mass 1.
Shaft shaft(int elements, double bearing_stiffness) {
  return {.beam = {.elements = elements}, .bearing_stiffness = bearing_stiffness};
}

// Rising, [rad/s].
Eigen::VectorXd frequencies(const Structure& structure) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
      Eigen::MatrixXd(structure.stiffness), Eigen::MatrixXd(structure.mass), Eigen::EigenvaluesOnly);
  return modes.eigenvalues().cwiseSqrt();
}

TEST(AssembleShaft, OnStiffBearingsIsTheSimplySupportedBeamInBothPlanesAtOrderFour) {
  for (int k = 1; k <= 2; ++k) {
    const auto error = [&](int elements) {
      const Eigen::VectorXd found = frequencies(assemble(shaft(elements, 1e9)));
      EXPECT_NEAR(found(2 * k - 1), found(2 * k - 2), 1e-6 * found(2 * k - 2)) << "planes are alike";
      return found(2 * k - 2) / (k * k * kPi * kPi) - 1.0;
    };
    EXPECT_NEAR(std::log2(error(2 * k) / error(4 * k)), 4.0, 0.3) << "mode " << k;
  }
}

// Between its ends u'''' = 0 twice: F L^3 / (48 E I) at midspan, and both bearings give way.
TEST(AssembleShaft, SagsUnderItsDiscAsTheBeamDoes) {
  constexpr double kBearing = 300.0;
  const Eigen::MatrixXd K = assemble(shaft(6, kBearing)).stiffness;
  const int disc = 4 * 3;
  for (const int plane : {0, 2}) {
    const Eigen::VectorXd force = Eigen::VectorXd::Unit(K.rows(), disc + plane);
    const Eigen::VectorXd sag = K.ldlt().solve(force);
    EXPECT_NEAR(sag(disc + plane), 1.0 / 48.0 + 1.0 / (2.0 * kBearing), 1e-12);
    EXPECT_NEAR(sag(plane), 1.0 / (2.0 * kBearing), 1e-12);
    EXPECT_EQ(sag(disc + 2 - plane), 0.0) << "the other plane";
  }
}

TEST(AssembleShaft, BouncesOnSoftBearingsWithItsDisc) {
  Shaft soft = shaft(4, 1e-4);
  soft.disc_mass = 3.0;
  soft.disc_node = 2;
  const Eigen::VectorXd found = frequencies(assemble(soft));
  EXPECT_NEAR(found(0), std::sqrt(2.0 * 1e-4 / 4.0), 1e-5 * found(0));
  EXPECT_NEAR(found(1), found(0), 1e-5 * found(0));
}

TEST(AssembleShaft, IsDampedAtItsBearings) {
  Shaft damped = shaft(3, 1.0);
  damped.bearing_damping = 0.25;
  const Eigen::MatrixXd D = assemble(damped).damping;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(16, 16);
  for (const int dof : {0, 2, 12, 14}) expected(dof, dof) = 0.25;
  EXPECT_EQ(D, expected);
}

// Seen in axes turned about the shaft, nothing changes.
TEST(AssembleShaft, IsTheSameInAllDirections) {
  Shaft any = shaft(3, 50.0);
  any.disc_mass = 2.0;
  any.disc_node = 1;
  const Structure structure = assemble(any);
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(16, 16);
  for (int node = 0; node < 4; ++node) {
    for (int r = 0; r < 2; ++r) {
      const int i = 4 * node + r;
      turn(i, i) = turn(i + 2, i + 2) = c;
      turn(i, i + 2) = s;
      turn(i + 2, i) = -s;
    }
  }
  for (const SparseMatrix* A : {&structure.mass, &structure.stiffness}) {
    const Eigen::MatrixXd dense(*A);
    EXPECT_LT((turn.transpose() * dense * turn - dense).cwiseAbs().maxCoeff(),
              1e-14 * dense.cwiseAbs().maxCoeff());
  }
  EXPECT_DOUBLE_EQ(structure.mass.coeff(4, 4) - assemble(shaft(3, 50.0)).mass.coeff(4, 4), 2.0);
}

}  // namespace
}  // namespace signorini
