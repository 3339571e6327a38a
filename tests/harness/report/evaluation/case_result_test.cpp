#include "harness/report/evaluation/case_result.hpp"

#include <gtest/gtest.h>

#include "tests/harness/responses/sample_responses.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::case_result_test {
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
  // A constant of the contact law is no resolution either, though it is a number.
  EXPECT_EQ(configuration_of(run("s/fourier-lipschitz[c=1e5,plain=true,harmonics=5]")),
            "fourier-lipschitz[c=1e5,plain=true]");
  EXPECT_EQ(configuration_of(run("s/hat-lcp")), "hat-lcp");
  EXPECT_EQ(configuration_of(run("s/hat-lcp[samples=64,start=0.1]")), "hat-lcp[start=0.1]");
}

TEST(CaseResults, HoldWhatReportsCompare) {
  const Record record = test::full_record();
  const CaseResults results = test::results_of({record});
  const CaseResult& result = results.all[0];
  EXPECT_EQ(result.case_id, record.case_id);
  EXPECT_EQ(result.choice->method, record.method);
  EXPECT_EQ(result.choice->settings, record.settings);
  EXPECT_EQ(result.choice->options, record.options);
  EXPECT_EQ(result.choice->same_equations_as, "method-b");
  EXPECT_EQ(result.choice->resolution, "method-a[n=1]");
  EXPECT_EQ(result.choice->configuration, "method-a");
  EXPECT_EQ(result.scene->name, "scene-a");
  EXPECT_EQ(result.scene->coordinates, 3);
  EXPECT_EQ(result.scene->contacts, 1);
  EXPECT_EQ(result.outcome.status, Status::converged);
  EXPECT_EQ(result.outcome.same_orbit, true);
  EXPECT_EQ(std::get<Restitution>(*result.law).e, 1.0);
  EXPECT_EQ(result.error, 0.125);
  EXPECT_EQ(result.impulse_error, 0.5);
  EXPECT_EQ(result.measurable, measurable_error(record));
  EXPECT_EQ(result.condition, 1e3);
  EXPECT_EQ(result.seconds, 0.5);
  EXPECT_TRUE(result.together);
  EXPECT_TRUE(result.keeps_motion);
  EXPECT_EQ(result.work.pivots, 3);
  EXPECT_EQ(result.repeats->identical, 6);
  EXPECT_EQ(*result.orbit, "0a1b2c3d");
  EXPECT_EQ(*result.problem, record.problem);
}

TEST(CaseResults, ShareWhatRecordsHaveInCommonAndNothingElse) {
  std::vector<Record> records(4, test::full_record());
  records[1].case_id = "another";
  records[2].options[1].second = 1e-8;
  records[3].coordinates = 7;
  const std::vector<CaseResult> all = test::results_of(records).all;
  EXPECT_EQ(all[0].choice, all[1].choice);
  EXPECT_EQ(all[0].orbit, all[3].orbit);
  EXPECT_NE(all[0].choice, all[2].choice);
  EXPECT_EQ(all[0].scene, all[2].scene);
  EXPECT_NE(all[0].scene, all[3].scene);
}

TEST(CaseResults, StayValidWhereTheyAreMovedAndAreKeptByTheirNumbers) {
  std::vector<Record> records;
  for (const char* resolution : {"n=1", "n=2", "n=3"})
    records.push_back(test::good_record("s", "m", resolution, 0.1, 1.0));
  CaseResults results = test::results_of(records);
  results.keep({2, 0});
  const CaseResults moved = std::move(results);
  ASSERT_EQ(moved.all.size(), 2U);
  EXPECT_EQ(moved.all[0].choice->resolution, "m[n=3]");
  EXPECT_EQ(moved.all[0].source, 2U);
  EXPECT_EQ(moved.all[1].choice->resolution, "m[n=1]");
  EXPECT_EQ(moved.all[1].scene->name, "s");
}
TEST(CertifiedError, IsThatOfXOrOfUAndNeverBelowTenErrorBars) {
  Record record = test::good_record("s", "m", "n=1", 1e-15, 1.0);
  record.certificate.error_bar = 1e-12;
  const auto bounded = [&] { return bounded_error(test::results_of({record}).all[0]); };
  const auto certified = [&] { return certified_error(test::results_of({record}).all[0]); };
  EXPECT_EQ(test::results_of({record}).all[0].error, 1e-15);
  EXPECT_DOUBLE_EQ(certified().value(), 1e-11);
  record.errors = {.u_l2 = 0.5};
  EXPECT_EQ(certified(), 0.5);
  record.status = Status::inaccurate;
  EXPECT_EQ(bounded(), 0.5);
  EXPECT_FALSE(certified().has_value());
  record.errors = {};
  EXPECT_FALSE(bounded().has_value());
}

TEST(CertifiedLevel, AsksForTheWorstContactAndTheForceToo) {
  Record record = test::good_record("s", "m", "n=1", 1e-4, 1.0);
  const auto level = [&] { return certified_level(test::results_of({record}).all[0]); };
  EXPECT_EQ(level(), 1e-4);
  record.errors.x_worst = 1e-3;
  EXPECT_EQ(level(), 1e-3);
  record.errors.force = 1e-2;
  EXPECT_EQ(level(), 1e-2);
  EXPECT_EQ(certified_error(test::results_of({record}).all[0]), 1e-4) << "the error of x is what it is";
  record.certificate.error_bar = 1e-2;
  EXPECT_EQ(level(), 1e-1);
  record.status = Status::inaccurate;
  EXPECT_FALSE(level().has_value());
}

TEST(OutcomeCounts, HoldEveryCaseOnce) {
  OutcomeCounts counts;
  int answers = 0;
  for (const Record& record : test::records_of_every_status()) {
    counts.add(outcome_of(record));
    answers += claim_of(record) ? 1 : 0;
  }
  EXPECT_EQ(answers, counts.claims());
  EXPECT_EQ(counts.cases, 10);
  EXPECT_EQ(counts.not_applicable, 1);
  EXPECT_EQ(counts.failed, 6);
  EXPECT_EQ(counts.refuted, 1);
  EXPECT_EQ(counts.unproven, 1);
  EXPECT_EQ(counts.certified, 1);
  EXPECT_EQ(counts.same_orbit + counts.other_orbit, 1);
  EXPECT_EQ(counts.converged(), 2);
  EXPECT_EQ(counts.claims(), 3);
  EXPECT_EQ(counts.applicable(), 9);
}

TEST(OutcomeCounts, ClaimNothingOfAResponse) {
  OutcomeCounts counts;
  Record record = test::response_of("s", "m", 1.0, 1.0);
  counts.add(outcome_of(record));
  record.status = Status::crashed;
  counts.add(outcome_of(record));
  EXPECT_EQ(counts.cases, 2);
  EXPECT_EQ(counts.followed, 1);
  EXPECT_EQ(counts.failed, 1);
  EXPECT_EQ(counts.claims(), 0);
}

TEST(IsSolved, AsksForACertificateUnderTheLawOfTheSceneOnAnyOrbit) {
  Record record = test::good_record("s", "m", "n=1", 0.01, 1.0);
  EXPECT_TRUE(is_solved(outcome_of(record)));
  record.certificate.same_orbit = false;
  EXPECT_TRUE(is_solved(outcome_of(record))) << "another orbit of the scene";
  record.law_matches_scene = false;
  EXPECT_FALSE(is_solved(outcome_of(record))) << "another problem";
  record.law_matches_scene = true;
  record.certificate.status = CertificateStatus::uncertified;
  EXPECT_FALSE(is_solved(outcome_of(record))) << "unproven";
}

TEST(OutcomeCounts, KeepWhatIsSolvedUnderAnotherLawApart) {
  OutcomeCounts counts;
  Record record = test::good_record("s", "m", "n=1", 0.01, 1.0);
  counts.add(outcome_of(record));
  record.law_matches_scene = false;
  counts.add(outcome_of(record));
  counts.add(outcome_of(record));
  record.status = Status::timeout;
  counts.add(outcome_of(record));
  EXPECT_EQ(counts.certified, 3);
  EXPECT_EQ(counts.solved, 1);
  EXPECT_EQ(counts.own_law(), 1);
  EXPECT_EQ(counts.another_law, 3);
  EXPECT_EQ(counts.solved_under_another_law(), 2);
}

TEST(RepeatedProblems, CountOncePerMethodAndForTheSceneThatStatesThem) {
  std::vector<Record> records{
      test::good_record("e08", "m", "n=1", 0.01, 1.0), test::good_record("e1", "m", "n=1", 0.01, 1.0),
      test::good_record("e1", "m", "n=2", 0.01, 1.0),  test::good_record("e1", "other", "n=1", 0.01, 1.0),
      test::good_record("e05", "m", "n=1", 0.01, 1.0), test::good_record("e06", "m", "n=1", 0.01, 1.0)};
  for (Record& record : records) record.problem = "0123456789abcdef";
  for (const std::size_t i : {0U, 4U, 5U}) records[i].law_matches_scene = false;
  records[5].problem = "fedcba9876543210";
  EXPECT_EQ(repeated_problems(test::results_of(records).all),
            (std::vector<bool>{true, false, false, false, true, false}));
  for (Record& record : records) record.problem.clear();  // as in records of earlier versions
  EXPECT_EQ(repeated_problems(test::results_of(records).all), std::vector<bool>(6, false));
}

}  // namespace
}  // namespace signorini::case_result_test
