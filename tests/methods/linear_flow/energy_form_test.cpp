#include "methods/linear_flow/energy_form.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <complex>
#include <vector>

namespace signorini {
namespace {

struct Structure3 {
  Eigen::Matrix3d M, D, K;
};

// Three masses with damping that shares no modes with the springs.
Structure3 structure(double stiffest) {
  return {.M = Eigen::Vector3d(1.0, 2.0, 0.5).asDiagonal(),
          .D = (Eigen::Matrix3d() << 0.3, -0.1, 0.0, -0.1, 0.1, 0.0, 0.0, 0.0, 0.02).finished(),
          .K = (Eigen::Matrix3d() << stiffest, -1.0, 0.0, -1.0, 3.0, -2.0, 0.0, -2.0, 2.5).finished()};
}

EnergyForm form_of(const Structure3& s, double rate) {
  return EnergyForm(s.M.cast<long double>(), s.D.cast<long double>(), s.K.cast<long double>(), rate);
}

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
  const Eigen::MatrixXd L = form.L.cast<double>(), E = form.E.cast<double>();
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
}  // namespace signorini
