#pragma once
// When two times differ by more than noise.

#include <span>
#include <string>
#include <vector>

#include "harness/records/record.hpp"

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

}  // namespace signorini
