#include "harness/report/evaluation/case_result.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace signorini::case_result_test
