#include "harness/report/evaluation/resolution_study.hpp"

#include <gtest/gtest.h>

#include <set>

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
/// A study of runs of given errors and seconds.
struct Runs {
  explicit Runs(const std::vector<std::pair<double, double>>& error_and_time) {
    std::vector<Record> records;
    for (const auto& [error, time] : error_and_time) {
      records.push_back(test::good_record("s", "m", "n=" + std::to_string(records.size()), error, time));
      records.back().work.counts.pivots = static_cast<long>(100.0 * time);
    }
    results = test::results_of(records);
    study = resolution_studies(results.all).front();
  }
  CaseResults results;
  ResolutionStudy study;
};

TEST(Reach, CountsScenesAndTakesThoseNotReachedForInfinite) {
  EXPECT_EQ(Reach{}.median_seconds(), kNeverReached);
  Reach reach;
  for (const double error : {1e-3, 1e-4, 0.5}) reach.add(Runs({{error, 2.0}, {0.5, 1.0}}).study, 1e-2);
  EXPECT_EQ(reach.scenes, 2);
  EXPECT_EQ(reach.median_seconds(), 2.0);
  reach.add(Runs({{0.5, 1.0}}).study, 1e-2);
  EXPECT_EQ(reach.scenes, 2);
  EXPECT_EQ(reach.median_seconds(), kNeverReached);
}

TEST(ParetoCurve, LeavesOutWhatAnotherRunBeatsInBoth) {
  const Runs runs({{0.1, 1.0}, {0.2, 2.0}, {0.01, 4.0}, {0.05, 3.0}, {0.01, 5.0}});
  const std::vector<CurvePoint> curve = pareto_curve(runs.study, time_axis());
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_EQ(curve[0].cost, 1.0);
  EXPECT_EQ(curve[1].cost, 3.0);
  EXPECT_EQ(curve[2].cost, 4.0);
}

TEST(ParetoCurve, RanksNothingBelowTenErrorBars) {
  // Dividing by, or ordering by, errors of 1e-15 and 1e-17 would be ranking noise.
  const Runs runs({{1e-15, 1.0}, {1e-17, 2.0}, {0.0, 3.0}});
  const std::vector<CurvePoint> curve = pareto_curve(runs.study, time_axis());
  ASSERT_EQ(curve.size(), 1U);
  EXPECT_EQ(curve[0].cost, 1.0);
  EXPECT_DOUBLE_EQ(*curve[0].run->error, 1e-11);
}

TEST(CostToError, IsThatOfTheCheapestRunThatReachesItAndNeverExtrapolates) {
  const Runs runs({{0.09, 1.0}, {0.011, 2.0}, {0.009, 8.0}});
  EXPECT_EQ(cost_to_error(runs.study, time_axis(), 0.1).cost, 1.0);
  EXPECT_EQ(cost_to_error(runs.study, time_axis(), 0.05).cost, 2.0);
  EXPECT_EQ(cost_to_error(runs.study, time_axis(), 0.01).cost, 8.0);  // between runs nothing is drawn
  EXPECT_EQ(cost_to_error(runs.study, time_axis(), 1e-3).cost, kNeverReached);
  EXPECT_EQ(cost_to_error(runs.study, time_axis(), 1e-3).run, nullptr);
}

TEST(CostToError, DoesNotReachBelowTheFloorOfTheReference) {
  const Runs runs({{0.0, 1.0}});  // its orbit is known to 1e-12
  EXPECT_EQ(cost_to_error(runs.study, time_axis(), 1e-9).cost, 1.0);
  EXPECT_EQ(cost_to_error(runs.study, time_axis(), 1e-12).cost, kNeverReached);
}

TEST(CostToError, CountsWorkAsItCountsTime) {
  const Runs runs({{0.09, 1.0}, {0.009, 8.0}});
  const CostAxis& pivots = work_axes()[0];
  EXPECT_EQ(pivots.name, "pivots");
  EXPECT_EQ(cost_to_error(runs.study, pivots, 0.01).cost, 800.0);
  const CostAxis& unknowns = work_axes()[4];
  EXPECT_EQ(cost_to_error(runs.study, unknowns, 0.1).cost, kNeverReached);  // not counted
}

TEST(CostToError, DoesNotTakeAFastWrongAnswerForASolution) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 1e-6, 0.1),
                              test::good_record("s", "m", "n=2", 1e-6, 1.0)};
  records[0].status = Status::inaccurate;
  const CaseResults results = test::results_of(records);
  const std::vector<ResolutionStudy> studies = resolution_studies(results.all);
  EXPECT_EQ(cost_to_error(studies[0], time_axis(), 1e-2).cost, 1.0);
}

TEST(TimeAxis, IsTheMedianTimeIfTheRunWasTimed) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.25);
  EXPECT_EQ(time_axis().cost(test::results_of({record}).all[0]), 0.25);
  record.seconds.reset();
  EXPECT_FALSE(time_axis().cost(test::results_of({record}).all[0]).has_value());
}

TEST(WorkAxes, AreTheCountsThatAMethodGives) {
  const CaseResults results = test::results_of({test::full_record()});  // counts 1 to 5, each once
  const CaseResult& result = results.all[0];
  std::set<double> costs;
  for (const CostAxis& axis : work_axes()) costs.insert(axis.cost(result).value());
  EXPECT_EQ(costs, (std::set<double>{1.0, 2.0, 3.0, 4.0, 5.0}));
  EXPECT_EQ(work_axes()[0].name, "pivots");
  EXPECT_EQ(work_axes()[0].cost(result), 3.0);
  for (const CostAxis& axis : work_axes()) EXPECT_FALSE(axis.cost(CaseResult{}).has_value()) << axis.name;
}

}  // namespace
}  // namespace signorini::resolution_study_test
