#include "harness/responses/response_metric.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/harness/responses/drawn_responses.hpp"

namespace signorini::response_metric_test {
namespace {

using test::moving;

TEST(ResponseMetric, IsTheLargerOfFrequencyAndMotion) {
  const ResponseMetric metric(2.0, 0.5);
  EXPECT_NEAR(metric(moving(1.0, 1.0), moving(1.0, 1.1)), 0.1 / std::sqrt(2.0) / 0.5, 1e-14);
  EXPECT_NEAR(metric(moving(1.0, 1.0), moving(2.0, 1.1)), 0.5, 1e-14);
}

TEST(ResponseMetric, TakesTheContactThatIsFarthest) {
  ResponsePoint a = moving(1.0, 1.0), b = a;
  a.motion.conservativeResize(Eigen::NoChange, 2);
  b.motion.conservativeResize(Eigen::NoChange, 2);
  a.motion.col(1).setZero();
  b.motion.col(1).setConstant(0.25);
  EXPECT_NEAR(ResponseMetric(1.0, 1.0)(a, b), 0.25, 1e-14);
}

TEST(ResponseMetric, KnowsNoOriginOfDisplacements) {
  const ResponseMetric metric(1.0, 1.0);
  const double here = metric(moving(1.0, 1.0), moving(1.0, 1.1));
  EXPECT_NEAR(metric(moving(1.0, 1.0, 1, 0.0, 1e3), moving(1.0, 1.1, 1, 0.0, 1e3)), here, 1e-12);
}

TEST(ResponseMetric, KnowsNoForcingPeriodButThePhaseOfTheLoad) {
  const ResponseMetric metric(1.0, 1.0);
  EXPECT_NEAR(metric(moving(1.0, 1.0, 2, 0.3), moving(1.0, 1.0, 2, -0.3)), 0.0, 1e-14);  // a period later
  EXPECT_GT(metric(moving(1.0, 1.0), moving(1.0, -1.0)), 1.0);                           // half a period
}

// x(t) and 1.1 x(t - s) with any s, between two instants too.
TEST(ResponseMetric, KnowsNoPhaseOfFreeMotions) {
  const ResponseMetric metric(1.0, 1.0, Delays::any);
  for (const double instants : {0.0, 17.0, 64.0, 40.5, 99.3}) {
    ResponsePoint later = moving(1.0, 1.1);
    for (int i = 0; i < kComparedPhases; ++i)
      later.motion(i, 0) = 1.1 * std::cos(2.0 * std::numbers::pi * (i - instants) / kComparedPhases);
    EXPECT_NEAR(metric(moving(1.0, 1.0), later), 0.1 / std::sqrt(2.0), 1e-4) << instants;
    const auto [a, b] = metric.aligned(moving(1.0, 1.0), later);
    EXPECT_LT((a.motion - b.motion).cwiseAbs().maxCoeff(), 0.13) << instants;
  }
}

TEST(ResponseMetric, PutsMotionsOfOtherPeriodsInfinitelyFarAway) {
  EXPECT_EQ(ResponseMetric(1.0, 1.0)(moving(1.0, 1.0), moving(1.0, 1.0, 2, 0.3)),
            std::numeric_limits<double>::infinity());
}

TEST(ResponseMetric, FindsTheLeastPeriod) {
  const ResponseMetric metric(1.0, 1.0);
  EXPECT_EQ(metric.primitive(moving(1.0, 1.0, 4)).order, 1);
  EXPECT_EQ(metric.primitive(moving(1.0, 1.0, 4, 0.3)).order, 2);
  EXPECT_EQ(metric.primitive(moving(1.0, 1.0, 4, 0.3)).motion.rows(), 2 * kComparedPhases);
  EXPECT_EQ(metric.primitive(moving(1.0, 1.0, 2, 1e-4)).order, 1);  // below what is told apart
  EXPECT_EQ(metric.primitive(moving(1.0, 1.0, 3, 0.0)).order, 1);
}

TEST(ResponseMetric, AlignsOverTheLeastCommonPeriod) {
  const ResponseMetric metric(1.0, 1.0);
  const auto [a, b] = metric.aligned(moving(1.0, 1.0, 2, 0.3), moving(1.0, 1.0, 2, -0.3));
  EXPECT_LT((a.motion - b.motion).norm(), 1e-12);
  const auto [c, d] = metric.aligned(moving(1.0, 1.0, 2, 0.3), moving(1.0, 1.0));
  EXPECT_EQ(c.order, 2);
  EXPECT_EQ(d.order, 2);
  EXPECT_EQ(c.motion.rows(), d.motion.rows());
}

}  // namespace
}  // namespace signorini::response_metric_test
