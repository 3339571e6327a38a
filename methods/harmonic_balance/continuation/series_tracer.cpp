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

class SeriesTracer final : public CurveTracer<SeriesStart> {
 public:
  SeriesTracer(const SeriesFamily& family, const SeriesStart& start, const CurveLimits& limits,
               const FollowedCurves& followed, bool doublings)
      : CurveTracer(start, limits, followed),
        steps_(family, start.multiple, limits, doublings),
        series_(steps_.series()) {
    result().branch.sequence = fmt::format("order {}, {} harmonics", series_.order(), series_.harmonics());
  }

  [[nodiscard]] std::vector<Eigen::VectorXd> take_grazings() { return std::move(grazings_); }

 private:
  [[nodiscard]] const SeriesStation& station() const { return steps_.here(); }
  [[nodiscard]] double length() const override { return steps_.length(); }
  [[nodiscard]] bool is_leaving() const { return start().leaves_another() && has_one_point(); }

  void begin() override {
    if (!steps_.begin(start())) return finish("the structure resonates undamped");
    append();
  }

  void append() {
    SolutionPoint point = solution_point(series_);
    if (limits().phases > 0)
      point.motion = sample_series(series_.motion(), limits().phases * series_.order());
    // Intervals of contact.
    const auto count = std::reduce(station().intervals.begin(), station().intervals.end());
    CurveTracer::append(std::move(point), station().x, station().slope, count);
  }

  void advance() override {
    auto step = steps_.attempt();
    if (steps_.outside()) return finish("end of the interval");
    if (!step) return;
    if (const int p = divisor(step->next); p > 0) return end_at_smaller_period(p);
    const bool leaves = step->leaves;
    take_events(*step);
    accept(std::move(*step));
    if (leaves && !is_done()) finish("end of the interval");
  }

  // The prime by which the period divides at the end of the step, or on it; 0: none.
  int divisor(const SeriesStation& next) {
    const bool leaving = start().leaves_repetition && has_one_point();
    for (const int p : prime_factors(start().multiple)) {
      const bool turned =
          unrepeated_part(station().x, series_, p).dot(unrepeated_part(next.x, series_, p)) < 0.0;
      if (steps_.repeats(p) || (!leaving && turned)) return p;
    }
    return 0;
  }

  // What follows are motions of the smaller period, or the same once more, a period later.
  void end_at_smaller_period(int p) {
    constexpr double kNear = 1e-3;
    if (steps_.length() > kNear) return steps_.shorten(0.5);
    if (start().leaves_repetition && has_one_point())
      result().rejected = "the corrector fell back on the branch that was to be left";
    finish(fmt::format("the period divides by {}", p));
  }

  // Special points on the step, and the curves that begin there.
  void take_events(const SeriesStep& step) {
    SeriesEvents events = events_on_step(steps_.curve(), station(), step.length, step.next, is_leaving());
    for (SpecialPoint& special : events.special) add(std::move(special));
    std::move(events.others.begin(), events.others.end(), std::back_inserter(result().others));
    if (events.grazing) grazings_.push_back(*std::move(events.grazing));
  }

  void accept(SeriesStep step) {
    if (!steps_.take(std::move(step))) return finish("the structure resonates undamped");
    append();
    if (station().x.head(series_.size()).norm() > kMostGrown) return finish(kGrown);
    end_if_over();
  }

  SeriesSteps steps_;
  SeriesCurve& series_;  // of the steps
  std::vector<Eigen::VectorXd> grazings_;
};

}  // namespace

TracedSeries trace_series(const SeriesFamily& family, const SeriesStart& start, const CurveLimits& limits,
                          const FollowedCurves& followed, bool doublings) {
  SeriesTracer tracer(family, start, limits, followed, doublings);
  TracedBranch<SeriesStart> traced = tracer.run();
  return {std::move(traced), tracer.take_grazings()};
}

}  // namespace signorini
