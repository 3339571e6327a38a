#include <gtest/gtest.h>

#include "harness/compare/comparison.hpp"

namespace signorini::noise_test {
namespace {

TEST(JudgeCases, JudgesNoCaseByTooFewRoundsOrWithoutAnySpread) {
  const auto verdict = [](int rounds, double mad) {
    const Seconds fast{.median = 1.0, .min = 1.0, .mad = mad, .repetitions = rounds};
    const Seconds slow{.median = 10.0, .min = 10.0, .mad = mad, .repetitions = rounds};
    const std::vector<TimePair> pairs{{.case_id = "s/m[n=1]", .method = "m", .before = fast, .after = slow}};
    return judge_cases(pairs).front();
  };
  EXPECT_EQ(verdict(3, 0.01), TimeChange::slower);
  EXPECT_EQ(verdict(2, 0.01), TimeChange::none);
  EXPECT_EQ(verdict(1, 0.0), TimeChange::none);
  EXPECT_EQ(verdict(5, 0.0), TimeChange::none);
}

TEST(BinomialTail, IsThatOfFairCoins) {
  EXPECT_NEAR(binomial_tail(4, 4), 1.0 / 16.0, 1e-12);
  EXPECT_NEAR(binomial_tail(4, 3), 5.0 / 16.0, 1e-12);
  EXPECT_NEAR(binomial_tail(4, 0), 1.0, 1e-12);
}

TEST(NormalQuantile, IsThatOfTheTables) {
  EXPECT_NEAR(normal_quantile(0.05), 1.959963985, 1e-8);
  EXPECT_NEAR(normal_quantile(0.01), 2.575829304, 1e-8);
}

}  // namespace
}  // namespace signorini::noise_test
