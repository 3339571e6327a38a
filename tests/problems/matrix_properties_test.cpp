#include "problems/matrix_properties.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/singular_values.hpp"
#include "tests/problems/chain_problems.hpp"

namespace signorini::matrix_properties_test {
namespace {

SparseMatrix sparse(const Eigen::MatrixXd& A) { return A.sparseView(); }

Eigen::MatrixXd random_matrix(int rows, int columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// 2 on the diagonal, -1 beside it, less a shift: its lowest eigenvalue is 4 sin^2(pi / (2 (n + 1))) - shift.
SparseMatrix second_difference(int size, double shift) {
  SparseMatrix A(size, size);
  for (int i = 0; i < size; ++i) {
    A.insert(i, i) = 2.0 - shift;
    if (i == 0) continue;
    A.insert(i, i - 1) = -1.0;
    A.insert(i - 1, i) = -1.0;
  }
  return A;
}

TEST(LargestEntry, IsThatOfTheMagnitudesAndShowsNaN) {
  EXPECT_EQ(largest_entry(SparseMatrix(3, 3)), 0.0);
  SparseMatrix A = second_difference(3, 5.0);  // -3 on the diagonal
  EXPECT_EQ(largest_entry(A), 3.0);
  A.coeffRef(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(largest_entry(A)));
}

TEST(IsSymmetric, ToRoundingOfTheLargestEntry) {
  SparseMatrix A = second_difference(4, 0.0);
  EXPECT_TRUE(is_symmetric(A));
  A.coeffRef(0, 1) += 1e-12;
  EXPECT_TRUE(is_symmetric(A));
  A.coeffRef(0, 1) += 1e-11;
  EXPECT_FALSE(is_symmetric(A));
}

TEST(IsSymmetric, AgreesWithTheTransposeWhereverEntriesAreMissing) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(0, 7);
  for (int trial = 0; trial < 300; ++trial) {
    SparseMatrix A(8, 8);
    for (int i = 0; i < 12; ++i) {
      const int row = place(random);
      const int column = place(random);
      A.coeffRef(row, column) = A.coeffRef(column, row) = 1.0 + i;
    }
    EXPECT_TRUE(is_symmetric(A)) << trial;
    A.coeffRef(place(random), place(random)) += trial % 3 == 0 ? 0.0 : 1.0;
    if (trial % 2 == 0) A.makeCompressed();
    EXPECT_EQ(is_symmetric(A), Eigen::MatrixXd(A) == Eigen::MatrixXd(A.transpose())) << trial;
  }
}

TEST(Combination, IsTheSumWhereverEntriesAreMissing) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 20; ++trial) {
    const auto with_gaps = [&] {
      Eigen::MatrixXd A = random_matrix(6, 6, random);
      return sparse((A.array() > 0.3).select(A, 0.0));
    };
    const SparseMatrix M = with_gaps();
    const SparseMatrix K = with_gaps();
    const SparseMatrix sum = combination({.alpha = 0.5, .beta = -3.0}, M, K);
    EXPECT_EQ(Eigen::MatrixXd(sum), 0.5 * Eigen::MatrixXd(M) - 3.0 * Eigen::MatrixXd(K));
    EXPECT_LE(sum.nonZeros(), M.nonZeros() + K.nonZeros());
  }
}

// Full ones go to CHOLMOD, whatever their size.
TEST(Definiteness, OfFullMatricesIsThatOfTheirSpectrum) {
  constexpr int kSize = 600;
  std::mt19937 random(3);
  const Eigen::MatrixXd Q = householder_basis(random_matrix(kSize, kSize, random));
  Eigen::VectorXd spectrum = Eigen::VectorXd::LinSpaced(kSize, 0.1, 10.0);
  const auto full = [&] {
    const Eigen::MatrixXd A = Q * spectrum.asDiagonal() * Q.transpose();
    return sparse(0.5 * (A + A.transpose()));
  };
  EXPECT_TRUE(is_definite(full()));
  spectrum[17] = -1e-3;
  EXPECT_FALSE(is_semidefinite(full()));
}

// Factorised by Eigen and by CHOLMOD.
TEST(Definiteness, OfSmallAndLargeMatricesIsJudgedByTheLowestEigenvalue) {
  for (const int size : {50, 3000}) {
    const double sine = std::sin(0.5 * std::numbers::pi / (size + 1));
    const double lowest = 4.0 * sine * sine;
    EXPECT_TRUE(is_definite(second_difference(size, 0.5 * lowest))) << size;
    EXPECT_TRUE(is_semidefinite(second_difference(size, 0.5 * lowest))) << size;
    EXPECT_FALSE(is_semidefinite(second_difference(size, 2.0 * lowest))) << size;
    EXPECT_FALSE(is_definite(second_difference(size, 2.0 * lowest))) << size;
  }
}

TEST(Definiteness, DoesNotDependOnUnits) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 50; ++trial) {
    const int size = 2 + trial % 9;
    const Eigen::MatrixXd B = random_matrix(size, size - 1, random);  // B B^T: one null direction
    const Eigen::MatrixXd semidefinite = B * B.transpose();
    const Eigen::VectorXd null = right_singular_vectors(B.transpose()).col(size - 1);
    const Eigen::VectorXd units =
        random_matrix(size, 1, random).unaryExpr([](double x) { return std::pow(10.0, 3.0 * x); });
    const Eigen::MatrixXd E = units.asDiagonal();
    const auto in_units = [&](const Eigen::MatrixXd& A) {
      return sparse((0.5 * E * (A + A.transpose()) * E).eval());
    };
    const double curvature = 1e-3 * semidefinite.diagonal().minCoeff();
    const Eigen::MatrixXd nn = curvature * null * null.transpose();

    EXPECT_TRUE(is_semidefinite(in_units(semidefinite))) << trial;
    EXPECT_FALSE(is_definite(in_units(semidefinite))) << trial;
    EXPECT_TRUE(is_definite(in_units(semidefinite + nn))) << trial;
    EXPECT_FALSE(is_semidefinite(in_units(semidefinite - nn))) << trial;
  }
}

TEST(Definiteness, SeesCouplingToACoordinateWithoutDiagonal) {
  Eigen::Matrix2d A;
  A << 1.0, 0.1, 0.1, 0.0;
  EXPECT_FALSE(is_semidefinite(sparse(A)));
  A << 1.0, 0.0, 0.0, 0.0;
  EXPECT_TRUE(is_semidefinite(sparse(A)));
  EXPECT_FALSE(is_definite(sparse(A)));
  A << 1.0, 0.0, 0.0, -1e-3;
  EXPECT_FALSE(is_semidefinite(sparse(A)));
  EXPECT_TRUE(is_semidefinite(SparseMatrix(3, 3))) << "the zero matrix";
}

Structure chain() { return *test::three_masses().structure; }

TEST(ProportionalDamping, IsFoundAgainFromTheMatrices) {
  const Structure s = chain();
  const auto found = proportional_damping(s.mass, s.stiffness, 0.3 * s.mass + 2e-5 * s.stiffness);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->alpha, 0.3, 1e-13);
  EXPECT_NEAR(found->beta, 2e-5, 1e-13);
}

TEST(ProportionalDamping, IsThatOfTheAssemblyUntilTheStructureIsEdited) {
  Problem problem = test::three_masses();
  const auto damp = [&problem](ProportionalDamping factors) {
    problem.edit_structure([&](Structure& s) {
      s.damping = combination(factors, s.mass, s.stiffness);
      s.proportional = factors;
    });
    return proportional_damping(*problem.structure).value();
  };
  EXPECT_EQ(damp({.alpha = 0.1, .beta = 1.0 / 3.0}).alpha, 0.1);
  EXPECT_EQ(damp({.alpha = 0.1, .beta = 1.0 / 3.0}).beta, 1.0 / 3.0);
  EXPECT_EQ(damp({.alpha = 0.1, .beta = 1e-22}).beta, 0.0) << "a part that is lost in rounding";
  problem.edit_structure([](Structure& s) { s.damping.coeffRef(1, 1) += 1e-3; });
  EXPECT_FALSE(proportional_damping(*problem.structure));
}

TEST(ProportionalDamping, IsNothingForADamperOfItsOwn) {
  const Structure s = chain();
  SparseMatrix D = 0.3 * s.mass + 0.02 * s.stiffness;
  D.coeffRef(1, 1) += 1e-9;
  EXPECT_FALSE(proportional_damping(s.mass, s.stiffness, D));
}

TEST(ProportionalDamping, OfNoDampingIsZero) {
  const Structure s = chain();
  const auto found = proportional_damping(s.mass, s.stiffness, SparseMatrix(3, 3));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->alpha, 0.0);
  EXPECT_EQ(found->beta, 0.0);
}

TEST(ProportionalDamping, OfAFreeStructureIsThatOfItsMass) {
  const Structure s = chain();
  const auto found = proportional_damping(s.mass, SparseMatrix(3, 3), 0.7 * s.mass);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->alpha, 0.7, 1e-15);
  EXPECT_EQ(found->beta, 0.0);
}

TEST(ProportionalDamping, IsNothingWhereAnEntryIsNoNumber) {
  const Structure s = chain();
  SparseMatrix M = s.mass;
  M.coeffRef(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(proportional_damping(M, s.stiffness, s.stiffness));
}

// alpha and beta are not determined then; their sum is.
TEST(ProportionalDamping, WhereMassAndStiffnessAreProportionalTooGivesTheDampingBack) {
  const SparseMatrix M = chain().mass;
  const auto found = proportional_damping(M, 4.0 * M, 2.0 * M);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->alpha + 4.0 * found->beta, 2.0, 1e-14);
}

}  // namespace
}  // namespace signorini::matrix_properties_test
