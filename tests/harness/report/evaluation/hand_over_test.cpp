#include "harness/report/evaluation/hand_over.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini::hand_over_test {
namespace {

Record timed(const std::string& scene, const std::string& method, double seconds, Measure exchange) {
  Record record = test::good_record(scene, method, "n=1", 1e-3, seconds);
  record.seconds->exchange = exchange;
  return record;
}

TEST(HandOver, IsOfCommandsThatTellTheirOwnTimeTheMedianOfBoth) {
  std::vector<Record> records{timed("a", "command", 1.0, 0.5), timed("b", "command", 2.0, 0.25),
                              timed("c", "command", 9.0, 0.125), timed("a", "ours", 1.0, {})};
  records.push_back(timed("d", "command", 0.0, 0.0));
  records.back().seconds.reset();  // a case without times
  const std::vector<HandOver> found = hand_overs(Evaluation(records));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].configuration, "command");
  EXPECT_EQ(found[0].cases, 3);
  EXPECT_EQ(found[0].own, 2.0);
  EXPECT_EQ(found[0].beside, 0.25);
}

TEST(HandOver, IsNothingWhereNoMethodIsACommand) {
  EXPECT_TRUE(hand_overs(Evaluation(test::records_of_two_methods())).empty());
  EXPECT_TRUE(hand_overs(Evaluation({})).empty());
}

}  // namespace
}  // namespace signorini::hand_over_test
