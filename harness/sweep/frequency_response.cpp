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

/// Instants of an answer from which the next solve starts: of many contacts fewer, as many as marching has.
int instants_kept(const Problem& problem) {
  constexpr int kMost = 4096, kFewest = 256, kOfAllContacts = 1 << 17;
  return std::clamp(kOfAllContacts / std::max(1, problem.contact_count()), kFewest, kMost);
}

/// The motion with its time stretched by `factor`: a start, no answer.
std::shared_ptr<const SampledTrajectory> stretched(const Record& record, double factor) {
  SampledTrajectory::Data data = trajectory_of(*record.period, *record.trajectory)->data();
  data.period *= factor;
  data.samples.velocity /= factor;
  for (Impulse& impulse : data.impulses) impulse.time *= factor;
  if (data.events) {
    for (ContactEvent& event : *data.events) event.time *= factor;
  }
  return std::make_shared<SampledTrajectory>(std::move(data));
}

SweepPoint point_of(const Record& record, double frequency, bool down) {
  SweepPoint point{.frequency = frequency, .down = down, .status = record.status, .message = record.message};
  point.contact_ratio = record.physics.contact_ratio;
  point.stable = record.certificate.stable;
  point.undefined = record.certificate.undefined;
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

/// The solves of a sweep: each starts from the last answer that was found, its time stretched to the new
/// period; cold where none was found.
class SweepSolves final : public SolveSeries {
 public:
  SweepSolves(const Scene& scene, std::vector<double> frequencies, Deadline end)
      : scene_(scene), frequencies_(std::move(frequencies)), end_(end) {
    scene_.problem = at_frequency(std::move(scene_.problem), frequencies_.front());
  }

  [[nodiscard]] const Scene& scene() const override { return scene_; }
  [[nodiscard]] std::shared_ptr<const Trajectory> start() const override {
    return answer_ ? stretched(*answer_, answered_ / scene_.problem.frequency) : nullptr;
  }
  bool go_on(const Record& record) override {
    if (record.status == Status::converged && record.trajectory && record.period) {
      answer_ = record;
      answered_ = scene_.problem.frequency;
    }
    if (++next_ == frequencies_.size() || end_.passed()) return false;
    scene_.problem = at_frequency(std::move(scene_.problem), frequencies_[next_]);
    return true;
  }

 private:
  Scene scene_;
  std::vector<double> frequencies_;
  Deadline end_;
  std::size_t next_ = 0;
  std::optional<Record> answer_ = {};
  double answered_ = 1.0;  // frequency of the load behind it
};

std::string way_name(const SweepPoint& point) { return point.down ? "down" : "up"; }

}  // namespace

void require_frequency(const char* name, double value) {
  if (!std::isfinite(value) || !(value > 0.0))
    throw UsageError(fmt::format("{} = {} (must be a positive number of rad/s)", name, value));
}

void require_interval(const char* from_name, double from, const char* to_name, double to) {
  for (const auto& [name, value] : {std::pair(from_name, from), std::pair(to_name, to)})
    if (!std::isfinite(value)) throw UsageError(fmt::format("{} = {} (must be finite)", name, value));
  if (from == to) throw UsageError(fmt::format("{} = {} (must differ from --{})", to_name, to, from_name));
}

std::vector<double> sweep_frequencies(const SweepRange& range) {
  require_frequency("from", range.from);
  require_frequency("to", range.to);
  if (!range.at.empty()) {
    for (const double value : range.at) require_frequency("at", value);
    return range.at;
  }
  require_interval("from", range.from, "to", range.to);
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
  std::vector<SweepPoint> points;
  if (limits.deadline.passed()) return points;
  Runner runner(Limits{.timeout = limits.timeout, .memory_mb = limits.memory_mb, .repetitions = 1});
  const SolveExtras extras{.samples = instants_kept(scene.problem),
                           .timed = false,
                           .certified = limits.certified,
                           .measured = limits.certified,  // a point tells the contact ratio alone
                           .summary = SummaryRequest{.harmonics = 0}};
  const auto take_record = [&](const Record& record) {
    const bool back = points.size() >= first.size();
    points.push_back(point_of(record, way[points.size()], back != (range.to < range.from)));
    if (take) take(points.back());
  };
  SweepSolves solves(scene, way, limits.deadline);
  for (bool more = true; more;) {
    const std::vector cases{make_case(solves.scene(), 0, method)};
    const std::vector<Job> jobs = runner.make_jobs(solves.scene(), cases);
    more = !jobs.empty() && runner.run_series(jobs.front(), solves, take_record, extras);
  }
  return points;
}

Cell number_cell(const Measure& value, int digits) {
  return value ? Cell(fmt::format("{:.{}g}", *value, digits), *value) : Cell("-");
}

Cell largest_cell(const std::vector<double>& values, int digits) {
  return number_cell(values.empty() ? Measure{} : std::ranges::max(values), digits);
}

Cell stability_cell(const SweepPoint& point) {
  const std::string word = stability_word(point.stable, point.undefined);
  return word.empty() ? "-" : word;
}

Table response_table(const std::vector<SweepPoint>& points, bool certified, const std::string& other_law) {
  constexpr int kDigits = 6;
  Table table;
  table.header = {"omega [rad/s]", "way", "status", "x max [m]", "amplitude [m]", "contact ratio"};
  if (certified) table.header.emplace_back("stability");
  if (!other_law.empty()) table.header.emplace_back("other law");
  for (const SweepPoint& point : points) {
    std::vector<Cell> row{number_cell(point.frequency, kDigits),  way_name(point),
                          std::string(status_name(point.status)), largest_cell(point.x_max, kDigits),
                          largest_cell(point.amplitude, kDigits), number_cell(point.contact_ratio, kDigits)};
    if (certified) row.push_back(stability_cell(point));
    if (!other_law.empty()) row.emplace_back(other_law);
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
  const std::string word = stability_word(point.stable, point.undefined);
  if (!word.empty()) json["stability"] = word;
  if (!point.undefined.empty()) json["stability_reason"] = point.undefined;
  return json;
}

}  // namespace signorini
