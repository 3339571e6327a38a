#include "harness/report/evaluation/cost_axis.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(TimeAxis, IsTheMedianTimeIfTheRunWasTimed) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.25);
  EXPECT_EQ(time_axis().cost(record), 0.25);
  EXPECT_EQ(time_axis().unit, "s");
  record.seconds.reset();
  EXPECT_FALSE(time_axis().cost(record).has_value());
}

TEST(WorkAxes, AreTheCountsThatAMethodGives) {
  const Record record = test::full_record();  // counts 1 to 5, each once
  std::set<double> costs;
  for (const CostAxis& axis : work_axes()) costs.insert(axis.cost(record).value());
  EXPECT_EQ(costs, (std::set<double>{1.0, 2.0, 3.0, 4.0, 5.0}));
  EXPECT_EQ(work_axes()[0].name, "pivots");
  EXPECT_EQ(work_axes()[0].cost(record), 3.0);
  for (const CostAxis& axis : work_axes()) EXPECT_FALSE(axis.cost(Record{}).has_value()) << axis.name;
}

}  // namespace
}  // namespace signorini
