#include "harness/sweep/frequency_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "harness/failure.hpp"
#include "harness/interrupt.hpp"
#include "harness/records/trajectory_json.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

namespace {

/// Instants of an answer from which the next solve starts, and at which its extremes are read.
constexpr int kSweepInstants = 4096;

void require_end(const char* name, double value) {
  if (!std::isfinite(value) || !(value > 0.0))
    throw UsageError(fmt::format("{} = {} (must be a positive number of rad/s)", name, value));
}

/// The motion with its time stretched by `factor`: a start, no answer.
std::shared_ptr<const SampledTrajectory> stretched(const Record& record, double factor) {
  SampledTrajectory::Data data = trajectory_of(*record.period, *record.trajectory)->data();
  data.period *= factor;
  data.samples.velocity /= factor;
  for (Impulse& impulse : data.impulses) impulse.time *= factor;
  return std::make_shared<SampledTrajectory>(std::move(data));
}

SweepPoint point_of(const Record& record, double frequency, bool back) {
  SweepPoint point{.frequency = frequency, .back = back, .status = record.status, .message = record.message};
  point.contact_ratio = record.physics.contact_ratio;
  point.stable = record.certificate.stable;
  if (!record.trajectory) return point;
  for (const std::vector<double>& x : record.trajectory->x) {
    const auto [least, largest] = std::minmax_element(x.begin(), x.end());
    point.x_max.push_back(*largest);
    point.amplitude.push_back(0.5 * (*largest - *least));
  }
  return point;
}

bool leads_on(const Record& record) {
  return record.status == Status::converged && record.trajectory && record.period;
}

/// One solve after another.
class Sweep {
 public:
  Sweep(const Scene& scene, const MethodChoice& method, const SweepLimits& limits)
      : scene_(scene),
        method_(method),
        limits_(limits),
        runner_(Limits{.timeout = limits.timeout, .repetitions = 1}) {}

  /// Empty after an interrupt.
  std::optional<SweepPoint> solve(double frequency, bool back) {
    scene_.problem.frequency = frequency;
    std::shared_ptr<const Trajectory> start;
    if (last_) start = stretched(*last_, last_frequency_ / frequency);
    const std::vector cases{make_case(scene_, 0, method_)};
    const std::vector<Job> jobs = runner_.make_jobs(scene_, cases);
    if (jobs.empty()) return std::nullopt;
    const SolveExtras extras{
        .start = start, .samples = kSweepInstants, .timed = false, .certified = limits_.certified};
    const std::optional<Record> record = runner_.run(scene_, jobs.front(), extras);
    if (!record) return std::nullopt;
    if (leads_on(*record)) {
      last_ = *record;
      last_frequency_ = frequency;
    }
    return point_of(*record, frequency, back);
  }

 private:
  Scene scene_;
  MethodChoice method_;
  SweepLimits limits_;
  Runner runner_;
  std::optional<Record> last_ = {};
  double last_frequency_ = 1.0;  // of the load behind it
};

}  // namespace

std::vector<double> sweep_frequencies(const SweepRange& range) {
  require_end("from", range.from);
  require_end("to", range.to);
  if (range.from == range.to) throw UsageError(fmt::format("to = {} (must differ from --from)", range.to));
  if (range.points < 2) throw UsageError(fmt::format("points = {} (must be 2 or more)", range.points));
  std::vector<double> frequencies;
  for (int i = 0; i < range.points; ++i) {
    const double share = static_cast<double>(i) / (range.points - 1);
    frequencies.push_back(range.logarithmic ? range.from * std::pow(range.to / range.from, share)
                                            : range.from + share * (range.to - range.from));
  }
  frequencies.back() = range.to;
  return frequencies;
}

std::vector<SweepPoint> frequency_response(const Scene& scene, const MethodChoice& method,
                                           const SweepRange& range, const SweepLimits& limits,
                                           const TakePoint& take) {
  const std::vector<double> there = sweep_frequencies(range);
  std::vector<std::pair<double, bool>> way;
  for (const double frequency : there) way.emplace_back(frequency, false);
  if (range.back) {
    for (auto frequency = there.rbegin(); frequency != there.rend(); ++frequency)
      way.emplace_back(*frequency, true);
  }
  Sweep sweep(scene, method, limits);
  std::vector<SweepPoint> points;
  for (const auto& [frequency, back] : way) {
    if (interrupted()) break;
    std::optional<SweepPoint> point = sweep.solve(frequency, back);
    if (!point) break;
    if (take) take(*point);
    points.push_back(std::move(*point));
  }
  return points;
}

}  // namespace signorini
