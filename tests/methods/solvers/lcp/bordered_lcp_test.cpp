#include "methods/solvers/lcp/bordered_lcp.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numeric>
#include <random>

#include "methods/discretisation/block_circulant.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "tests/support/random_lcp.hpp"

namespace signorini::bordered_lcp_test {
namespace {

using test::random_vector;

/// A A^T + 1, a random border of two columns and a balance that z > 0 can meet.
Lcp random_bordered(int n, std::mt19937& random) {
  const Eigen::MatrixXd factor =
      Eigen::MatrixXd::NullaryExpr(n, n, [&] { return random_vector(1, random)[0]; });
  const Eigen::MatrixXd A = factor * factor.transpose() + Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd border(n, 2);
  border << random_vector(n, random), random_vector(n, random);
  const Eigen::VectorXd balance = border.transpose() * random_vector(n, random).cwiseAbs();
  return bordered_lcp(dense_lcp(A, random_vector(n, random)), border, balance);
}

TEST(BorderedLcp, HasOneMatrixHoweverItIsAskedFor) {
  std::mt19937 random(4);
  const Lcp lcp = random_bordered(6, random);
  std::vector<int> all(10);
  std::iota(all.begin(), all.end(), 0);
  const Eigen::MatrixXd M = lcp.matrix->submatrix(all, all);
  EXPECT_EQ(M.bottomRightCorner(4, 4).norm(), 0.0);
  EXPECT_EQ(M.topRightCorner(6, 4), -M.bottomLeftCorner(4, 6).transpose());
  const Eigen::VectorXd z = random_vector(10, random);
  EXPECT_LE((*lcp.matrix * z - M * z).norm(), 1e-13);
  const std::vector<int> columns{7, 1, 9, 4, 2};
  for (const int first : {0, 3, 6, 8}) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(10 - first);
    lcp.matrix->add_columns(columns, z.data(), first, sum);
    EXPECT_LE((sum - M(all, columns).bottomRows(10 - first) * z.head(5)).norm(), 1e-13) << first;
  }
  const std::vector<int> one{7};
  EXPECT_EQ(lcp.matrix->submatrix(all, one), M.col(7));
  EXPECT_EQ(lcp.matrix->submatrix(one, columns), M(one, columns));
}

TEST(BorderedLcp, BoundsAreThoseOfItsRows) {
  std::mt19937 random(5);
  constexpr int kNodes = 600;
  std::vector<Eigen::MatrixXcd> symbol;
  for (int n = 0; n <= kNodes / 2; ++n)
    symbol.emplace_back(Eigen::MatrixXcd::Constant(1, 1, 1.0 / (1.0 + n * n)));
  const Lcp lcp =
      bordered_lcp(periodic_lcp(BlockCirculant(kNodes, symbol, 1.0), random_vector(kNodes, random)),
                   random_vector(kNodes, random), Eigen::VectorXd::Ones(1));
  const auto bounds = lcp.matrix->column_bounds();
  ASSERT_TRUE(bounds);
  const std::vector<int> columns{3, 4, 200, kNodes, kNodes + 1};
  const Eigen::VectorXd weights = random_vector(5, random);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(kNodes + 2);
  lcp.matrix->add_columns(columns, weights.data(), 0, sum);
  Eigen::VectorXd bound = Eigen::VectorXd::Zero(std::ssize(bounds->starts()) - 1);
  bounds->add(columns, weights.data(), bound);
  ASSERT_EQ(bounds->starts().back(), kNodes + 2);
  for (Eigen::Index s = 0; s < bound.size(); ++s) {
    const int first = bounds->starts()[static_cast<std::size_t>(s)];
    const int end = bounds->starts()[static_cast<std::size_t>(s) + 1];
    EXPECT_LE(sum.segment(first, end - first).lpNorm<Eigen::Infinity>(), bound[s] + 1e-12);
  }
}

// Both ways end where the balance holds and the contacts are complementary.
TEST(BorderedLcp, IsSolvedByPivotsAndByNewtonFromThere) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 40; ++trial) {
    const Lcp lcp = random_bordered(7, random);
    const LcpResult pivoted = solve_by_pivoting(lcp);
    ASSERT_EQ(pivoted.status, LcpStatus::solved) << trial;
    const Eigen::VectorXd w = lcp.offset + *lcp.matrix * pivoted.z;
    EXPECT_LE(w.tail(4).lpNorm<Eigen::Infinity>(), 1e-9);
    EXPECT_GE(w.minCoeff(), -1e-9);
    const LcpResult newton =
        solve_by_newton(lcp, {}, with_free_unknowns(lcp, pivoted.z.head(lcp.contact_unknowns())));
    EXPECT_EQ(newton.status, LcpStatus::solved) << trial;
    EXPECT_LE((free_unknowns(lcp, newton.z) - free_unknowns(lcp, pivoted.z)).norm(), 1e-8) << trial;
  }
}

TEST(BorderedLcp, PressesThroughoutWhereTheBalanceAsksForIt) {
  const Lcp lcp = bordered_lcp(dense_lcp(Eigen::Matrix2d::Identity(), Eigen::Vector2d(5.0, 5.5)),
                               Eigen::VectorXd::Ones(2), Eigen::VectorXd::Constant(1, 3.0));
  const auto pressed = permanent_contact(lcp, 1e-10);
  ASSERT_TRUE(pressed);
  EXPECT_NEAR(pressed->z.head(2).sum(), 3.0, 1e-14);
  EXPECT_NEAR(pressed->z[0] - pressed->z[1], 0.5, 1e-14);
}

}  // namespace
}  // namespace signorini::bordered_lcp_test
