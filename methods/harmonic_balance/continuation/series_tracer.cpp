#include "methods/harmonic_balance/continuation/series_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "methods/continuation/arc_length.hpp"
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

// The length of a step, at whose end the curve is evaluated, up to where the frequency takes a value.
std::optional<double> length_to(SeriesCurve& curve, const CurveStep& step, double value) {
  const double unit = curve.family().frequency_unit;
  const auto distance = [&](SeriesCurve& at) { return std::optional((at.frequency() - value) / unit); };
  return locate(curve, step, distance, step.x[step.x.size() - 1] - value / unit, *distance(curve));
}

class SeriesTracer {
 public:
  SeriesTracer(const SeriesFamily& family, const SeriesStart& start, const SeriesCurveOptions& options)
      : start_(start), options_(options), curve_(family, start.multiple), step_(options.first_step) {}

  TracedSeries run() {
    result_.multiple = start_.multiple;
    result_.branch.sequence = fmt::format("order {}, {} harmonics", curve_.order(), curve_.harmonics());
    result_.branch.began = start_.origin;
    if (!curve_.evaluate(start_.x)) {
      finish("the structure resonates undamped");
    } else {
      here_ = station(start_.tangent.normalized());
      append();
    }
    while (!done_) advance();
    if (result_.branch.points.size() < 2 && result_.rejected.empty()) result_.rejected = result_.branch.ended;
    return std::move(result_);
  }

 private:
  SeriesStation station(const Eigen::VectorXd& tangent) {
    return series_station(curve_, tangent, options_.doublings);
  }

  void append() {
    BranchPoint point = branch_point(curve_);
    if (options_.phases > 0) point.motion = sample_series(curve_.motion(), options_.phases * curve_.order());
    result_.branch.points.push_back(std::move(point));
    result_.points.x.push_back(here_.x);
    result_.points.tangents.push_back(here_.tangent);
  }

  void finish(std::string reason) {
    result_.branch.ended = std::move(reason);
    done_ = true;
  }

  [[nodiscard]] CurveStep whole_step() const {
    return {.x = here_.x, .tangent = here_.tangent, .length = step_};
  }

  // One attempt at a step: taken, or shortened.
  void advance() {
    constexpr double kTurned = 0.35, kFar = 2.0;  // rad; of the step's length
    if (std::chrono::steady_clock::now() > options_.deadline) return finish("the time is up");
    if (step_ < options_.smallest_step) return press_or_break();
    const auto iterations = correct(curve_, here_.x + step_ * here_.tangent, here_.tangent,
                                    {.iterations = 10, .tolerance = 2e-13});
    if (!iterations || (curve_.x() - here_.x).norm() > kFar * step_) return shorten(0.4);
    const bool beyond = curve_.frequency() < curve_.family().low || curve_.frequency() > curve_.family().high;
    if (beyond && !return_to_bound()) return shorten(0.5);
    if (!beyond && !stop_at_value()) return shorten(0.5);
    const auto tangent = tangent_of(curve_, here_.tangent);
    if (!tangent || tangent->dot(here_.tangent) < std::cos(kTurned) || moves_too_far()) return shorten(0.5);
    SeriesStation next = station(*tangent);
    if (const int p = divisor(next); p > 0) return end_at_smaller_period(p);
    take_events(next);
    accept(std::move(next), *iterations);
    if (beyond && !done_) finish("end of the interval");
  }

  void shorten(double factor) { step_ *= factor; }

  // A branch of few unknown changes, as without contact, still has neighbours for points.
  bool moves_too_far() const {
    constexpr double kShare = 0.1, kSmall = 0.05;  // of the motion; of the unit of displacement
    const double size = std::max(here_.motion.norm(), kSmall * curve_.family().displacement_unit);
    return (curve_.motion() - here_.motion).norm() > kShare * size;
  }

  // Whether the motion at which the curve is evaluated has 1 / p of the period.
  bool repeats(int p) const {
    constexpr double kSame = 1e-7;  // in the units of the unknowns
    return unrepeated_part(curve_.x(), curve_, p).norm() < kSame;
  }

  bool return_to_bound() {
    const SeriesFamily& family = curve_.family();
    const double bound = curve_.frequency() < family.low ? family.low : family.high;
    constexpr double kAtBound = 1e-13;
    if (std::abs(here_.x[curve_.size()] - bound / family.frequency_unit) < kAtBound) {
      finish("end of the interval");
      return false;
    }
    return shorten_to(bound);
  }

  bool shorten_to(double value) {
    const auto length = length_to(curve_, whole_step(), value);
    if (length) step_ = *length;
    return length.has_value();
  }

  // Ends the step at the first of the frequencies at which the curve is to have a point.
  bool stop_at_value() {
    const double before = here_.x[curve_.size()] * curve_.family().frequency_unit, planned = step_;
    const auto value = first_passed(options_.at, before, curve_.frequency());
    if (!value) return true;
    if (!shorten_to(*value)) return false;
    planned_ = planned;
    return true;
  }

  // The prime by which the period divides at the end of the step, or on it; 0: none.
  int divisor(const SeriesStation& next) {
    const std::vector<int> factors = prime_factors(start_.multiple);
    const bool leaving = start_.leaves_repetition && result_.points.x.size() == 1;
    for (const int p : factors) {
      const bool turned = unrepeated_part(here_.x, curve_, p).dot(unrepeated_part(next.x, curve_, p)) < 0.0;
      if (repeats(p) || (!leaving && turned)) return p;
    }
    return 0;
  }

  // What follows are motions of the smaller period, or the same once more, a period later.
  void end_at_smaller_period(int p) {
    constexpr double kNear = 1e-3;
    if (step_ > kNear) return shorten(0.5);
    if (start_.leaves_repetition && result_.points.x.size() == 1)
      result_.rejected = "the corrector fell back on the branch that was to be left";
    finish(fmt::format("the period divides by {}", p));
  }

  // Special points on the step, and the curves that begin there.
  void take_events(const SeriesStation& next) {
    const bool leaving = (start_.leaves_repetition || start_.crosses) && result_.points.x.size() == 1;
    SeriesEvents events = events_on_step(curve_, here_, step_, next, leaving);
    for (SpecialPoint& special : events.special) {
      special.after = result_.points.x.size();
      result_.branch.special.push_back(std::move(special));
    }
    std::move(events.others.begin(), events.others.end(), std::back_inserter(result_.others));
    if (events.grazing) result_.grazings.push_back(*std::move(events.grazing));
  }

  void accept(SeriesStation next, int iterations) {
    if (curve_.x() != next.x && !curve_.evaluate(next.x)) return finish("the structure resonates undamped");
    const double turn = std::acos(std::clamp(next.tangent.dot(here_.tangent), -1.0, 1.0));
    here_ = std::move(next);
    append();
    step_ = std::max(next_step(step_, iterations - 1, turn, options_.largest_step), planned_);
    planned_ = 0.0;
    if (here_.x.head(curve_.size()).norm() > options_.largest_motion)
      return finish("the motion grows without bound");
    if (static_cast<int>(result_.points.x.size()) >= options_.max_points)
      return finish(fmt::format("limit of {} points", options_.max_points));
    meets();
  }

  // Whether the branch has come to itself, perhaps a period of the scene later, or to another one.
  void meets() {
    constexpr std::size_t kNear = 5;    // points, of which the last are neighbours anyway
    constexpr double kRounding = 1e-7;  // in the units of the unknowns
    if (result_.points.x.size() <= 2 * kNear) return;
    const CurvePoints earlier = result_.points.before_last(kNear);
    for (int shift = 0; shift < start_.multiple; ++shift) {
      const double share = static_cast<double>(shift) / start_.multiple;
      if (earlier.pass_by(begun_later(here_.x, curve_.harmonics(), share), kRounding))
        return finish("the branch meets itself");
    }
    if (options_.known && options_.known(here_.x)) finish("the branch meets one that was followed before");
  }

  // Passes a corner of the curve.
  void press_or_break() {
    const double frequency = here_.x[curve_.size()] * curve_.family().frequency_unit;
    const auto beyond = [&] { return passes_to(curve_.x()); };
    const bool pressed = press_further(curve_, here_.x, beyond);
    if (!pressed && !press_less(curve_, here_.x, beyond))
      return finish(fmt::format("the curve breaks at {:.10g} rad/s", frequency));
    const double distance = (curve_.x() - here_.x).norm();
    const auto tangent = tangent_of(curve_, Eigen::VectorXd((curve_.x() - here_.x).normalized()));
    if (!tangent) return finish(fmt::format("the curve breaks at {:.10g} rad/s", frequency));
    step_ = 0.5 * distance;
    here_ = station(*tangent);
    result_.branch.special.push_back(
        {.kind = SpecialKind::grazing,
         .point = branch_point(curve_),
         .text = pressed ? "a contact is born at a corner" : "a contact fades at a corner",
         .after = result_.points.x.size()});
    append();
  }

  // Whether a point beside the last one is not on the way that led there, nor of a smaller period.
  bool passes_to(const Eigen::VectorXd& beyond) {
    constexpr double kSharp = 0.2;  // of the distance
    if (result_.points.pass_by(beyond, kSharp * (beyond - here_.x).norm())) return false;
    const std::vector<int> factors = prime_factors(start_.multiple);
    return std::none_of(factors.begin(), factors.end(), [&](int p) { return repeats(p); });
  }

  const SeriesStart& start_;
  const SeriesCurveOptions& options_;
  SeriesCurve curve_;
  SeriesStation here_;
  double step_, planned_ = 0.0;  // the latter of a step that ended at a frequency asked for
  bool done_ = false;
  TracedSeries result_;
};

}  // namespace

TracedSeries trace_series(const SeriesFamily& family, const SeriesStart& start,
                          const SeriesCurveOptions& options) {
  return SeriesTracer(family, start, options).run();
}

}  // namespace signorini
