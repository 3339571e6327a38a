#include "methods/harmonic_balance/continuation/series_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/harmonic_balance/continuation/series_events.hpp"
#include "methods/harmonic_balance/continuation/series_point.hpp"

namespace signorini {

namespace {

std::vector<int> prime_factors(int n) {
  std::vector<int> factors;
  for (int p = 2; p <= n; ++p) {
    if (n % p != 0) continue;
    factors.push_back(p);
    while (n % p == 0) n /= p;
  }
  return factors;
}

class SeriesTracer {
 public:
  SeriesTracer(const SeriesFamily& family, const SeriesStart& start, const CurveLimits& limits,
               bool doublings, const KnownSeries& known)
      : start_(start),
        limits_(limits),
        known_(known),
        steps_(family, start.multiple, limits, doublings),
        series_(steps_.series()) {}

  TracedSeries run() {
    result_.multiple = start_.multiple;
    result_.branch.sequence = fmt::format("order {}, {} harmonics", series_.order(), series_.harmonics());
    result_.branch.began = start_.origin;
    if (steps_.begin(start_))
      append();
    else
      finish("the structure resonates undamped");
    while (!done_) advance();
    if (result_.branch.points.size() < 2 && result_.rejected.empty()) result_.rejected = result_.branch.ended;
    return std::move(result_);
  }

 private:
  [[nodiscard]] const SeriesStation& here() const { return steps_.here(); }

  void append() {
    SolutionPoint point = solution_point(series_);
    if (limits_.phases > 0) point.motion = sample_series(series_.motion(), limits_.phases * series_.order());
    result_.branch.points.push_back(std::move(point));
    result_.points.x.push_back(here().x);
    result_.points.tangents.push_back(here().slope);
    result_.points.labels.push_back(intervals());
  }

  // Of contact, at the last point.
  [[nodiscard]] std::size_t intervals() const {
    return std::accumulate(here().intervals.begin(), here().intervals.end(), std::size_t{0});
  }

  void finish(std::string reason) {
    result_.branch.ended = std::move(reason);
    done_ = true;
  }

  // One attempt at a step: taken, or shortened.
  void advance() {
    constexpr double kShortest = 1e-6;  // below, the curve has broken
    if (limits_.expired()) return finish("the time is up");
    if (steps_.length() < kShortest) {
      const double frequency = here().x[series_.size()] * series_.family().frequency_unit;
      return finish(fmt::format("the curve breaks at {:.10g} rad/s", frequency));
    }
    auto step = steps_.attempt();
    if (steps_.outside()) return finish("end of the interval");
    if (!step) return;
    if (const int p = divisor(step->next); p > 0) return end_at_smaller_period(p);
    const bool leaves = step->leaves;
    take_events(*step);
    accept(std::move(*step));
    if (leaves && !done_) finish("end of the interval");
  }

  // The prime by which the period divides at the end of the step, or on it; 0: none.
  int divisor(const SeriesStation& next) {
    const std::vector<int> factors = prime_factors(start_.multiple);
    const bool leaving = start_.leaves_repetition && result_.points.x.size() == 1;
    for (const int p : factors) {
      const bool turned =
          unrepeated_part(here().x, series_, p).dot(unrepeated_part(next.x, series_, p)) < 0.0;
      if (steps_.repeats(p) || (!leaving && turned)) return p;
    }
    return 0;
  }

  // What follows are motions of the smaller period, or the same once more, a period later.
  void end_at_smaller_period(int p) {
    constexpr double kNear = 1e-3;
    if (steps_.length() > kNear) return steps_.shorten(0.5);
    if (start_.leaves_repetition && result_.points.x.size() == 1)
      result_.rejected = "the corrector fell back on the branch that was to be left";
    finish(fmt::format("the period divides by {}", p));
  }

  // Special points on the step, and the curves that begin there.
  void take_events(const SeriesStep& step) {
    const bool leaving =
        (start_.leaves_repetition || (start_.crossed.size() > 0)) && result_.points.x.size() == 1;
    SeriesEvents events = events_on_step(steps_.curve(), here(), step.length, step.next, leaving);
    for (SpecialPoint& special : events.special) {
      special.after = result_.points.x.size();
      result_.branch.special.push_back(std::move(special));
    }
    std::move(events.others.begin(), events.others.end(), std::back_inserter(result_.others));
    if (events.grazing) result_.grazings.push_back(*std::move(events.grazing));
  }

  void accept(SeriesStep step) {
    if (!steps_.take(std::move(step))) return finish("the structure resonates undamped");
    append();
    constexpr double kUnbounded = 60.0;  // of |x|
    if (here().x.head(series_.size()).norm() > kUnbounded) return finish("the motion grows without bound");
    if (static_cast<int>(result_.points.x.size()) >= limits_.max_points)
      return finish(fmt::format("limit of {} points", limits_.max_points));
    meets();
  }

  // Whether the branch has come to itself, perhaps a period of the scene later, or to another one.
  void meets() {
    for (int shift = 0; shift < start_.multiple; ++shift) {
      const double share = static_cast<double>(shift) / start_.multiple;
      const Eigen::VectorXd later = begun_later(here().x, series_.harmonics(), share);
      if (result_.points.passed_before(later, rounding_of(later), intervals()))
        return finish("the branch meets itself");
    }
    constexpr std::size_t kLeft = 10;  // points, after which a branch has left the one on which it began
    if (result_.points.x.size() > kLeft && known_(here().x, intervals()))
      finish("the branch meets one that was followed before");
  }

  const SeriesStart& start_;
  const CurveLimits& limits_;
  const KnownSeries& known_;
  SeriesSteps steps_;
  SeriesCurve& series_;  // of the steps
  bool done_ = false;
  TracedSeries result_;
};

}  // namespace

TracedSeries trace_series(const SeriesFamily& family, const SeriesStart& start, const CurveLimits& limits,
                          bool doublings, const KnownSeries& known) {
  return SeriesTracer(family, start, limits, doublings, known).run();
}

}  // namespace signorini
