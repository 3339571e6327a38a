#include "methods/solvers/lcp/complementarity_solver.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

#include "methods/discretisation/block_circulant.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "tests/support/random_lcp.hpp"

namespace signorini::complementarity_solver_test {
namespace {

using test::enumerate_solutions;
using test::random_p_matrix;
using test::random_vector;

TEST(SolveByNewton, MatchesExhaustiveEnumerationWhereItConverges) {
  std::mt19937 random(8);
  int solved = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::MatrixXd a = random_p_matrix(7, random);
    const Eigen::VectorXd q = random_vector(7, random);
    const Lcp lcp = dense_lcp(a, q);
    const LcpResult result = solve_by_newton(lcp);
    if (result.status != LcpStatus::solved) continue;
    ++solved;
    EXPECT_LE((result.z - enumerate_solutions(a, q).front()).norm(), 1e-9 * (1.0 + result.z.norm()));
  }
  EXPECT_GT(solved, 60);
}

TEST(SolveByNewton, NeedsOneStepFromTheRightActiveSet) {
  std::mt19937 random(9);
  const Lcp lcp = dense_lcp(random_p_matrix(8, random), random_vector(8, random));
  const LcpResult result = solve_by_newton(lcp, {}, 3.0 * solve_by_pivoting(lcp).z);
  EXPECT_EQ(result.status, LcpStatus::solved);
  EXPECT_LE(result.iterations, 2);
}

using test::random_p_matrix;
using test::random_vector;

TEST(SolveByNewtonFrom, BeginsAtTheIterateGiven) {
  std::mt19937 random(10);
  const Lcp lcp = dense_lcp(random_p_matrix(8, random), random_vector(8, random));
  const LcpResult cold = solve_by_newton(lcp);
  const LcpResult same = solve_by_newton_from(lcp, {}, -lcp.offset);
  EXPECT_EQ(same.iterations, cold.iterations);
  EXPECT_EQ(same.z, cold.z);
  const Eigen::VectorXd z = solve_by_pivoting(lcp).z;
  const Eigen::VectorXd w = lcp.offset + *lcp.matrix * z;
  const LcpResult there = solve_by_newton_from(lcp, {}, z - w);
  EXPECT_EQ(there.status, LcpStatus::solved);
  EXPECT_EQ(there.iterations, 0);
}

TEST(SolveLcp, RestartsWithAnotherCoverWhereTheFirstPathEndsOnARay) {
  // Many random problems: `auto` solves every one that `pivoting` solves, and some more.
  std::mt19937 random(10);
  int more = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Eigen::MatrixXcd symbol0(1, 1);
    std::vector<Eigen::MatrixXcd> symbol;
    for (int n = 0; n <= 8; ++n) {
      symbol0 << std::complex<double>(std::normal_distribution<double>()(random) + 0.8,
                                      n == 0 || n == 8 ? 0.0 : std::normal_distribution<double>()(random));
      symbol.push_back(symbol0);
    }
    const Lcp lcp = periodic_lcp(BlockCirculant(16, symbol), random_vector(16, random));
    const bool one = solve_lcp(lcp, {.solver = ComplementaritySolver::pivoting}).status == LcpStatus::solved;
    const bool several =
        solve_lcp(lcp, {.solver = ComplementaritySolver::automatic}).status == LcpStatus::solved;
    EXPECT_TRUE(several || !one);
    more += several && !one ? 1 : 0;
  }
  EXPECT_GT(more, 0);
}

TEST(SolveLcp, RecognisesPermanentContactWithoutAPivot) {
  std::mt19937 random(11);
  const Eigen::MatrixXd a = random_p_matrix(6, random);
  const Eigen::VectorXd z = random_vector(6, random).cwiseAbs() + Eigen::VectorXd::Ones(6);
  const Eigen::VectorXd q = -a * z;
  const Lcp lcp = dense_lcp(a, q);
  const LcpResult automatic = solve_lcp(lcp, {});
  ASSERT_EQ(automatic.status, LcpStatus::solved);
  EXPECT_LE((automatic.z - z).norm(), 1e-10 * z.norm());
  if (q.maxCoeff() < 0.0) {
    EXPECT_EQ(automatic.pivots, 0);
    EXPECT_GE(solve_lcp(lcp, {.solver = ComplementaritySolver::pivoting}).pivots, 6);
  }
}

TEST(SolveLcp, FollowsAUselessGuessByAColdStartAndCountsBoth) {
  std::mt19937 random(12);
  const Lcp lcp = dense_lcp(random_p_matrix(9, random), -random_vector(9, random).cwiseAbs());
  // Cold, the problem is solved within the limit; from a far guess perhaps not. Either way it is solved.
  const LcpResult cold = solve_lcp(lcp, {.solver = ComplementaritySolver::pivoting});
  ASSERT_EQ(cold.status, LcpStatus::solved);
  const SolverSettings limited{.solver = ComplementaritySolver::pivoting,
                               .max_iterations = static_cast<int>(cold.pivots)};
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd guess = 10.0 * random_vector(9, random).cwiseMax(0.0);
    if (guess.maxCoeff() <= 0.0) continue;
    const LcpResult warm = solve_lcp(lcp, limited, guess);
    ASSERT_EQ(warm.status, LcpStatus::solved);
    EXPECT_LE((warm.z - cold.z).norm(), 1e-9 * (1.0 + cold.z.norm()));
    EXPECT_LE(warm.pivots, 2 * cold.pivots);
  }
}

TEST(SolveLcp, GivesNewtonItsStepsAndCountsThemApart) {
  std::mt19937 random(13);
  const Lcp lcp = dense_lcp(random_p_matrix(8, random), random_vector(8, random));
  const LcpResult result = solve_lcp(lcp, {.solver = ComplementaritySolver::newton, .max_iterations = 1});
  EXPECT_EQ(result.pivots, 0);
  EXPECT_LE(result.iterations, 1);
}

}  // namespace
}  // namespace signorini::complementarity_solver_test
