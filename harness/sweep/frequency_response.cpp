#include "harness/sweep/frequency_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/run/runner.hpp"

namespace signorini {

namespace {

/// Instants of an answer from which the next solve starts.
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

SweepPoint point_of(const Record& record, double frequency, bool down) {
  SweepPoint point{.frequency = frequency, .down = down, .status = record.status, .message = record.message};
  point.contact_ratio = record.physics.contact_ratio;
  point.stable = record.certificate.stable;
  point.seconds = record.processor.solve;
  if (!record.trajectory) return point;
  if (record.period) point.motion = SweptMotion{.period = *record.period, .x = record.trajectory->x};
  if (!record.motion) return point;
  for (const DisplacementSummary& x : record.motion->x) {
    point.x_max.push_back(x.max);
    point.amplitude.push_back(x.amplitude);
  }
  return point;
}

bool leads_on(const Record& record) {
  return record.status == Status::converged && record.trajectory && record.period;
}

Cell number_cell(const Measure& value) {
  return value ? Cell(fmt::format("{:.6g}", *value), *value) : Cell("-");
}

/// The largest value over the contacts; absent without contacts.
Measure largest(const std::vector<double>& values) {
  return values.empty() ? Measure{} : *std::ranges::max_element(values);
}

std::string_view way_name(const SweepPoint& point) { return point.down ? "down" : "up"; }

std::string stability_text(const SweepPoint& point) {
  if (!point.stable) return "-";
  return *point.stable ? "stable" : "unstable";
}

}  // namespace

std::vector<double> sweep_frequencies(const SweepRange& range) {
  require_end("from", range.from);
  require_end("to", range.to);
  if (!range.at.empty()) {
    for (const double value : range.at) require_end("at", value);
    return range.at;
  }
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
  const std::vector<double> first = sweep_frequencies(range);
  std::vector<double> way = first;
  if (range.back) way.insert(way.end(), first.rbegin(), first.rend());
  Scene shaken = scene;
  Runner runner(Limits{.timeout = limits.timeout, .repetitions = 1});
  SolveExtras extras{.samples = kSweepInstants,
                     .timed = false,
                     .certified = limits.certified,
                     .summary = SummaryRequest{.harmonics = 0}};
  std::optional<Record> last;
  double last_frequency = 1.0;  // of the load behind it
  std::vector<SweepPoint> points;
  for (const double frequency : way) {
    if (std::chrono::steady_clock::now() > limits.deadline) break;
    shaken.problem.frequency = frequency;
    if (last) extras.start = stretched(*last, last_frequency / frequency);
    const std::vector cases{make_case(shaken, 0, method)};
    const std::vector<Job> jobs = runner.make_jobs(shaken, cases);
    const auto record = jobs.empty() ? std::nullopt : runner.run(shaken, jobs.front(), extras);
    if (!record) break;  // interrupted
    const bool back = points.size() >= first.size();
    points.push_back(point_of(*record, frequency, back != (range.to < range.from)));
    if (take) take(points.back());
    if (!leads_on(*record)) continue;
    last = *record;
    last_frequency = frequency;
  }
  return points;
}

Table response_table(const std::vector<SweepPoint>& points, bool certified) {
  Table table;
  table.header = {"omega [rad/s]", "way", "status", "x max [m]", "amplitude [m]", "contact ratio"};
  if (certified) table.header.emplace_back("stability");
  for (const SweepPoint& point : points) {
    std::vector<Cell> row{number_cell(point.frequency),           std::string(way_name(point)),
                          std::string(status_name(point.status)), number_cell(largest(point.x_max)),
                          number_cell(largest(point.amplitude)),  number_cell(point.contact_ratio)};
    if (certified) row.emplace_back(stability_text(point));
    table.rows.push_back(std::move(row));
  }
  return table;
}

nlohmann::ordered_json to_json(const SweepPoint& point) {
  nlohmann::ordered_json json{
      {"frequency", point.frequency}, {"way", way_name(point)}, {"status", status_name(point.status)}};
  if (!point.message.empty()) json["message"] = point.message;
  if (!point.x_max.empty()) json["x_max"] = point.x_max;
  if (!point.amplitude.empty()) json["amplitude"] = point.amplitude;
  if (point.contact_ratio) json["contact_ratio"] = *point.contact_ratio;
  if (point.stable) json["stable"] = *point.stable;
  return json;
}

}  // namespace signorini
