#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <map>

#include "harness/compare/comparison.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

/// Standard deviation of a normal variable over its median absolute deviation.
constexpr double kNormalMad = 1.4826;
/// Standard error of a median of n over that of a mean, large n: sqrt(pi / 2).
constexpr double kMedianError = 1.2533;

/// Relative standard error of the median of rounds; 0 for a single round, which has no spread.
double relative_error(const Seconds& seconds) {
  // sigma = 1.4826 MAD for normal rounds; the median of n of them has the standard error 1.2533 sigma /
  // sqrt(n).
  return kNormalMad * kMedianError * seconds.mad / seconds.median / std::sqrt(seconds.repetitions);
}

/// Changes of the logarithm of a time.
struct Change {
  double median = 0.0, min = 0.0;

  /// The one nearer to none; none if they disagree on the direction.
  [[nodiscard]] double sure() const {
    if (median * min <= 0.0) return 0.0;
    return std::abs(median) < std::abs(min) ? median : min;
  }
};

Change change_of(const TimePair& pair) {
  return {.median = std::log(pair.after.median / pair.before.median),
          .min = std::log(pair.after.min / pair.before.min)};
}

/// All rounds of one are slower than the middle one of the other.
bool apart(const TimePair& pair) {
  return pair.after.min > pair.before.median || pair.before.min > pair.after.median;
}

int rounds_of(const TimePair& pair) { return std::min(pair.before.repetitions, pair.after.repetitions); }

double least_factor(const TimePair& pair) {
  return rounds_of(pair) >= kManyRounds ? kCaseFactor : kCaseFactorFewRounds;
}

/// Errors that no single case may fall below, since three rounds may agree by chance.
double usual_error(std::span<const TimePair> pairs, const std::vector<Change>& changes) {
  std::vector<double> errors, medians;
  for (const TimePair& pair : pairs)
    errors.push_back(std::hypot(relative_error(pair.before), relative_error(pair.after)));
  for (const Change& change : changes) medians.push_back(change.median);
  return std::max(median(errors), kNormalMad * median_deviation(medians));
}

TimeChange direction(double change) { return change > 0.0 ? TimeChange::slower : TimeChange::faster; }

struct Signs {
  std::vector<double> changes;
  std::size_t slower = 0, faster = 0;
};

}  // namespace

double binomial_tail(std::size_t n, std::size_t k) {
  if (k == 0) return 1.0;
  if (k > n) return 0.0;
  const boost::math::binomial coins(static_cast<double>(n), 0.5);
  return cdf(complement(coins, static_cast<double>(k) - 1.0));  // of more than k - 1 heads
}

double normal_quantile(double p) {
  return quantile(complement(boost::math::normal(), 0.5 * p));  // half of p in each tail
}

std::vector<TimeChange> judge_cases(std::span<const TimePair> pairs) {
  std::vector<TimeChange> verdicts(pairs.size(), TimeChange::none);
  if (pairs.empty()) return verdicts;
  std::vector<Change> changes;
  for (const TimePair& pair : pairs) changes.push_back(change_of(pair));
  const double usual = usual_error(pairs, changes);
  // Bonferroni: with n cases each at kFalseAlarm / n, the chance of any false alarm stays below kFalseAlarm.
  const double errors = normal_quantile(kFalseAlarm / static_cast<double>(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double own = std::hypot(relative_error(pairs[i].before), relative_error(pairs[i].after));
    const double error = std::max(own, usual);
    if (rounds_of(pairs[i]) < kFewestRounds || error == 0.0) continue;
    const double sure = changes[i].sure();
    if (std::abs(sure) < std::log(least_factor(pairs[i])) || !apart(pairs[i])) continue;
    if (std::abs(changes[i].median) > errors * error) verdicts[i] = direction(sure);
  }
  return verdicts;
}

std::vector<MethodTimes> judge_methods(std::span<const TimePair> pairs) {
  std::map<std::string, Signs> methods;
  for (const TimePair& pair : pairs) {
    Signs& signs = methods[pair.method];
    const Change change = change_of(pair);
    signs.changes.push_back(change.median);
    if (change.sure() > std::log(kMethodFactor)) ++signs.slower;
    if (change.sure() < -std::log(kMethodFactor)) ++signs.faster;
  }
  std::vector<MethodTimes> judged;
  for (const auto& [method, signs] : methods) {
    const std::size_t n = signs.changes.size(), most = std::max(signs.slower, signs.faster);
    MethodTimes times{.method = method, .cases = n, .ratio = std::exp(median(signs.changes))};
    // Without a change slower and faster are as likely as heads and tails; both tails count.
    times.probability = std::min(1.0, 2.0 * binomial_tail(n, most));
    if (times.probability < kFalseAlarm / static_cast<double>(methods.size()))
      times.verdict = signs.slower > signs.faster ? TimeChange::slower : TimeChange::faster;
    judged.push_back(times);
  }
  return judged;
}

}  // namespace signorini
