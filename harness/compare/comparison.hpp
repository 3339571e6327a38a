#pragma once
// What got slower, less accurate or broken between two runs of the same cases, and which differences of times
// are more than noise.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "harness/records/record.hpp"
#include "harness/run_folder/run_folder.hpp"

namespace signorini {

/// A smaller change of a single case is never reported, however small its standard error; the second factor
/// applies to runs of fewer rounds than kManyRounds, all of which other processes may have slowed.
inline constexpr double kCaseFactor = 1.10;
inline constexpr double kCaseFactorFewRounds = 1.50;
inline constexpr int kManyRounds = 5;
/// No single case is judged by fewer rounds, or by rounds without any spread: they do not show the noise.
inline constexpr int kFewestRounds = 3;
/// The same for a method as a whole.
inline constexpr double kMethodFactor = 1.05;
/// Probability that a comparison of a program with itself reports a difference, over all cases and methods.
inline constexpr double kFalseAlarm = 0.01;
/// Errors may differ by this factor, or lie below ten error bars in both runs.
inline constexpr double kErrorFactor = 1.5;

/// Times of one case in two runs.
struct TimePair {
  std::string case_id = {};
  std::string method = {};
  Seconds before = {}, after = {};
};

enum class TimeChange { faster, none, slower };

/// One verdict per pair. Slower are those whose minimum and median both grew by kCaseFactor, all of whose
/// rounds are slower than the old median, and whose median's logarithm changed by more than the normal
/// quantile of kFalseAlarm, divided by the number of cases (Bonferroni), times its standard error. That error
/// is the largest of three: from both MADs of the case, from the usual MAD of all cases, and from the spread
/// of the changes of all cases. Faster: the same with the runs exchanged.
std::vector<TimeChange> judge_cases(std::span<const TimePair> pairs);

/// A method over all of its cases.
struct MethodTimes {
  std::string method = {};
  std::size_t cases = 0;
  double ratio = 1.0;        ///< median over cases of new over old median
  double probability = 1.0;  ///< of the sign test: that so many cases change by kMethodFactor by chance
  TimeChange verdict = TimeChange::none;
};

/// Sign test per method, each change counted by the smaller of minimum's and median's; exact, and free of any
/// assumption on the noise but its symmetry. Methods by name.
std::vector<MethodTimes> judge_methods(std::span<const TimePair> pairs);

/// Probability that of n fair coins at least k show heads.
double binomial_tail(std::size_t n, std::size_t k);

/// x with P(|Z| > x) = p for a standard normal Z, 0 < p < 1.
double normal_quantile(double p);

enum class ChangeKind { broken, less_accurate, slower, repaired, more_accurate, faster };

/// "broken", "less accurate", ...
std::string_view change_name(ChangeKind kind);

struct CaseChange {
  std::string case_id = {};
  ChangeKind kind = ChangeKind::broken;
  std::string detail = {};  ///< what was and what is
};

struct Comparison {
  std::size_t cases = 0;                  ///< in both runs
  std::size_t timed = 0;                  ///< of these, with comparable times
  std::vector<CaseChange> changes = {};   ///< by kind, worst first, then as in the first run
  std::vector<MethodTimes> methods = {};  ///< empty where times are not comparable
  std::vector<std::string> remarks = {};  ///< cases of one run only, work counted, why times are not compared
};

/// A run with all its records.
struct WholeRun {
  RunFolder folder = {};
  std::vector<Record> records = {};  ///< those that count
};

/// \throws UsageError if it is no folder that a run wrote, or a file of it is unreadable
WholeRun read_whole_run(const std::filesystem::path& folder);

/// The first run is the one of before. A case is broken that converged and ends otherwise, or has no record;
/// it is less accurate where the harness finds it inaccurate, its certificate is lost, or its error grew by
/// kErrorFactor and is above ten error bars; a response where response_change finds it worse. Times are
/// compared if both runs are of the same machine, one case at a time.
Comparison compare_runs(const WholeRun& before, const WholeRun& after);

/// Something is broken, less accurate or slower.
bool has_regression(const Comparison& comparison);

/// Shares of length may differ by this much.
inline constexpr double kShareTolerance = 0.01;

/// A difference of two responses.
struct ResponseChange {
  bool worse = false;       ///< less is found, more is false, or fewer points are located
  std::string detail = {};  ///< what was and what is
};

/// How a response differs, first in the share of the exact one that it finds, then in the share of its own
/// that is false, each by more than kShareTolerance, then in how many special points it located, of those
/// there are; nothing where it does not.
std::optional<ResponseChange> response_change(const RecordedResponse& before, const RecordedResponse& after);

}  // namespace signorini
