#include "methods/solvers/newton.hpp"

#include <gtest/gtest.h>

#include <random>

#include "methods/solvers/pivoting.hpp"
#include "methods/solvers/small_lcp.hpp"
#include "tests/support/random_lcp.hpp"

namespace signorini {
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
  NewtonOptions options;
  options.guess = 3.0 * solve_by_pivoting(lcp).z;
  const LcpResult result = solve_by_newton(lcp, options);
  EXPECT_EQ(result.status, LcpStatus::solved);
  EXPECT_LE(result.iterations, 2);
}

}  // namespace
}  // namespace signorini
