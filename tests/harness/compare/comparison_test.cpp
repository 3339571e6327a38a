#include "harness/compare/comparison.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "harness/run/trial.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::comparison_test {
namespace {

/// Factor by which the times of a case are longer than they were.
using Slowdown = std::function<double(const Record&)>;

/// Runs of the same 17 cases on 36 scenes, with the noise of a machine that has other work: each round a few
/// per cent off, more for short work, now and then a round that others slowed by up to a half, each case some
/// per cent off by the run's placement in memory, and the whole run off by up to a per cent.
class Machine {
 public:
  explicit Machine(unsigned seed) : random_(seed) {}

  WholeRun run(int rounds = 3, const Slowdown& slowdown = {}) {
    WholeRun whole{.folder = {.manifest = {{"machine", {{"cpu", "x"}}}, {"times_comparable", true}}}};
    const double drift = 1.0 + 0.01 * normal_(random_);
    for (int scene = 0; scene < 36; ++scene) {
      for (int level = 0; level < 17; ++level) {
        const double seconds = 2e-5 * std::pow(2.0, level) * (1.0 + 0.1 * (scene % 5));
        Record record = test::good_record(fmt::format("scene-{}", scene), fmt::format("method-{}", level % 6),
                                          fmt::format("n={}", level), 1e-3, seconds);
        const double factor = drift * (slowdown ? slowdown(record) : 1.0);
        record.seconds = measured(factor * seconds, rounds);
        whole.records.push_back(std::move(record));
      }
    }
    return whole;
  }

 private:
  Seconds measured(double seconds, int rounds) {
    const double placement = 1.0 + 0.015 * normal_(random_);
    const double spread = seconds < 1e-3 ? 0.03 : 0.015;
    std::vector<TimedRound> times;
    for (int i = 0; i < rounds; ++i) {
      double round = seconds * placement * (1.0 + spread * std::abs(normal_(random_)));
      if (uniform_(random_) < 0.05) round *= 1.0 + 0.5 * uniform_(random_);
      times.push_back({.setup = 0.2 * round, .solve = 0.8 * round});
    }
    return summarise(times);
  }

  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

bool anything_significant(const Comparison& comparison) {
  return !comparison.changes.empty() ||
         std::any_of(comparison.methods.begin(), comparison.methods.end(),
                     [](const MethodTimes& m) { return m.verdict != TimeChange::none; });
}

bool told_slower(const Comparison& comparison, const std::string& method) {
  return std::any_of(comparison.methods.begin(), comparison.methods.end(), [&](const MethodTimes& m) {
    return m.method == method && m.verdict == TimeChange::slower;
  });
}

TEST(CompareRuns, FindsNoDifferenceBetweenAProgramAndItselfInNineteenOfTwentyRepeats) {
  Machine machine(1);
  int alarms = 0;
  constexpr int kRepeats = 200;
  for (int i = 0; i < kRepeats; ++i)
    alarms += anything_significant(compare_runs(machine.run(), machine.run())) ? 1 : 0;
  EXPECT_LE(alarms, kRepeats / 20);
}

TEST(CompareRuns, SeesAMethodThatIsTwentyPercentSlower) {
  Machine machine(2);
  const Slowdown slowdown = [](const Record& r) { return r.method == "method-2" ? 1.2 : 1.0; };
  constexpr int kRepeats = 40;
  int seen = 0, others = 0;
  for (int i = 0; i < kRepeats; ++i) {
    const Comparison comparison = compare_runs(machine.run(), machine.run(3, slowdown));
    seen += told_slower(comparison, "method-2") ? 1 : 0;
    others += told_slower(comparison, "method-3") ? 1 : 0;
    EXPECT_TRUE(has_regression(comparison));
  }
  EXPECT_EQ(seen, kRepeats);
  EXPECT_EQ(others, 0);
}

TEST(CompareRuns, SeesNoChangeOfAMethodThatIsTwoPercentSlower) {
  Machine machine(5);
  const Slowdown slowdown = [](const Record& r) { return r.method == "method-2" ? 1.02 : 1.0; };
  constexpr int kRepeats = 40;
  int alarms = 0;
  for (int i = 0; i < kRepeats; ++i)
    alarms += anything_significant(compare_runs(machine.run(), machine.run(3, slowdown))) ? 1 : 0;
  EXPECT_LE(alarms, kRepeats / 20);
}

TEST(CompareRuns, SeesOneCaseThatIsTwentyPercentSlower) {
  Machine machine(3);
  const std::string slow = "scene-7/method-4[n=10]";
  const Slowdown slowdown = [&](const Record& r) { return r.case_id == slow ? 1.2 : 1.0; };
  constexpr int kRepeats = 40;
  int seen = 0;
  for (int i = 0; i < kRepeats; ++i) {
    const Comparison comparison = compare_runs(machine.run(9), machine.run(9, slowdown));
    seen += std::any_of(comparison.changes.begin(), comparison.changes.end(), [&](const CaseChange& change) {
      return change.case_id == slow && change.kind == ChangeKind::slower;
    });
  }
  EXPECT_GE(seen, kRepeats * 9 / 10);
}

TEST(CompareRuns, SeesAProgramThatIsTwentyPercentFaster) {
  Machine machine(4);
  const Comparison comparison =
      compare_runs(machine.run(), machine.run(3, [](const Record&) { return 1.0 / 1.2; }));
  for (const MethodTimes& method : comparison.methods) EXPECT_EQ(method.verdict, TimeChange::faster);
  EXPECT_FALSE(has_regression(comparison));
}

WholeRun run_of(std::vector<Record> records) {
  return {.folder = {.path = "run", .manifest = {{"machine", {{"cpu", "x"}}}}},
          .records = std::move(records)};
}

Comparison after(const std::function<void(Record&)>& spoil) {
  Record record = test::good_record("s", "m", "n=1", 1e-3, 0.1);
  const WholeRun before = run_of({record});
  spoil(record);
  return compare_runs(before, run_of({record}));
}

TEST(CompareRuns, TellsBrokenFromLessAccurate) {
  const auto kind = [](const Comparison& c) {
    return c.changes.size() == 1 ? change_name(c.changes[0].kind) : "";
  };
  EXPECT_EQ(kind(after([](Record& r) { r.status = Status::crashed; })), "broken");
  EXPECT_EQ(kind(after([](Record& r) { r.status = Status::timeout; })), "broken");
  EXPECT_EQ(kind(after([](Record& r) { r.status = Status::inaccurate; })), "less accurate");
  EXPECT_EQ(kind(after([](Record& r) { r.certificate.status = CertificateStatus::uncertified; })),
            "less accurate");
  EXPECT_EQ(kind(after([](Record& r) { r.errors.x_l2 = 1.6e-3; })), "less accurate");
  EXPECT_EQ(kind(after([](Record& r) { r.errors.x_l2 = 0.5e-3; })), "more accurate");
  EXPECT_EQ(kind(after([](Record& r) { r.errors.x_l2 = 1.4e-3; })), "");
  EXPECT_TRUE(has_regression(after([](Record& r) { r.errors.x_l2 = 1.6e-3; })));
  EXPECT_FALSE(has_regression(after([](Record& r) { r.errors.x_l2 = 0.5e-3; })));
}

TEST(CompareRuns, CountsARecordThatIsGoneAsBroken) {
  const Record record = test::good_record("s", "m", "n=1", 1e-3, 0.1);
  const Comparison comparison = compare_runs(run_of({record}), run_of({}));
  ASSERT_EQ(comparison.changes.size(), 1U);
  EXPECT_EQ(comparison.changes[0].kind, ChangeKind::broken);
}

TEST(CompareRuns, ComparesNoTimesOfDifferentMachinesOrOfCasesSideBySide) {
  const Record fast = test::good_record("s", "m", "n=1", 1e-3, 0.1);
  Record slow = test::good_record("s", "m", "n=1", 1e-3, 10.0);
  WholeRun other = run_of({slow});
  EXPECT_EQ(compare_runs(run_of({fast}), other).timed, 1U);
  other.folder.manifest["machine"]["cpu"] = "y";
  EXPECT_EQ(compare_runs(run_of({fast}), other).timed, 0U);
  EXPECT_EQ(compare_runs(run_of({fast}), other).remarks.size(), 1U);
  slow.seconds->jobs = 2;
  EXPECT_EQ(compare_runs(run_of({fast}), run_of({slow})).timed, 0U);
}

TEST(CompareRuns, NotesWorkThatChanged) {
  const Comparison comparison = after([](Record& r) { r.work.counts.pivots = 99; });
  ASSERT_EQ(comparison.remarks.size(), 1U);
  EXPECT_EQ(comparison.remarks[0], "s/m[n=1]: pivots 12 became 99");
  EXPECT_FALSE(has_regression(comparison));
}

}  // namespace
}  // namespace signorini::comparison_test
