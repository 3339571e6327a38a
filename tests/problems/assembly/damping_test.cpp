#include "problems/assembly/damping.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "problems/assembly/beam.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini::damping_test {
namespace {

// zeta_i = phi_i^T D phi_i / (2 w_i), and the largest coupling phi_i^T D phi_j / sqrt(w_i w_j), i != j.
struct Ratios {
  Eigen::VectorXd zeta;
  double coupling = 0.0;
};

Ratios ratios(const Structure& structure, const SparseMatrix& damping) {
  const SymmetricEigen modes = generalised_eigen(structure.stiffness, structure.mass);
  const Eigen::VectorXd w = modes.values.cwiseSqrt();
  const Eigen::MatrixXd C = modes.vectors.transpose() * (damping * modes.vectors);
  const Eigen::MatrixXd scaled =
      w.cwiseSqrt().cwiseInverse().asDiagonal() * C * w.cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::MatrixXd off = scaled - Eigen::MatrixXd(scaled.diagonal().asDiagonal());
  return {.zeta = scaled.diagonal() / 2.0, .coupling = off.cwiseAbs().maxCoeff()};
}

TEST(RayleighDamping, CombinesMassAndStiffness) {
  const Structure bar = assemble(Bar{.elements = 4, .density = 3.0});
  const Eigen::MatrixXd D =
      damping_matrix(ProportionalDamping{.alpha = 0.3, .beta = 0.02}, bar.mass, bar.stiffness);
  EXPECT_TRUE(D.isApprox(0.3 * Eigen::MatrixXd(bar.mass) + 0.02 * Eigen::MatrixXd(bar.stiffness), 1e-15));
}

TEST(ModalDamping, GivesEveryModeItsRatio) {
  const Structure beam = assemble(Beam{.elements = 6, .area = 0.01, .inertia = 1e-5, .young = 1e6});
  const SparseMatrix D = damping_matrix(ModalDamping{{0.01, 0.05, 0.002, 0.1}}, beam.mass, beam.stiffness);

  const Ratios found = ratios(beam, D);

  const double expected[] = {0.01, 0.05, 0.002, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(found.zeta(i), expected[i], 1e-9) << "mode " << i + 1;
  EXPECT_LT(found.coupling, 1e-9);
  EXPECT_TRUE(is_symmetric(D));
}

TEST(ModalDamping, OfOneRatioHoldsForAllModes) {
  const Structure bar = assemble(Bar{.elements = 50, .young = 2.1e11, .density = 7850.0});
  const Ratios found = ratios(bar, damping_matrix(ModalDamping{{0.03}}, bar.mass, bar.stiffness));
  EXPECT_LT((found.zeta.array() - 0.03).abs().maxCoeff(), 1e-9);
  EXPECT_LT(found.coupling, 1e-9);
}

// A node without mass follows its neighbours: drop it by static condensation to see the modes.
TEST(ModalDamping, LeavesMasslessCoordinatesAlone) {
  constexpr int kElements = 8;
  const Bar bar{.elements = kElements, .contact_mass = ContactMass::massless, .contacts = {kElements - 1}};
  const Structure structure = assemble(bar);
  const SparseMatrix D = damping_matrix(ModalDamping{{0.02}}, structure.mass, structure.stiffness);
  const Eigen::VectorXd last_row = Eigen::MatrixXd(D).row(kElements - 1);
  EXPECT_EQ(last_row.cwiseAbs().maxCoeff(), 0.0);

  constexpr int kLeft = kElements - 1;
  Structure condensed;
  condensed.mass = structure.mass.topLeftCorner(kLeft, kLeft);
  condensed.stiffness = structure.stiffness.topLeftCorner(kLeft, kLeft);
  condensed.stiffness.coeffRef(kLeft - 1, kLeft - 1) -= kElements;  // EA / h of its one spring
  const Ratios found = ratios(condensed, D.topLeftCorner(kLeft, kLeft));
  EXPECT_LT((found.zeta.array() - 0.02).abs().maxCoeff(), 1e-9);
}

TEST(ModalDamping, LeavesRigidMotionsAlone) {
  const Structure free =
      assemble(Chain{.masses = {1.0, 2.0, 3.0}, .dampers = {0, 0, 0}, .springs = {0, 5, 7}});
  const SparseMatrix D = damping_matrix(ModalDamping{{0.1}}, free.mass, free.stiffness);
  const Eigen::Vector3d rigid = Eigen::Vector3d::Ones();
  EXPECT_LT((D * rigid).cwiseAbs().maxCoeff(), 1e-7 * largest_entry(D));
  EXPECT_GT(largest_entry(D), 0.1);
  EXPECT_TRUE(is_semidefinite(D));
}

TEST(ModalDamping, RefusesLargeSystems) {
  const Structure bar = assemble(Bar{.elements = kMostModalCoordinates + 1});
  EXPECT_THROW(damping_matrix(ModalDamping{{0.1}}, bar.mass, bar.stiffness), std::invalid_argument);
  EXPECT_NO_THROW(damping_matrix(ProportionalDamping{.alpha = 0.1}, bar.mass, bar.stiffness));
}

}  // namespace
}  // namespace signorini::damping_test
