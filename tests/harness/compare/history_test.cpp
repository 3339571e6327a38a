#include "harness/compare/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/harness/sample_records.hpp"

namespace signorini::history_test {
namespace {

/// A run of ten cases on a machine whose calibration solve takes so long [s] (0: unknown): the case i takes
/// 2^i ms times `seconds`, with an error of 10^-i times `error`.
WholeRun run_of(const std::string& date, const std::string& cpu, double calibration, double seconds,
                double error) {
  WholeRun run{.folder = test::part_of_a_run(date, {})};
  run.folder.manifest["machine"]["cpu"] = cpu;
  run.folder.manifest["build"]["commit"] = "0123456789abcdef";
  if (calibration > 0.0)
    run.folder.manifest["calibration"] = {{"version", 1}, {"seconds", calibration}, {"solves", 25}};
  for (int i = 0; i < 10; ++i)
    run.records.push_back(test::good_record("s" + std::to_string(i), "m", "n=1", error * std::pow(10.0, -i),
                                            seconds * 1e-3 * std::pow(2.0, i)));
  return run;
}

// The second program is twice as fast, on a machine that is three times as slow.
TEST(History, TellsTheProgramFromTheMachine) {
  const History history =
      history_of({run_of("2026-02", "slow", 6e-3, 1.5, 1e-3), run_of("2026-01", "fast", 2e-3, 1.0, 1e-3)});
  ASSERT_EQ(history.points.size(), 2U);
  EXPECT_EQ(history.points[0].date, "2026-01");
  EXPECT_EQ(history.points[0].commit, "0123456789ab");
  const double mean = 1e-3 * std::pow(2.0, 4.5);
  EXPECT_NEAR(*history.points[0].seconds, mean, 1e-12);
  EXPECT_NEAR(*history.points[1].seconds, 0.5 * mean, 1e-12);
}

TEST(History, CountsCertifiedCasesAndTakesErrorsAndTimesOfThoseInAllRuns) {
  WholeRun first = run_of("2026-01", "x", 0.0, 1.0, 1e-3), second = run_of("2026-02", "x", 0.0, 1.0, 1e-4);
  for (int i = 0; i < 4; ++i)
    first.records[static_cast<std::size_t>(i)].certificate.status = CertificateStatus::uncertified;
  second.records[9].scene_sha256 = "another text";
  second.records[8].status = Status::timeout;
  const History history = history_of({first, second});
  EXPECT_EQ(history.cases, 9U);
  EXPECT_EQ(history.points[0].certified, 5U);
  EXPECT_EQ(history.points[1].certified, 8U);
  EXPECT_EQ(history.certified, 4U);  // the cases 4 to 7
  EXPECT_EQ(history.timed, 4U);
  EXPECT_NEAR(*history.points[0].seconds, 1e-3 * std::pow(2.0, 5.5), 1e-12);
}

TEST(History, HidesTimesThatNothingSetsBesideOthers) {
  WholeRun busy = run_of("2026-02", "x", 0.0, 1.0, 1e-3);
  busy.folder.manifest["times_not_comparable"] = "it was busy";
  const History history =
      history_of({run_of("2026-01", "x", 2e-3, 1.0, 1e-3), busy, run_of("2026-03", "y", 0.0, 1.0, 1e-3)});
  EXPECT_TRUE(history.points[0].seconds);
  EXPECT_EQ(history.points[1].hides_time, "it was busy");
  EXPECT_FALSE(history.points[1].seconds);
  EXPECT_EQ(history.points[2].hides_time,
            "its machine is another one, without the time of a calibration solve");
  EXPECT_FALSE(history.points[2].seconds);
  EXPECT_TRUE(history.points[2].error);
}

}  // namespace
}  // namespace signorini::history_test
