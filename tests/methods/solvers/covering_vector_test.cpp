#include "methods/solvers/covering_vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "methods/solvers/small_lcp.hpp"
#include "tests/support/random_lcp.hpp"

namespace signorini {
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

}  // namespace
}  // namespace signorini
