#include "harness/report/evaluation/resolution_study.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

Record run(const std::string& case_id) {
  const CaseName name = parse_case_name(case_id);
  return {.case_id = case_id, .scene = name.scene, .method = name.method, .settings = name.settings};
}

TEST(ConfigurationOf, KeepsWordsAndDropsTheNumbersOfTheResolution) {
  EXPECT_EQ(configuration_of(run("s/event-driven[flow=cvode,tolerance=1e-6]")), "event-driven[flow=cvode]");
  EXPECT_EQ(configuration_of(run("s/event-driven[tolerance=1e-6,flow=modal]")), "event-driven[flow=modal]");
  EXPECT_EQ(configuration_of(run("s/hat-lcp[samples=64]")), "hat-lcp");
  EXPECT_EQ(configuration_of(run("s/penalty-hbm[penalty=100x,plain=true,harmonics=5]")),
            "penalty-hbm[penalty=100x,plain=true]");
  EXPECT_EQ(configuration_of(run("s/hat-lcp")), "hat-lcp");
  EXPECT_EQ(configuration_of(run("s/hat-lcp[samples=64,start=0.1]")), "hat-lcp[start=0.1]");
}

TEST(ScoredRun, HasAnErrorOnlyIfTheHarnessItselfHasCertifiedIt) {
  const Record good = test::good_record("s", "m", "n=1", 0.1, 1.0);
  EXPECT_EQ(scored_run(good).error, 0.1);
  // A fast wrong answer: the method says converged, the harness disagrees.
  Record liar = good;
  liar.status = Status::inaccurate;
  EXPECT_FALSE(scored_run(liar).error);
  Record uncertified = good;
  uncertified.certificate.status = CertificateStatus::uncertified;
  EXPECT_FALSE(scored_run(uncertified).error);
  Record elsewhere = good;
  elsewhere.certificate.same_orbit = false;
  EXPECT_EQ(scored_run(elsewhere).error, 0.1) << "another orbit of the scene solves it too";
  Record without_reference = good;
  without_reference.certificate.same_orbit.reset();
  EXPECT_EQ(scored_run(without_reference).error, 0.1);
}

TEST(ScoredRun, BoundsErrorsByTenErrorBarsInsteadOfRankingThem) {
  Record record = test::good_record("s", "m", "n=1", 1e-15, 1.0);
  record.certificate.error_bar = 1e-12;
  const ScoredRun run = scored_run(record);
  EXPECT_TRUE(run.bounded);
  EXPECT_DOUBLE_EQ(*run.error, 1e-11);
}

TEST(ResolutionStudies, SetMethodsOfAnotherLawApart) {
  std::vector<Record> records{
      test::good_record("s", "a", "n=1", 0.1, 1.0), test::good_record("s", "a", "n=2", 0.01, 2.0),
      test::good_record("s", "b", "n=1", 0.1, 1.0), test::good_record("s", "c", "n=1", 0.1, 1.0)};
  records[2].law_matches_scene = false;
  records[3].status = Status::not_applicable;
  const std::vector<ResolutionStudy> studies = resolution_studies(records);
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
  const std::vector<ResolutionStudy> studies = resolution_studies(records);
  EXPECT_EQ(studies[1].eligibility, Eligibility::another_law);
  EXPECT_EQ(studies[2].eligibility, Eligibility::not_applicable) << "a scene of another law";
}

}  // namespace
}  // namespace signorini
