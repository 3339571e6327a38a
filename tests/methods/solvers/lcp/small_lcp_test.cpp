#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini::small_lcp_test {
namespace {

// Oracle: every active set is tried.
Eigen::VectorXd by_enumeration(const Eigen::MatrixXd& A, const Eigen::VectorXd& q,
                               const std::vector<bool>& held) {
  const auto size = static_cast<unsigned>(q.size());
  for (unsigned set = 0; set < (1U << size); ++set) {
    std::vector<int> basis;
    bool allowed = true;
    for (unsigned i = 0; i < size; ++i) {
      if ((set >> i & 1U) != 0)
        basis.push_back(static_cast<int>(i));
      else if (held[i])
        allowed = false;
    }
    if (!allowed) continue;
    Eigen::VectorXd z = Eigen::VectorXd::Zero(q.size());
    if (!basis.empty()) {
      const Eigen::MatrixXd block = A(basis, basis);
      const Eigen::VectorXd right = -q(basis);
      const Eigen::VectorXd part = lu_solve(block, right);
      z(basis) = part;
    }
    const Eigen::VectorXd w = A * z + q;
    bool feasible = true;
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      if (held[static_cast<std::size_t>(i)]) continue;
      feasible = feasible && z[i] >= -1e-12 && w[i] >= -1e-12;
    }
    if (feasible) return z;
  }
  return Eigen::VectorXd::Constant(q.size(), std::numeric_limits<double>::quiet_NaN());
}

TEST(SolveSmallLcp, MatchesExhaustiveEnumerationOnRandomPositiveDefiniteMatrices) {
  std::mt19937 random(20240517);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Index size = 1 + trial % 8;
    const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
    const Eigen::MatrixXd A = B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
    std::vector<bool> held(static_cast<std::size_t>(size), false);
    if (trial % 3 == 0) held[0] = true;
    const auto z = solve_small_lcp(A, q, held);
    ASSERT_TRUE(z);
    const Eigen::VectorXd expected = by_enumeration(A, q, held);
    EXPECT_LT((*z - expected).norm(), 1e-9 * (1.0 + expected.norm())) << "trial " << trial;
  }
}

// Stops that depend on each other: w = A z + q is unique, z is not. Forty contacts on a few masses.
TEST(SolveSmallLcp, SolvesSingularProblemsOfManyContacts) {
  std::mt19937 random(20250303);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 60; ++trial) {
    const Eigen::Index size = 5 + 5 * (trial % 8), rank = 1 + trial % 6;
    Eigen::MatrixXd W = Eigen::MatrixXd::NullaryExpr(rank, size, [&] { return normal(random); });
    W.col(size - 1) = W.col(0);  // one stop twice
    const Eigen::MatrixXd A = W.transpose() * W;
    // Solvable: some motion of the masses satisfies all stops.
    const Eigen::VectorXd motion = Eigen::VectorXd::NullaryExpr(rank, [&] { return normal(random); });
    const Eigen::VectorXd margin =
        Eigen::VectorXd::NullaryExpr(size, [&] { return std::abs(normal(random)); });
    const Eigen::VectorXd q = W.transpose() * motion + margin;
    const auto z = solve_small_lcp(A, q, std::vector<bool>(static_cast<std::size_t>(size), false));
    ASSERT_TRUE(z) << "trial " << trial;
    const Eigen::VectorXd w = A * *z + q;
    const double scale = 1e-10 * (q.norm() + A.norm() * z->norm());
    EXPECT_GE(z->minCoeff(), 0.0);
    EXPECT_GE(w.minCoeff(), -scale) << "trial " << trial;
    EXPECT_LE(std::abs(z->dot(w)), scale * (1.0 + z->norm())) << "trial " << trial;
  }
}

TEST(SolveSmallLcp, RefusesContradictoryStops) {
  // One mass between two stops that leave no room for it.
  const Eigen::Matrix2d A = (Eigen::Matrix2d() << 1.0, -1.0, -1.0, 1.0).finished();
  EXPECT_FALSE(solve_small_lcp(A, Eigen::Vector2d(-1.0, -1.0), {false, false}));
}

TEST(SolveSmallLcp, SolvesTheClampedMassWhoseTwoStopsAreTheSameDirection) {
  const Eigen::MatrixXd A = (Eigen::Matrix2d() << 1.0, -1.0, -1.0, 1.0).finished();
  for (const double push : {1.0, -1.0, 0.0}) {
    const auto z = solve_small_lcp(A, Eigen::Vector2d(-push, push), {false, false});
    ASSERT_TRUE(z);
    EXPECT_NEAR((*z)[0] - (*z)[1], push, 1e-14);
    EXPECT_GE(z->minCoeff(), 0.0);
  }
}

}  // namespace
}  // namespace signorini::small_lcp_test
