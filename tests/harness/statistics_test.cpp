#include "harness/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace signorini::statistics_test {
namespace {

TEST(Median, IsTheMiddleOfASortedSample) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const std::size_t size : {1U, 2U, 7U, 100U}) {
    std::vector<double> values(size);
    for (double& value : values) value = uniform(random);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(median(values), 0.5 * (sorted[(size - 1) / 2] + sorted[size / 2])) << size;
  }
}

// The mean of n independent numbers of variance 1 / 3 has the deviation 1 / sqrt(3 n), and batches do not
// change it; what chance makes of the correlation of neighbours widens the error by a tenth.
TEST(BatchMean, KnowsTheErrorOfItsValue) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  constexpr int kTrials = 400, kSize = 1000;
  int inside = 0;
  double width = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values(kSize);
    for (double& value : values) value = 0.25 + uniform(random);
    const Estimate mean = batch_mean(values);
    width += mean.error / kTrials;
    inside += std::abs(mean.value - 0.25) <= mean.error ? 1 : 0;
  }
  EXPECT_NEAR(inside, 0.95 * kTrials, 20.0);
  EXPECT_NEAR(width, 1.1 * 2.093 / std::sqrt(3.0 * kSize), 0.1 * 2.093 / std::sqrt(3.0 * kSize));
  EXPECT_EQ(batch_mean({2.0}).error, 0.0);
}

// x_n = f x_(n-1) + e_n, of noise with variance 1: the mean of N values has the deviation 1 / ((1 - f)
// sqrt(N)) for N (1 - f) large. A batch of 180 is twice, or once, as long as the sequence remembers: errors
// of batches taken as independent hold the mean in 86 and 76 % of the trials.
TEST(BatchMean, HoldsTheMeanOfASequenceThatRemembersAsLongAsABatch) {
  std::mt19937 random(23);
  std::normal_distribution<double> noise;
  constexpr int kTrials = 400, kSize = 3600;
  for (const double memory : {0.0, 20.0, 90.0, 180.0}) {
    const double factor = memory > 0.0 ? std::exp(-1.0 / memory) : 0.0;
    const double deviation = 1.0 / ((1.0 - factor) * std::sqrt(kSize));
    int inside = 0;
    double width = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      std::vector<double> values(kSize);
      double x = noise(random) / std::sqrt(1.0 - factor * factor);
      for (double& value : values) value = x = factor * x + noise(random);
      const Estimate mean = batch_mean(values);
      width += mean.error / kTrials;
      inside += std::abs(mean.value) <= mean.error ? 1 : 0;
    }
    EXPECT_NEAR(inside, 0.94 * kTrials, 0.04 * kTrials) << memory;
    EXPECT_NEAR(width, 1.96 * deviation, 0.25 * 1.96 * deviation) << memory;
  }
}

// Oracle: samples drawn at random, as the bootstrap is usually done.
TEST(BootstrapMedian, IsWhatSamplesDrawnAtRandomTendTo) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (const std::size_t n : {7U, 11U, 27U}) {
    std::vector<double> values(n);
    for (double& value : values) value = normal(random);
    std::uniform_int_distribution<std::size_t> place(0, n - 1);
    std::vector<double> medians(20000);
    for (double& middle : medians) {
      std::vector<double> sample(n);
      for (double& value : sample) value = values[place(random)];
      middle = median(sample);
    }
    std::ranges::sort(medians);
    const Interval found = bootstrap_median(values);
    EXPECT_EQ(found.low, medians[500]) << n;
    EXPECT_EQ(found.high, medians[19499]) << n;
  }
}

// The ends are values of the sample: of 12 the 3rd and the 10th, between which the population's median lies
// with the probability 96.1 % (binomial); of 21 the 7th and the 15th, 92.2 %.
TEST(BootstrapMedian, HoldsTheMedianOfThePopulationAboutNineteenTimesOfTwenty) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(2.0, 1.0);
  constexpr int kTrials = 2000;
  for (const auto& [n, share] : {std::pair<std::size_t, double>{12, 0.961}, {21, 0.922}}) {
    int inside = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      std::vector<double> values(n);
      for (double& value : values) value = normal(random);
      const Interval found = bootstrap_median(values);
      inside += found.low <= 2.0 && 2.0 <= found.high ? 1 : 0;
    }
    EXPECT_NEAR(inside, share * kTrials, 0.02 * kTrials) << n;
  }
}

TEST(BootstrapMedian, TakesFailuresAsInfiniteTimes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(bootstrap_median({3.0}).low, 3.0);
  EXPECT_EQ(bootstrap_median({3.0}).high, 3.0);
  EXPECT_EQ(bootstrap_median({1.0, 1.0, 1.0, kInfinity, kInfinity}).low, 1.0);
  EXPECT_EQ(bootstrap_median({1.0, 1.0, 1.0, kInfinity, kInfinity}).high, kInfinity);
}

TEST(Median, TakesFailuresAsInfiniteTimes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median({1.0, kInfinity, 2.0}), 2.0);
  EXPECT_EQ(median({1.0, kInfinity}), kInfinity);
  EXPECT_EQ(median({kInfinity, kInfinity}), kInfinity) << "the mean of two infinite values is none";
}

TEST(MedianDeviation, IsHalfTheSpreadOfThreeEquidistantValuesAndIgnoresAnOutlier) {
  EXPECT_EQ(median_deviation({1.0, 2.0, 3.0}), 1.0);
  EXPECT_EQ(median_deviation({5.0}), 0.0);
  EXPECT_EQ(median_deviation({1.0, 2.0, 3.0, 4.0, 1e9}), 1.0);
}

TEST(MedianDeviation, OfANormalSampleIsThatOfTheDistribution) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(3.0, 2.0);
  std::vector<double> values(20001);
  for (double& value : values) value = normal(random);
  // 0.67449 standard deviations; the standard error of the estimate is 1.17 / sqrt(n) of it.
  EXPECT_NEAR(median_deviation(values), 2.0 * 0.67449, 4.0 * 2.0 * 0.67449 * 1.17 / std::sqrt(20001.0));
}

// Tabulated for Wilson's interval: 1 of 10 is 1.79 to 40.4 %, 0 of 10 ends at 27.8 % [newcombe1998].
TEST(Proportion, IsWilsonsInterval) {
  EXPECT_NEAR(proportion(1, 10).low, 0.0179, 5e-5);
  EXPECT_NEAR(proportion(1, 10).high, 0.4042, 5e-5);
  EXPECT_EQ(proportion(0, 10).low, 0.0);
  EXPECT_NEAR(proportion(0, 10).high, 0.2775, 5e-5);
  EXPECT_EQ(proportion(10, 10).high, 1.0);
  EXPECT_NEAR(proportion(81, 263).low, 0.2553, 5e-5);
  EXPECT_NEAR(proportion(81, 263).high, 0.3662, 5e-5);
}

// By counting all signs in another program; the first are Darwin's plants, for which R's wilcox.test says the
// same.
TEST(SignedRanks, CountAllSigns) {
  EXPECT_NEAR(signed_rank_probability({6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75}),
              0.041259765625, 1e-15);
  EXPECT_NEAR(signed_rank_probability({1, 1, 2, 2, -1, 3, 3, 3, 0}), 0.03125, 1e-15);
  EXPECT_NEAR(signed_rank_probability({1, 2, 3, 4, std::numeric_limits<double>::infinity()}), 0.0625, 1e-15);
  EXPECT_EQ(signed_rank_probability({0.0}), 1.0);
}

TEST(SignedRanks, AreNormalWhereThereAreMany) {
  std::vector<double> differences;
  for (int i = 1; i <= 200; ++i) differences.push_back(i % 5 == 0 ? -i : i % 2 == 0 ? i : -0.9 * i);
  const double exact = signed_rank_probability(differences);
  differences.push_back(0.5);
  EXPECT_NEAR(signed_rank_probability(differences), exact, 0.02);
}

TEST(CorrectedProbabilities, AreHolms) {
  const std::vector<double> corrected = corrected_probabilities({0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected{0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(corrected[i], expected[i], 1e-15);
}

}  // namespace
}  // namespace signorini::statistics_test
