#include "harness/run/trial.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "tests/harness/fake_method.hpp"

namespace signorini::trial_test {

namespace {

/// The records of a trial of the fake method after each of its stages, in this process.
std::vector<Record> stages_of(const std::string& behaviour, bool certified = true, int samples = 0,
                              bool measured = true, double certificate = 5.0) {
  const Scene scene = test::one_mass_scene();
  const Case planned_case = test::fake_case(scene, behaviour);
  const Limits limits{.timeout = 5.0, .repetitions = 1, .certificate_timeout = certificate};
  const Reference none{.reason = "not asked for"};
  const OrbitTools orbits(test::free_orbits());
  const Trial trial{
      .scene = scene,
      .planned_case = planned_case,
      .limits = limits,
      .law = as_represented(scene.problem.law()),
      .reference = none,
      .scene_reference = none,
      .orbits = orbits,
      .extras = {.samples = samples, .timed = false, .certified = certified, .measured = measured}};
  std::vector<Record> records;
  Record record;
  record.law = trial.law;
  run_trial(trial, record, [&](const Record& so_far) { records.push_back(so_far); });
  return records;
}

TEST(RunTrial, AddsToTheRecordStageByStage) {
  const std::vector<Record> stages = stages_of("good");
  ASSERT_EQ(stages.size(), 4U);
  const auto stage = [&](TrialStage which) { return stages[static_cast<std::size_t>(which)]; };
  EXPECT_EQ(stage(TrialStage::solved).status, Status::converged);
  EXPECT_FALSE(stage(TrialStage::solved).answer.empty());
  EXPECT_EQ(stage(TrialStage::solved).not_timed, "");
  EXPECT_EQ(stage(TrialStage::timed).not_timed, "not asked for");
  EXPECT_FALSE(stage(TrialStage::timed).physics.penetration.has_value());
  EXPECT_EQ(stage(TrialStage::measured).physics.penetration, 0.0);
  EXPECT_EQ(stage(TrialStage::measured).certificate.status, CertificateStatus::none);
  EXPECT_EQ(stage(TrialStage::certified).certificate.status, CertificateStatus::certified);
}

TEST(RunTrial, SaysThatNoCertificateIsAskedForWhereItMayTakeNoTime) {
  const Record record = stages_of("good", true, 0, true, 0.0).back();
  EXPECT_EQ(record.status, Status::converged);
  EXPECT_EQ(record.certificate.status, CertificateStatus::none);
  EXPECT_EQ(record.certificate.reason, "switched off by --certificate 0");
  EXPECT_FALSE(record.certificate.expired.has_value());
}

TEST(RunTrial, CountsTheProcessorTimeOfEachStageThatWasReached) {
  const std::clock_t before = std::clock();
  const std::vector<Record> stages = stages_of("good");
  const double all = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  EXPECT_FALSE(stages[0].processor.timing.has_value());
  EXPECT_FALSE(stages[2].processor.certificate.has_value());
  const StageSeconds& last = stages.back().processor;
  EXPECT_GT(last.certificate.value(), 0.0);
  EXPECT_GE(last.solve.value() + last.timing.value() + last.measures.value(), 0.0);
  EXPECT_LE(*last.solve + *last.timing + *last.measures + *last.certificate, all);
  EXPECT_FALSE(stages_of("good", false, 16).back().processor.certificate.has_value());
}

TEST(RunTrial, StopsAfterTheSolveWhereThereIsNoAnswer) {
  for (const char* behaviour : {"give_up", "no_trajectory", "singular"}) {
    const std::vector<Record> stages = stages_of(behaviour);
    ASSERT_EQ(stages.size(), 1U) << behaviour;
    EXPECT_NE(stages[0].status, Status::converged) << behaviour;
    EXPECT_NE(stages[0].message, "") << behaviour;
  }
}

TEST(RunTrial, DoesNotCatchWhatTheMethodThrows) {
  EXPECT_THROW(stages_of("throw_error"), std::exception);
  EXPECT_THROW(stages_of("throw_number"), int);
}

TEST(RunTrial, TellsTheContactRatioAloneWhereMeasuresAreNotAskedFor) {
  const std::vector<Record> stages = stages_of("good", false, 0, false);
  ASSERT_EQ(stages.size(), 4U);
  const Physics& physics = stages.back().physics;
  EXPECT_EQ(physics.contact_ratio, stages_of("good", false).back().physics.contact_ratio);
  EXPECT_TRUE(physics.contact_ratio.has_value());
  EXPECT_FALSE(physics.penetration.has_value());
  EXPECT_FALSE(physics.energy_defect.has_value());
  EXPECT_EQ(stages_of("good", true, 0, false).back().physics.penetration, 0.0);  // a certificate needs them
}

TEST(RunTrial, KeepsSamplesAndLeavesOutTheCertificateOnRequest) {
  const Record record = stages_of("good", false, 16).back();
  EXPECT_EQ(record.trajectory.value().t.size(), 16U);
  EXPECT_EQ(record.certificate.status, CertificateStatus::none);
  EXPECT_EQ(record.certificate.reason, "not asked for");
}

TEST(RepeatSolve, GivesTheDigestOfTheFirstSolve) {
  const Scene scene = test::one_mass_scene();
  const Limits limits{.timeout = 5.0, .repetitions = 1};
  const RepeatedSolve repeat = repeat_solve(scene, test::fake_case(scene, "good"), limits, nullptr);
  EXPECT_EQ(repeat.answer, stages_of("good").front().answer);
  ASSERT_TRUE(repeat.times.has_value());
  EXPECT_GT(repeat.times->solve, 0.0);
  const RepeatedSolve failed = repeat_solve(scene, test::fake_case(scene, "give_up"), limits, nullptr);
  EXPECT_FALSE(failed.times.has_value());
  EXPECT_NE(failed.message, "");
  EXPECT_EQ(failed.status, Status::not_converged);
  const Limits short_limits{.timeout = 0.05, .repetitions = 1};
  EXPECT_EQ(repeat_solve(scene, test::fake_case(scene, "obey_deadline"), short_limits, nullptr).status,
            Status::timeout);
}

Case case_starting(const Scene& scene, const std::string& start) {
  return make_case(scene, 0, {&test::fake_catalogue().front(), {{"start", start}}});
}

Reference reference_of(const Problem& problem) {
  return {.orbit = std::make_shared<SampledTrajectory>(*test::free_motion(problem), 64)};
}

TEST(StartPoint, IsColdUnlessTheCaseAsksForOne) {
  const Scene scene = test::one_mass_scene();
  const StartPoint start =
      start_point(test::fake_case(scene, "good"), scene.problem, reference_of(scene.problem));
  EXPECT_EQ(start.motion, nullptr);
  EXPECT_EQ(start.obstacle, "");
}

TEST(StartPoint, IsTheReferenceLateByAShareOfItsPeriod) {
  const Scene scene = test::one_mass_scene();
  const StartPoint start =
      start_point(case_starting(scene, "0.25"), scene.problem, reference_of(scene.problem));
  ASSERT_NE(start.motion, nullptr) << start.obstacle;
  const Eigen::VectorXd x = test::free_motion(scene.problem)->sample(8).x.col(0);
  const Eigen::VectorXd late = start.motion->sample(8).x.col(0);
  for (Eigen::Index i = 0; i < 8; ++i) EXPECT_NEAR(late[i], x[(i + 6) % 8], 1e-12) << i;
}

TEST(StartPoint, RepeatsTheReferenceToThePeriodOfTheProblem) {
  const Scene scene = test::one_mass_scene();
  Problem longer = scene.problem;
  longer.subharmonic = 3;
  const StartPoint start = start_point(case_starting(scene, "0"), longer, reference_of(scene.problem));
  ASSERT_NE(start.motion, nullptr) << start.obstacle;
  EXPECT_DOUBLE_EQ(start.motion->period(), longer.period());
}

TEST(StartPoint, NamesTheObstacle) {
  const Scene scene = test::one_mass_scene();
  const Reference none{.reason = "chaos"};
  EXPECT_EQ(start_point(case_starting(scene, "0"), scene.problem, none).obstacle,
            "no orbit to start from: chaos");
  Problem slower = scene.problem;
  slower.frequency *= 0.6;
  const StartPoint start = start_point(case_starting(scene, "0"), slower, reference_of(scene.problem));
  EXPECT_EQ(start.motion, nullptr);
  EXPECT_NE(start.obstacle.find("has a period of"), std::string::npos) << start.obstacle;
}

}  // namespace

}  // namespace signorini::trial_test
