#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "methods/complementarity/forms.hpp"
#include "methods/discretisation/block_circulant.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "methods/structure/receptance.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/random_lcp.hpp"

namespace signorini::pivoting_test {
namespace {

TEST(SmoothCover, IsOneWavePerPeriodAndContactUpToItsIrregularPart) {
  constexpr int kSamples = 32;
  const Eigen::VectorXd cover = smooth_cover(kSamples, 2, 0.3, 1.1);
  ASSERT_EQ(cover.size(), 2 * kSamples);
  for (int c = 0; c < 2; ++c) {
    for (int i = 0; i < kSamples; ++i) {
      const double wave = 1.0 + 0.3 * std::cos(2.0 * std::numbers::pi * i / kSamples + 1.1);
      EXPECT_NEAR(cover[c * kSamples + i], wave, 1e-9);
    }
  }
}

TEST(SmoothCover, HasNoTwoEqualEntries) {
  Eigen::VectorXd cover = smooth_cover(4096, 2);
  EXPECT_GT(cover.minCoeff(), 0.0);
  std::sort(cover.begin(), cover.end());
  const Eigen::Index last = cover.size() - 1;
  EXPECT_GT((cover.tail(last) - cover.head(last)).minCoeff(), 0.0);
}

TEST(SmoothCover, WithoutAWaveDoesNotDependOnTheDivisionIntoContacts) {
  EXPECT_EQ(smooth_cover(60, 1), smooth_cover(12, 5));
}

TEST(CoverThrough, MakesTheGuessASolutionOfTheRelaxedProblem) {
  std::mt19937 random(21);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd a = test::random_p_matrix(7, random);
    const Eigen::VectorXd q = test::random_vector(7, random);
    const Eigen::VectorXd guess = test::random_vector(7, random);
    const Eigen::VectorXd z = guess.cwiseMax(0.0);
    const Eigen::VectorXd w = q + cover_through(dense_lcp(a, q), guess) + a * z;
    const double scale = q.cwiseAbs().maxCoeff();
    for (int i = 0; i < 7; ++i) {
      if (guess[i] > 0.0)
        EXPECT_NEAR(w[i], 0.0, 1e-13 * (scale + (a * z).norm()));
      else
        EXPECT_GE(w[i], 0.999e-3 * scale);
    }
  }
}

using test::enumerate_solutions;
using test::random_p_matrix;
using test::random_vector;

TEST(SolveByPivoting, MatchesExhaustiveEnumerationOnRandomPMatrices) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int size = 2 + trial % 9;
    const Eigen::MatrixXd a = random_p_matrix(size, random);
    const Eigen::VectorXd q = random_vector(size, random);
    const auto solutions = enumerate_solutions(a, q);
    ASSERT_EQ(solutions.size(), 1U);
    const Lcp lcp = dense_lcp(a, q);
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
    const Lcp lcp = dense_lcp(a, q);
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
  const Lcp lcp = dense_lcp(Eigen::MatrixXd::Constant(1, 1, -1.0), Eigen::VectorXd::Constant(1, -1.0));
  EXPECT_EQ(solve_by_pivoting(lcp).status, LcpStatus::ray);
}

TEST(SolveByPivoting, AnOpenGapNeedsNoPivot) {
  std::mt19937 random(3);
  const Lcp lcp = dense_lcp(random_p_matrix(4, random), Eigen::VectorXd::Constant(4, 0.5));
  const LcpResult result = solve_by_pivoting(lcp);
  EXPECT_EQ(result.status, LcpStatus::solved);
  EXPECT_EQ(result.pivots, 0);
  EXPECT_EQ(result.z, Eigen::VectorXd::Zero(4));
}

TEST(SolveByPivoting, SeparatesTiesOfACompletelySymmetricProblem) {
  // Every sample closes at once: a constant load on a circulant.
  Eigen::MatrixXcd stiffness(1, 1);
  stiffness << 1.0;
  const Lcp lcp = periodic_lcp(BlockCirculant(64, std::vector<Eigen::MatrixXcd>(33, stiffness)),
                               Eigen::VectorXd::Constant(64, -2.0));
  const LcpResult result = solve_by_pivoting(lcp);
  ASSERT_EQ(result.status, LcpStatus::solved);
  EXPECT_LE((result.z - Eigen::VectorXd::Constant(64, 2.0)).norm(), 1e-12 * 16);
  EXPECT_LE(result.pivots, 65);
}

TEST(SolveByPivoting, AnswerDoesNotDependOnTheCoverForPMatrices) {
  std::mt19937 random(4);
  const Eigen::MatrixXd a = random_p_matrix(8, random);
  Lcp lcp = dense_lcp(a, random_vector(8, random));
  lcp.samples = 8;
  const Eigen::VectorXd expected = solve_by_pivoting(lcp).z;
  for (int k = 0; k < 20; ++k) {
    const LcpResult result = solve_by_pivoting(lcp, {.cover_amplitude = 0.95, .cover_phase = 0.3 * k});
    ASSERT_EQ(result.status, LcpStatus::solved);
    EXPECT_LE((result.z - expected).norm(), 1e-10 * (1.0 + expected.norm()));
  }
}

TEST(SolveByPivoting, WarmStartAtTheSolutionIsConfirmedWithoutPivots) {
  std::mt19937 random(5);
  const Lcp lcp = dense_lcp(random_p_matrix(8, random), random_vector(8, random));
  const Eigen::VectorXd guess = solve_by_pivoting(lcp).z;
  const LcpResult result = solve_by_pivoting(lcp, {}, guess);
  EXPECT_EQ(result.status, LcpStatus::solved);
  EXPECT_EQ(result.pivots, 0);
  EXPECT_LE((result.z - guess).norm(), 1e-12 * (1.0 + guess.norm()));
}

TEST(SolveByPivoting, WarmStartFromANearbyProblemReachesTheSolution) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd a = random_p_matrix(10, random);
    const Eigen::VectorXd q = random_vector(10, random);
    const Lcp before = dense_lcp(a, q + 0.3 * random_vector(10, random));
    const Lcp lcp = dense_lcp(a, q);
    const LcpResult result = solve_by_pivoting(lcp, {}, solve_by_pivoting(before).z);
    ASSERT_EQ(result.status, LcpStatus::solved) << "trial " << trial << ": " << describe(result.status);
    EXPECT_LE((result.z - solve_by_pivoting(lcp).z).norm(), 1e-9 * (1.0 + result.z.norm()));
  }
}

TEST(SolveByPivoting, StopsAtItsPivotLimit) {
  std::mt19937 random(7);
  const Lcp lcp = dense_lcp(random_p_matrix(9, random), Eigen::VectorXd::Constant(9, -1.0));
  const LcpResult result = solve_by_pivoting(lcp, {.max_iterations = 2});
  EXPECT_EQ(result.status, LcpStatus::limit);
  EXPECT_EQ(result.pivots, 2);
}

TEST(SolveByPivoting, RefusesNumbersThatAreNotFinite) {
  const Lcp lcp = dense_lcp(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1.0, std::nan("")));
  const LcpResult result = solve_by_pivoting(lcp);
  EXPECT_EQ(result.status, LcpStatus::breakdown);
  EXPECT_TRUE(std::isinf(result.residual));
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
  // Fourier Lipschitz: A_n = c C_n for the harmonics kept, 1 beyond; q = sqrt(c) (g - x_f).
  const ContactReceptance receptance = fourier_receptance(problem, 256);
  const double c = 4.0 / std::abs(receptance.receptance[192](0, 0));
  std::vector<Eigen::MatrixXcd> symbol = receptance.receptance;
  for (Eigen::MatrixXcd& block : symbol) block *= c;
  const Lcp lcp = periodic_lcp(BlockCirculant(kSamples, symbol, 1.0),
                               -free_penetration(receptance.free_response, contact_gaps(problem),
                                                 Eigen::VectorXd::Constant(1, std::sqrt(c)), kSamples));
  const long before = peak_memory_bytes();
  const LcpResult result = solve_by_pivoting(lcp);
  ASSERT_EQ(result.status, LcpStatus::solved);
  const long active = (result.z.array() > 0.0).count();
  EXPECT_LT(active, 400);
  // Lags 2 N, a dozen vectors of N, and two square arrays of twice the largest active set met.
  EXPECT_LT(peak_memory_bytes() - before, 64L << 20);
}

}  // namespace
}  // namespace signorini::pivoting_test
