#include "harness/report/evaluation/ladder.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

Record run(const std::string& case_id) {
  Record record;
  record.case_id = case_id;
  record.method = case_id.substr(case_id.find('/') + 1);
  return record;
}

TEST(ContestantOf, KeepsWordsAndDropsTheNumbersOfTheLadder) {
  EXPECT_EQ(contestant_of(run("s/event-driven[flow=cvode,tolerance=1e-6]")), "event-driven[flow=cvode]");
  EXPECT_EQ(contestant_of(run("s/event-driven[tolerance=1e-6,flow=modal]")), "event-driven[flow=modal]");
  EXPECT_EQ(contestant_of(run("s/hat-lcp[samples=64]")), "hat-lcp");
  EXPECT_EQ(contestant_of(run("s/penalty-hbm[penalty=100x,plain=true,harmonics=5]")),
            "penalty-hbm[penalty=100x,plain=true]");
  EXPECT_EQ(contestant_of(run("s/hat-lcp")), "hat-lcp");
  EXPECT_EQ(contestant_of(run("s/hat-lcp[samples=64,start=0.1]")), "hat-lcp[start=0.1]");
}

TEST(RungOf, CreditsOnlyWhatTheHarnessItselfHasCertified) {
  const Record good = test::good_record("s", "m", "n=1", 0.1, 1.0);
  EXPECT_EQ(rung_of(good).error, 0.1);
  // A fast wrong answer: the method says converged, the harness disagrees.
  Record liar = good;
  liar.status = Status::inaccurate;
  EXPECT_FALSE(rung_of(liar).error);
  Record uncertified = good;
  uncertified.certificate.status = CertificateStatus::uncertified;
  EXPECT_FALSE(rung_of(uncertified).error);
  Record elsewhere = good;
  elsewhere.certificate.same_orbit = false;
  EXPECT_FALSE(rung_of(elsewhere).error);
  Record without_reference = good;
  without_reference.certificate.same_orbit.reset();
  EXPECT_EQ(rung_of(without_reference).error, 0.1);
}

TEST(RungOf, BoundsErrorsByTenErrorBarsInsteadOfRankingThem) {
  Record record = test::good_record("s", "m", "n=1", 1e-15, 1.0);
  record.certificate.error_bar = 1e-12;
  const Rung rung = rung_of(record);
  EXPECT_TRUE(rung.bounded);
  EXPECT_DOUBLE_EQ(*rung.error, 1e-11);
}

TEST(LaddersOf, SetMethodsOfAnotherLawApart) {
  std::vector<Record> records{
      test::good_record("s", "a", "n=1", 0.1, 1.0), test::good_record("s", "a", "n=2", 0.01, 2.0),
      test::good_record("s", "b", "n=1", 0.1, 1.0), test::good_record("s", "c", "n=1", 0.1, 1.0)};
  records[2].law_matches_scene = false;
  records[3].status = Status::not_applicable;
  const std::vector<Ladder> ladders = ladders_of(records);
  ASSERT_EQ(ladders.size(), 3U);
  EXPECT_EQ(ladders[0].rungs.size(), 2U);
  EXPECT_EQ(ladders[0].standing, Standing::competes);
  EXPECT_EQ(ladders[1].standing, Standing::another_law);
  EXPECT_EQ(ladders[2].standing, Standing::not_applicable);
}

}  // namespace
}  // namespace signorini
