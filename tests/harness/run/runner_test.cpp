#include "harness/run/runner.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "harness/build_info.hpp"
#include "methods/plugin/sanitizer.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::runner_test {
namespace {

constexpr Limits kLimits{
    .timeout = 1.5, .memory_mb = 256, .repetitions = 2, .certificate_timeout = 5.0, .reference_timeout = 5.0};

Record run_fake(const std::string& behaviour, const Scene& scene = test::one_mass_scene(),
                OrbitSolver solver = test::free_orbits()) {
  Runner runner(kLimits, std::move(solver), [](std::string_view) { return std::string("v"); });
  const std::vector cases{test::fake_case(scene, behaviour)};
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  runner.compute_references(scene, jobs);
  return runner.run(scene, jobs.front()).value();
}

struct Misdeed {
  const char* behaviour;
  Status status;
  const char* words;  // that the message must contain
};

void PrintTo(const Misdeed& misdeed, std::ostream* stream) { *stream << misdeed.behaviour; }

class Runners : public testing::TestWithParam<Misdeed> {};

TEST_P(Runners, TurnWhateverHappensIntoTheRightRecord) {
  const Misdeed& misdeed = GetParam();
  if (kAddressSanitizer && std::string_view(misdeed.behaviour) == "allocate")
    GTEST_SKIP() << "the address sanitizer needs the address space itself";
  const Record record = run_fake(misdeed.behaviour);
  EXPECT_EQ(status_name(record.status), status_name(misdeed.status)) << record.message;
  EXPECT_NE(record.message.find(misdeed.words), std::string::npos) << record.message;
  EXPECT_EQ(record.message.find('\n'), std::string::npos);
  EXPECT_EQ(record.scene, "one-mass");
  EXPECT_EQ(record.case_id, std::string("one-mass/fake-method[behaviour=") + misdeed.behaviour + "]");
  EXPECT_EQ(record.options.size(), 2U);
  EXPECT_FALSE(record.seconds.has_value());
  EXPECT_FALSE(record.errors.x_l2.has_value());
  EXPECT_NE(record.certificate.status, CertificateStatus::certified);
  EXPECT_FALSE(record.certificate.reason.empty());
}

INSTANTIATE_TEST_SUITE_P(EveryMisdeed, Runners,
                         testing::Values(Misdeed{"segfault", Status::crashed, "signal 11"},
                                         Misdeed{"abort_now", Status::crashed, "signal 6"},
                                         Misdeed{"exit_three", Status::crashed, "code 3"},
                                         Misdeed{"throw_error", Status::exception, "the matrix fell over"},
                                         Misdeed{"throw_number", Status::exception,
                                                 "an object of type int, which is no std::exception"},
                                         Misdeed{"spin", Status::timeout, "time limit"},
                                         Misdeed{"allocate", Status::out_of_memory, "out of memory"},
                                         Misdeed{"not_a_number", Status::invalid_output, "not finite"},
                                         Misdeed{"ignore_sigterm", Status::timeout, "time limit"},
                                         Misdeed{"overflow_stack", Status::crashed, "signal 11"},
                                         Misdeed{"no_trajectory", Status::invalid_output,
                                                 "without a trajectory"},
                                         Misdeed{"wrong_size", Status::invalid_output, "2 contacts"},
                                         Misdeed{"wrong_period", Status::invalid_output, "no whole multiple"},
                                         Misdeed{"give_up", Status::not_converged, "gave up"},
                                         Misdeed{"singular", Status::not_converged, "is singular"},
                                         Misdeed{"obey_deadline", Status::timeout, "gave up"},
                                         Misdeed{"unsupported", Status::not_applicable, "it is Tuesday"},
                                         Misdeed{"crash_when_asked", Status::crashed, "signal 6"}),
                         [](const auto& info) { return std::string(info.param.behaviour); });

TEST(Runner, RecordsTheSignalOfACrash) {
  EXPECT_EQ(run_fake("segfault").signal, SIGSEGV);
  EXPECT_EQ(run_fake("abort_now").signal, SIGABRT);
  EXPECT_FALSE(run_fake("exit_three").signal.has_value());
}

TEST(Runner, MeasuresACertifiedAnswer) {
  const Record record = run_fake("good");
  EXPECT_EQ(record.status, Status::converged) << record.message;
  EXPECT_EQ(record.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(record.certificate.same_orbit, true);
  ASSERT_TRUE(record.errors.x_l2.has_value());
  EXPECT_LT(*record.errors.x_l2, 1e-14);
  EXPECT_LT(record.physics.energy_defect.value(), 1e-12);
  EXPECT_EQ(record.physics.penetration.value(), 0.0);
  EXPECT_EQ(record.law_matches_scene, true);
  EXPECT_EQ(record.work.counts.iterations, 7);
  EXPECT_EQ(record.condition, 100.0);
}

/// A case of the fake method that starts from the reference orbit, late by a share of its period.
Record run_late(const std::string& late, const OrbitSolver& solver,
                const Scene& scene = test::one_mass_scene()) {
  Runner runner(kLimits, solver, [](std::string_view) { return std::string("v"); });
  const std::vector cases{
      make_case(scene, 0, {&test::fake_catalogue().front(), {{"behaviour", "hand_back"}, {"start", late}}})};
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  runner.compute_references(scene, jobs);
  return runner.run(scene, jobs.front(), {.samples = 8}).value();
}

// Each process that judges an answer inherits the space of a large structure; one answer alone does not wait
// for it.
TEST(Runner, MakesTheSpaceOfALargeStructureOnceForAllAnswersThatAreJudgedOnIt) {
  Scene scene = test::one_mass_scene();
  scene.problem = test::padded_block_problem({.elements = {20, 5, 5}});
  ASSERT_GT(scene.problem.size(), 2000);
  const OrbitTools tools(test::free_orbits());
  Runner runner(kLimits, tools, [](std::string_view) { return std::string("v"); });
  const std::vector cases{test::fake_case(scene, "good"), test::fake_case(scene, "wrong_size")};
  const std::vector<Job> jobs = runner.make_jobs(scene, cases);
  ASSERT_EQ(jobs.size(), 2U);
  runner.compute_references(scene, std::span(jobs).first(1));
  EXPECT_EQ(tools.spaces->made(), 0);
  runner.compute_references(scene, jobs);
  EXPECT_EQ(tools.spaces->made(), 1);
  static_cast<void>(tools.spaces->of(scene.problem));
  EXPECT_EQ(tools.spaces->made(), 1) << "it is that of the scene";
}

TEST(Runner, StartsACaseFromTheReferenceOrbitLateByItsShareOfThePeriod) {
  const Record record = run_late("0.25", test::free_orbits());
  ASSERT_TRUE(record.trajectory.has_value()) << record.message;
  EXPECT_EQ(record.case_id, "one-mass/fake-method[behaviour=hand_back,start=0.25]");
  const Eigen::VectorXd x = test::free_motion(test::one_mass())->sample(8).x.col(0);
  for (Eigen::Index i = 0; i < 8; ++i) {
    EXPECT_NEAR(record.trajectory->x[0][static_cast<std::size_t>(i)], x[(i + 6) % 8], 1e-14) << i;
  }
  EXPECT_EQ(record.options.back().first, "start");
}

TEST(Runner, RepeatsAnOrbitToStartFromWhereTheSceneAsksForMorePeriods) {
  Scene scene = test::one_mass_scene();
  scene.problem.subharmonic = 2;
  const Record record = run_late("0", test::free_orbits(), scene);
  ASSERT_TRUE(record.trajectory.has_value()) << record.message;
  EXPECT_DOUBLE_EQ(record.period.value(), scene.problem.period());
  const std::vector<double>& x = record.trajectory->x[0];
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(x[i], x[i + 4]) << i;
}

TEST(Runner, DoesNotStartFromAnOrbitOfAnotherPeriod) {
  const OrbitSolver halves = [](const Problem& problem, const PeriodicMotionOptions&, const Start&) {
    Problem twice = problem;
    twice.frequency *= 0.5;  // a motion of two forcing periods
    return Solution{.verdict = Verdict::converged,
                    .message = {},
                    .trajectory = test::free_motion(twice),
                    .residual = 1e-14};
  };
  const Record record = run_late("0", halves);
  EXPECT_EQ(record.status, Status::not_applicable);
  EXPECT_NE(record.message.find("has a period of"), std::string::npos) << record.message;
}

TEST(Runner, SaysSoWhereThereIsNoOrbitToStartFrom) {
  const auto none = [](const Problem&, const PeriodicMotionOptions&, const Start&) {
    return Solution{.message = "it wanders"};
  };
  const Record record = run_late("0.25", OrbitSolver(none));
  EXPECT_EQ(record.status, Status::not_applicable);
  EXPECT_NE(record.message.find("no orbit to start from: "), std::string::npos) << record.message;
}

TEST(Runner, CallsALieInaccurate) {
  const Record record = run_fake("lie");
  EXPECT_EQ(record.status, Status::inaccurate);
  EXPECT_EQ(record.certificate.status, CertificateStatus::uncertified);
  EXPECT_FALSE(record.errors.x_l2.has_value());
  EXPECT_NEAR(record.certificate.distance.value(), 2.0, 1e-10);
}

TEST(Runner, CallsDeepPenetrationInaccurateWhateverTheOrbits) {
  // The contact-free motion, of amplitude 0.33 m, with the stop at -0.1 m.
  const Record record = run_fake("good", test::one_mass_scene(-0.1));
  EXPECT_EQ(record.status, Status::inaccurate);
  EXPECT_GT(record.physics.penetration.value(), 0.5);
}

TEST(Runner, LetsASoftStopBePenetrated) {
  Scene scene = test::one_mass_scene(-0.1);
  scene.problem.set_law(Penalty{{1e-3}});
  EXPECT_EQ(run_fake("good", scene).status, Status::converged);
}

TEST(Runner, DoesNotCertifyByTheReferenceWhereTheShootingFails) {
  const OrbitSolver marching_only = [](const Problem& problem, const PeriodicMotionOptions& options,
                                       const Start& start) {
    // Continued from the reference's own marching, but not from an answer, which never is a guess at 1e-11.
    if (options.shooting && options.tolerance > 5e-12) return Solution{.message = "Newton's method failed"};
    return test::free_orbits()(problem, options, start);
  };
  const Record record = run_fake("good", test::one_mass_scene(), marching_only);
  EXPECT_EQ(record.status, Status::converged);
  EXPECT_EQ(record.certificate.status, CertificateStatus::uncertified);
  EXPECT_TRUE(record.certificate.reference) << "there is one";
  EXPECT_EQ(claim_of(record), Claim::unproven);
}

TEST(Runner, SaysWhyAnAnswerIsUncertified) {
  const OrbitSolver none = [](const Problem&, const PeriodicMotionOptions&, const Start&) {
    return Solution{.message = "chaos"};
  };
  const Record record = run_fake("good", test::one_mass_scene(), none);
  EXPECT_EQ(record.status, Status::converged);
  EXPECT_EQ(record.certificate.status, CertificateStatus::uncertified);
  EXPECT_EQ(record.certificate.reason, "chaos");
  EXPECT_EQ(record.certificate.reference_reason, "chaos");
  EXPECT_FALSE(record.errors.x_l2.has_value());
}

TEST(Runner, LeavesNoClaimWhereItsOwnCheckCrashes) {
  const OrbitSolver crash = [](const Problem&, const PeriodicMotionOptions&, const Start&) -> Solution {
    std::abort();
  };
  const Record record = run_fake("good", test::one_mass_scene(), crash);
  EXPECT_EQ(record.status, Status::crashed);
  EXPECT_EQ(record.signal, SIGABRT);
  EXPECT_EQ(record.certificate.status, CertificateStatus::uncertified);
  EXPECT_NE(record.certificate.reason.find("signal 6"), std::string::npos);
  EXPECT_TRUE(record.physics.energy_defect.has_value());
}

TEST(Runner, RecordsTimesInReleaseBuildsOnly) {
  const Record record = run_fake("good");
  EXPECT_EQ(record.seconds.has_value(), build_may_be_timed());
  EXPECT_EQ(record.not_timed.empty(), build_may_be_timed());
  if (!record.seconds) return;
  EXPECT_GE(record.seconds->repetitions, 2);  // more where they differ, as on a busy machine
  EXPECT_GT(record.seconds->min, 0.0);
  EXPECT_LE(record.seconds->min, record.seconds->median);
  EXPECT_GT(record.seconds->first.value(), 0.0);
  for (const TimedRound& round : record.seconds->rounds) EXPECT_TRUE(round.first.has_value());
}

TEST(Runner, TakesTheLiteraturesFormsOnce) {
  const Runner runner(kLimits, test::free_orbits(), [](std::string_view) { return std::string("v"); });
  Record record;
  record.seconds = Seconds{.rounds = {{.setup = 1e-4, .solve = 1e-3}}};
  EXPECT_EQ(runner.rounds_missing(record, kMoreRounds), 1);
  record.settings = {{"plain", "true"}};
  EXPECT_EQ(runner.rounds_missing(record, kMoreRounds), 0);
  EXPECT_EQ(runner.rounds_missing(record, kMoreRounds, 2), 1) << "where an equal solve took another time";
}

TEST(Runner, CountsACrashInARepetitionAgainstTheMethod) {
  const Record record = run_fake("crash_when_repeated");
  EXPECT_EQ(record.status, build_may_be_timed() ? Status::crashed : Status::converged);
  EXPECT_EQ(record.message.starts_with("in a repeated solve"), build_may_be_timed()) << record.message;
}

TEST(Runner, SeesWhetherARepetitionGivesTheSameBits) {
  const Record good = run_fake("good");
  ASSERT_EQ(good.repeats.has_value(), build_may_be_timed());
  if (!good.repeats) return;
  EXPECT_GE(good.repeats->solves, 2);  // in the first process, and in that of the second round
  EXPECT_EQ(good.repeats->identical, good.repeats->solves);
  const Record wavering = run_fake("waver");
  EXPECT_EQ(wavering.status, Status::converged) << wavering.message;
  ASSERT_TRUE(wavering.repeats.has_value());
  EXPECT_LT(wavering.repeats->identical, wavering.repeats->solves);
}

TEST(Runner, EndsTheProcessesThatAMethodLeavesBehind) {
  EXPECT_EQ(run_fake("orphan").status, Status::converged);
}

}  // namespace
}  // namespace signorini::runner_test
