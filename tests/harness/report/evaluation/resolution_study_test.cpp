#include "harness/report/evaluation/resolution_study.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini::resolution_study_test {
namespace {

/// The error of a record's run.
Measure error_of(const Record& record) { return scored_run(test::results_of({record}).all[0]).error; }

TEST(ScoredRun, HasAnErrorOnlyIfTheHarnessItselfHasCertifiedIt) {
  const Record good = test::good_record("s", "m", "n=1", 0.1, 1.0);
  EXPECT_EQ(error_of(good), 0.1);
  // A fast wrong answer: the method says converged, the harness disagrees.
  Record liar = good;
  liar.status = Status::inaccurate;
  EXPECT_FALSE(error_of(liar));
  Record uncertified = good;
  uncertified.certificate.status = CertificateStatus::uncertified;
  EXPECT_FALSE(error_of(uncertified));
  Record elsewhere = good;
  elsewhere.certificate.same_orbit = false;
  EXPECT_EQ(error_of(elsewhere), 0.1) << "another orbit of the scene solves it too";
  Record without_reference = good;
  without_reference.certificate.same_orbit.reset();
  EXPECT_EQ(error_of(without_reference), 0.1);
}

TEST(ScoredRun, BoundsErrorsByTenErrorBarsInsteadOfRankingThem) {
  Record record = test::good_record("s", "m", "n=1", 1e-15, 1.0);
  record.certificate.error_bar = 1e-12;
  const CaseResults results = test::results_of({record});
  const ScoredRun run = scored_run(results.all[0]);
  EXPECT_TRUE(run.bounded);
  EXPECT_DOUBLE_EQ(*run.error, 1e-11);
}

TEST(ResolutionStudies, SetMethodsOfAnotherLawApart) {
  std::vector<Record> records{
      test::good_record("s", "a", "n=1", 0.1, 1.0), test::good_record("s", "a", "n=2", 0.01, 2.0),
      test::good_record("s", "b", "n=1", 0.1, 1.0), test::good_record("s", "c", "n=1", 0.1, 1.0)};
  records[2].law_matches_scene = false;
  records[3].status = Status::not_applicable;
  const CaseResults results = test::results_of(records);
  const std::vector<ResolutionStudy> studies = resolution_studies(results.all);
  ASSERT_EQ(studies.size(), 3U);
  EXPECT_EQ(studies[0].runs.size(), 2U);
  EXPECT_EQ(studies[0].eligibility, Eligibility::ranked);
  EXPECT_EQ(studies[1].eligibility, Eligibility::another_law);
  EXPECT_EQ(studies[2].eligibility, Eligibility::not_applicable);
}

TEST(ResolutionStudies, TakeTheLawOfAMethodThatDoesNotApplyFromScenesOfTheSameLaw) {
  std::vector<Record> records{test::good_record("s", "a", "n=1", 0.1, 1.0),
                              test::good_record("t", "a", "n=1", 0.1, 1.0),
                              test::good_record("u", "a", "n=1", 0.1, 1.0)};
  records[0].law_matches_scene = false;
  for (const std::size_t i : {0U, 1U}) records[i].scene_law = Restitution{0.5};
  for (const std::size_t i : {1U, 2U}) {
    records[i].status = Status::not_applicable;
    records[i].law.reset();
    records[i].law_matches_scene.reset();
  }
  const CaseResults results = test::results_of(records);
  const std::vector<ResolutionStudy> studies = resolution_studies(results.all);
  EXPECT_EQ(studies[1].eligibility, Eligibility::another_law);
  EXPECT_EQ(studies[2].eligibility, Eligibility::not_applicable) << "a scene of another law";
}

}  // namespace
}  // namespace signorini::resolution_study_test
