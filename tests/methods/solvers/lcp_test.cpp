// The complementarity solvers against an oracle that shares no code with them: every active set tried.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <Eigen/LU>
#include <random>

#include "methods/complementarity/forms.hpp"
#include "methods/solvers/complementarity_solver.hpp"
#include "methods/solvers/newton.hpp"
#include "methods/solvers/pivoting.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

/// All z >= 0 with q + A z >= 0 and z^T (q + A z) = 0, by trying the 2^m active sets.
std::vector<Eigen::VectorXd> enumerate_solutions(const Eigen::MatrixXd& a, const Eigen::VectorXd& q) {
  const auto size = static_cast<int>(q.size());
  std::vector<Eigen::VectorXd> solutions;
  for (unsigned set = 0; set < (1U << size); ++set) {
    std::vector<int> active;
    for (int i = 0; i < size; ++i) {
      if ((set >> i & 1U) != 0) active.push_back(i);
    }
    Eigen::VectorXd z = Eigen::VectorXd::Zero(size);
    if (!active.empty()) {
      const Eigen::FullPivLU<Eigen::MatrixXd> lu(a(active, active));
      if (!lu.isInvertible()) continue;
      z(active) = lu.solve(-q(active));
    }
    const Eigen::VectorXd w = q + a * z;
    if (z.minCoeff() >= -1e-11 && w.minCoeff() >= -1e-11 * q.norm()) solutions.push_back(z);
  }
  return solutions;
}

/// One sample of m contacts is a block-circulant matrix without any structure.
Lcp dense_lcp(const Eigen::MatrixXd& a, const Eigen::VectorXd& q) {
  return {BlockCirculant(1, {a.cast<std::complex<double>>()}), q};
}

Eigen::MatrixXd random_p_matrix(int size, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd g(size, size);
  Eigen::MatrixXd skew(size, size);
  for (double& x : g.reshaped()) x = normal(random);
  for (double& x : skew.reshaped()) x = normal(random);
  // Positive definite symmetric part: every principal minor is positive.
  return g * g.transpose() / size + 0.1 * Eigen::MatrixXd::Identity(size, size) + (skew - skew.transpose());
}

Eigen::VectorXd random_vector(int size, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd q(size);
  for (double& x : q) x = normal(random);
  return q;
}

TEST(SolveByPivoting, MatchesExhaustiveEnumerationOnRandomPMatrices) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int size = 2 + trial % 9;
    const Eigen::MatrixXd a = random_p_matrix(size, random);
    const Eigen::VectorXd q = random_vector(size, random);
    const auto solutions = enumerate_solutions(a, q);
    ASSERT_EQ(solutions.size(), 1U);
    Lcp lcp = dense_lcp(a, q);
    const LcpResult result = solve_by_pivoting(lcp);
    ASSERT_EQ(result.status, LcpStatus::solved) << describe(result.status);
    EXPECT_LE((result.z - solutions.front()).norm(), 1e-9 * (1.0 + solutions.front().norm()));
  }
}

TEST(SolveByPivoting, FindsOneOfTheSolutionsOfRandomIndefiniteMatricesOrSaysRay) {
  std::mt19937 random(2);
  int solved = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Eigen::MatrixXd a(6, 6);
    for (double& x : a.reshaped()) x = std::normal_distribution<double>()(random);
    a.diagonal().array() += 2.0;
    const Eigen::VectorXd q = random_vector(6, random);
    Lcp lcp = dense_lcp(a, q);
    const LcpResult result = solve_by_pivoting(lcp);
    if (result.status == LcpStatus::solved) {
      ++solved;
      const auto solutions = enumerate_solutions(a, q);
      const auto near = [&](const Eigen::VectorXd& z) {
        return (z - result.z).norm() <= 1e-7 * (1.0 + z.norm());
      };
      EXPECT_TRUE(std::any_of(solutions.begin(), solutions.end(), near)) << "trial " << trial;
    } else {
      EXPECT_EQ(result.status, LcpStatus::ray) << describe(result.status);
    }
  }
  EXPECT_GT(solved, 150);
}

TEST(SolveByPivoting, ReportsARayWhereNoSolutionExists) {
  // w = -1 - z is negative for every z >= 0.
  Lcp lcp = dense_lcp(Eigen::MatrixXd::Constant(1, 1, -1.0), Eigen::VectorXd::Constant(1, -1.0));
  EXPECT_EQ(solve_by_pivoting(lcp).status, LcpStatus::ray);
}

TEST(SolveByPivoting, AnOpenGapNeedsNoPivot) {
  std::mt19937 random(3);
  Lcp lcp = dense_lcp(random_p_matrix(4, random), Eigen::VectorXd::Constant(4, 0.5));
  const LcpResult result = solve_by_pivoting(lcp);
  EXPECT_EQ(result.status, LcpStatus::solved);
  EXPECT_EQ(result.pivots, 0);
  EXPECT_EQ(result.z, Eigen::VectorXd::Zero(4));
}

TEST(SolveByPivoting, SeparatesTiesOfACompletelySymmetricProblem) {
  // Every sample closes at once: a constant load on a circulant.
  Eigen::MatrixXcd stiffness(1, 1);
  stiffness << 1.0;
  Lcp lcp{BlockCirculant(64, std::vector<Eigen::MatrixXcd>(33, stiffness)),
          Eigen::VectorXd::Constant(64, -2.0)};
  const LcpResult result = solve_by_pivoting(lcp);
  ASSERT_EQ(result.status, LcpStatus::solved);
  EXPECT_LE((result.z - Eigen::VectorXd::Constant(64, 2.0)).norm(), 1e-12 * 16);
  EXPECT_LE(result.pivots, 65);
}

TEST(SolveByPivoting, AnswerDoesNotDependOnTheCoverForPMatrices) {
  std::mt19937 random(4);
  const Eigen::MatrixXd a = random_p_matrix(8, random);
  Lcp lcp = dense_lcp(a, random_vector(8, random));
  const Eigen::VectorXd expected = solve_by_pivoting(lcp).z;
  for (int k = 0; k < 20; ++k) {
    PivotingOptions options;
    options.cover = random_vector(8, random).cwiseAbs() + Eigen::VectorXd::Constant(8, 0.1);
    const LcpResult result = solve_by_pivoting(lcp, options);
    ASSERT_EQ(result.status, LcpStatus::solved);
    EXPECT_LE((result.z - expected).norm(), 1e-10 * (1.0 + expected.norm()));
  }
}

TEST(SolveByPivoting, WarmStartAtTheSolutionIsConfirmedWithoutPivots) {
  std::mt19937 random(5);
  Lcp lcp = dense_lcp(random_p_matrix(8, random), random_vector(8, random));
  PivotingOptions options;
  options.guess = solve_by_pivoting(lcp).z;
  const LcpResult result = solve_by_pivoting(lcp, options);
  EXPECT_EQ(result.status, LcpStatus::solved);
  EXPECT_EQ(result.pivots, 0);
  EXPECT_LE((result.z - options.guess).norm(), 1e-12 * (1.0 + options.guess.norm()));
}

TEST(SolveByPivoting, WarmStartFromANearbyProblemReachesTheSolution) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd a = random_p_matrix(10, random);
    const Eigen::VectorXd q = random_vector(10, random);
    Lcp before = dense_lcp(a, q + 0.3 * random_vector(10, random));
    Lcp lcp = dense_lcp(a, q);
    PivotingOptions options;
    options.guess = solve_by_pivoting(before).z;
    const LcpResult result = solve_by_pivoting(lcp, options);
    ASSERT_EQ(result.status, LcpStatus::solved) << "trial " << trial << ": " << describe(result.status);
    EXPECT_LE((result.z - solve_by_pivoting(lcp).z).norm(), 1e-9 * (1.0 + result.z.norm()));
  }
}

TEST(SolveByPivoting, StopsAtItsPivotLimit) {
  std::mt19937 random(7);
  Lcp lcp = dense_lcp(random_p_matrix(9, random), Eigen::VectorXd::Constant(9, -1.0));
  PivotingOptions options;
  options.max_pivots = 2;
  const LcpResult result = solve_by_pivoting(lcp, options);
  EXPECT_EQ(result.status, LcpStatus::limit);
  EXPECT_EQ(result.pivots, 2);
}

TEST(SolveByPivoting, RefusesNumbersThatAreNotFinite) {
  Lcp lcp = dense_lcp(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1.0, std::nan("")));
  const LcpResult result = solve_by_pivoting(lcp);
  EXPECT_EQ(result.status, LcpStatus::breakdown);
  EXPECT_TRUE(std::isinf(result.residual));
}

TEST(SolveByNewton, MatchesExhaustiveEnumerationWhereItConverges) {
  std::mt19937 random(8);
  int solved = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::MatrixXd a = random_p_matrix(7, random);
    const Eigen::VectorXd q = random_vector(7, random);
    Lcp lcp = dense_lcp(a, q);
    const LcpResult result = solve_by_newton(lcp);
    if (result.status != LcpStatus::solved) continue;
    ++solved;
    EXPECT_LE((result.z - enumerate_solutions(a, q).front()).norm(), 1e-9 * (1.0 + result.z.norm()));
  }
  EXPECT_GT(solved, 60);
}

TEST(SolveByNewton, NeedsOneStepFromTheRightActiveSet) {
  std::mt19937 random(9);
  Lcp lcp = dense_lcp(random_p_matrix(8, random), random_vector(8, random));
  NewtonOptions options;
  options.guess = 3.0 * solve_by_pivoting(lcp).z;
  const LcpResult result = solve_by_newton(lcp, options);
  EXPECT_EQ(result.status, LcpStatus::solved);
  EXPECT_LE(result.iterations, 2);
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
    Lcp lcp{BlockCirculant(16, symbol), random_vector(16, random)};
    const bool one = solve_lcp(lcp, {.solver = ComplementaritySolver::pivoting}).status == LcpStatus::solved;
    const bool several =
        solve_lcp(lcp, {.solver = ComplementaritySolver::automatic}).status == LcpStatus::solved;
    EXPECT_TRUE(several || !one);
    more += several && !one ? 1 : 0;
  }
  EXPECT_GT(more, 0);
}

long peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024L;
}

TEST(SolveByPivoting, MemoryGrowsWithTheActiveSetNotWithTheSquareOfTheGrid) {
  // A rigid one-impact scene at N = 8192: the N x N array alone would take 512 MiB.
  constexpr int kSamples = 8192;
  const Problem problem =
      test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0});
  const ContactReceptance receptance = fourier_receptance(problem, 256);
  Lcp lcp =
      projected_lcp(receptance, contact_gaps(problem), lipschitz_law(problem, {}, receptance), kSamples);
  const long before = peak_memory_bytes();
  const LcpResult result = solve_by_pivoting(lcp);
  ASSERT_EQ(result.status, LcpStatus::solved);
  const long active = (result.z.array() > 0.0).count();
  EXPECT_LT(active, 400);
  // Lags 2 N, a dozen vectors of N, and two square arrays of twice the largest active set met.
  EXPECT_LT(peak_memory_bytes() - before, 64L << 20);
}

}  // namespace
}  // namespace signorini
