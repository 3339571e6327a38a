#include "harness/report/evaluation/rivals.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini::rivals_test {
namespace {

Record foreign(Record record) {
  record.plugin = "of somebody";
  return record;
}

Record plain(const std::string& scene, double error, double seconds) {
  Record record = test::good_record(scene, "ours", "n=1,plain=true", error, seconds);
  record.settings = {{"n", "1"}, {"plain", "true"}};
  return record;
}

TEST(Rivals, AreComparedAtEqualErrorOnTheScenesThatBothSolve) {
  const std::vector<Record> records{
      // On a: 4 s against 2 s of ours and 8 s of the plain form, and never 1e-6.
      foreign(test::good_record("a", "theirs", "n=1", 1e-3, 4.0)),
      test::good_record("a", "ours", "n=1", 1e-3, 2.0),
      test::good_record("a", "ours", "n=2", 1e-7, 5.0),
      plain("a", 1e-3, 8.0),
      // On b it is the fastest; the plain form has too large an error.
      foreign(test::good_record("b", "theirs", "n=1", 1e-8, 1.0)),
      test::good_record("b", "ours", "n=1", 1e-8, 10.0),
      plain("b", 0.05, 0.1),
      // c it does not solve.
      foreign(test::good_record("c", "theirs", "n=1", 0.5, 1.0)),
      test::good_record("c", "ours", "n=1", 1e-8, 1.0),
      // d is none of its scenes.
      test::good_record("d", "ours", "n=1", 1e-8, 1.0),
  };
  const std::vector<Rival> found = rivals(Evaluation(records));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].configuration, "theirs");
  const RivalTimes& coarse = found[0].at[0];
  EXPECT_EQ(coarse.scenes, 3);
  EXPECT_EQ(coarse.reached, 2);
  EXPECT_EQ(coarse.to_own, (std::vector<double>{0.1, 2.0}));
  EXPECT_EQ(coarse.to_plain, std::vector<double>{0.5});
  EXPECT_EQ(coarse.fastest, 1);
  const RivalTimes& fine = found[0].at[1];
  EXPECT_EQ(fine.scenes, 3);
  EXPECT_EQ(fine.reached, 1);
  EXPECT_EQ(fine.to_own, std::vector<double>{0.1});
  EXPECT_TRUE(fine.to_plain.empty());
  EXPECT_EQ(fine.fastest, 1);
}

TEST(Rivals, AreComparedPointByPointOfTheirCurvesAndNotWhereNothingTouches) {
  std::vector<Record> records{
      foreign(test::good_record("a", "theirs", "n=1", 1e-3, 4.0)),
      test::good_record("a", "ours", "n=1", 1e-3, 2.0),
      foreign(test::good_record("far-away", "theirs", "n=1", 1e-3, 4.0)),
      test::good_record("far-away", "ours", "n=1", 1e-3, 2.0),
  };
  records[0].work.counts.points = 200;
  records[0].certificate.stable = false;
  for (std::size_t i : {2U, 3U}) records[i].physics.contact_ratio = 0.0;  // and no event
  const RivalTimes times = rivals(Evaluation(records)).at(0).at[0];
  EXPECT_EQ(times.scenes, 1);
  EXPECT_EQ(times.to_own, std::vector<double>{2.0});
  EXPECT_EQ(times.points, std::vector<long>{200});
  EXPECT_EQ(times.per_point, std::vector<double>{0.01});
  EXPECT_EQ(times.unstable, 1);
}

TEST(Rivals, AreNotComparedUnderAnotherLaw) {
  Record other = foreign(test::good_record("a", "theirs", "n=1", 1e-3, 1.0));
  other.law_matches_scene = false;
  EXPECT_TRUE(rivals(Evaluation({other, test::good_record("a", "ours", "n=1", 1e-3, 2.0)})).empty());
}

TEST(Rivals, AreNoneWithoutPlugins) {
  EXPECT_TRUE(rivals(Evaluation(test::records_of_two_methods())).empty());
  EXPECT_TRUE(rivals(Evaluation({})).empty());
}
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
}  // namespace signorini::rivals_test
