#include "harness/records/sampled_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <utility>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "harness/text/json.hpp"
#include "problems/problem.hpp"

namespace signorini {

namespace {

constexpr double kLargestJudged = 1e150;  // the squares of larger numbers overflow

std::string size_defect(const char* name, const Eigen::MatrixXd& values, Eigen::Index count,
                        Eigen::Index contacts) {
  if (values.rows() != count || values.cols() != contacts) {
    return fmt::format("{} has {} x {} samples, {} x {} were asked for", name, values.rows(), values.cols(),
                       count, contacts);
  }
  if (!values.allFinite()) return fmt::format("{} has values that are not finite", name);
  if (const double largest = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0; largest > kLargestJudged)
    return fmt::format("{} reaches {:.3g}: no measure of it is finite", name, largest);
  return {};
}

/// What is wrong with an impulse or an event; `what` names it.
std::string place_defect(std::string_view what, int contact, double time, double momentum, int contacts,
                         double period) {
  if (contact < 0 || contact >= contacts)
    return fmt::format("{} is at contact {} of {}", what, contact, contacts);
  if (!(std::abs(momentum) <= kLargestJudged) || !(time >= 0.0) || !(time <= period))
    return fmt::format("{} of {} N s is at {} s, outside the period", what, momentum, time);
  return {};
}

/// The largest |momentum| of a list times the round-off that is allowed: stops push, they do not pull.
template <class Listed>
double largest_pull(const std::vector<Listed>& list, double Listed::*momentum) {
  constexpr double kRoundOff = 1e-9;
  double largest = 0.0;
  for (const Listed& one : list) largest = std::max(largest, std::abs(one.*momentum));
  return kRoundOff * largest;
}

/// What is wrong with the impulses and events of a period.
std::string list_defect(const std::vector<Impulse>& impulses,
                        const std::optional<std::vector<ContactEvent>>& listed, int contacts, double period) {
  std::string defect;
  const double impulse_pull = largest_pull(impulses, &Impulse::value);
  for (const Impulse& one : impulses) {
    defect = place_defect("an impulse", one.contact, one.time, one.value, contacts, period);
    if (defect.empty() && one.value > impulse_pull)
      defect = fmt::format("an impulse of {} N s at {} s pulls", one.value, one.time);
    if (!defect.empty()) return defect;
  }
  const std::vector<ContactEvent> events = listed.value_or(std::vector<ContactEvent>{});
  const double event_pull = largest_pull(events, &ContactEvent::impulse);
  double last = 0.0;
  for (const ContactEvent& event : events) {
    const std::string what = fmt::format("the event {}", enum_name(event.kind));
    defect = place_defect(what, event.contact, event.time, event.impulse, contacts, period);
    if (defect.empty() && event.impulse > event_pull)
      defect = fmt::format("{} at {} s pulls with {} N s", what, event.time, event.impulse);
    if (event.push && !(*event.push <= 0.0 && std::isfinite(*event.push)))
      defect = fmt::format("{} at {} s ends a push of {} N s", what, event.time, *event.push);
    if (!defect.empty()) return defect;
    if (event.time < last) return fmt::format("{} at {} s comes after one at {} s", what, event.time, last);
    last = event.time;
  }
  return defect;
}

/// Adds `seconds` to the times of impulses or events, modulo the period.
template <class Timed>
void delay(std::vector<Timed>& items, double seconds, double period) {
  for (Timed& one : items) {
    one.time += seconds;
    if (one.time >= period) one.time -= period;
  }
  std::ranges::stable_sort(items, [](const Timed& a, const Timed& b) { return a.time < b.time; });
}

template <class Timed>
void repeat(std::vector<Timed>& items, int periods, double period) {
  const std::vector<Timed> once = items;
  for (int k = 1; k < periods; ++k) {
    for (Timed one : once) {
      one.time += k * period;
      items.push_back(one);
    }
  }
}

void append(std::string& bytes, std::span<const double> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

void append(std::string& bytes, const Eigen::MatrixXd& values) {
  append(bytes, std::span(values.data(), static_cast<std::size_t>(values.size())));
}

std::vector<std::vector<double>> columns(const Eigen::MatrixXd& values) {
  std::vector<std::vector<double>> lists;
  for (const auto& column : values.colwise()) lists.emplace_back(column.begin(), column.end());
  return lists;
}

Eigen::MatrixXd matrix(const std::vector<std::vector<double>>& lists, std::size_t rows, std::size_t cols) {
  if (lists.size() != cols)
    throw BadRecord("trajectory = uneven (must have as many lists per contact in each part)");
  Eigen::MatrixXd values(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(lists.size()));
  for (std::size_t c = 0; c < lists.size(); ++c) {
    if (lists[c].size() != rows)
      throw BadRecord("trajectory = uneven (must have one value per instant in each list)");
    values.col(static_cast<Eigen::Index>(c)) =
        Eigen::Map<const Eigen::VectorXd>(lists[c].data(), static_cast<Eigen::Index>(rows));
  }
  return values;
}

}  // namespace

SampledTrajectory::SampledTrajectory(Data data) : data_(std::move(data)) {
  const Eigen::Index count = data_.samples.x.rows();
  std::string defect = samples_defect(data_.samples, count, data_.samples.x.cols());
  if (count < 1) defect = "there are no samples";
  if (!(data_.period > 0.0) || !std::isfinite(data_.period)) defect = "the period is not positive";
  if (defect.empty()) defect = list_defect(data_.impulses, data_.events, contact_count(), data_.period);
  if (!defect.empty()) throw std::invalid_argument(fmt::format("trajectory = unusable ({})", defect));
}

SampledTrajectory::SampledTrajectory(const Trajectory& source, int count)
    : SampledTrajectory(Data{source.period(), source.sample(count), source.impulses(), source.bandwidth()}) {}

namespace {

/// Where the velocity or the force of a motion may jump, in steps of its samples, ascending in [0, stored).
std::vector<double> jump_places(const SampledTrajectory::Data& data) {
  const auto stored = static_cast<double>(data.samples.x.rows());
  std::vector<double> places;
  const auto add = [&](double time) {
    const double place = time / data.period * stored;
    places.push_back(place < stored ? place : place - stored);
  };
  for (const Impulse& impulse : data.impulses) add(impulse.time);
  for (const ContactEvent& event : data.events.value_or(std::vector<ContactEvent>{})) add(event.time);
  std::ranges::sort(places);
  return places;
}

/// From one stored instant to the next, and on beyond either. Hermite's cubic
/// x(s) = h00 x_l + h10 step v_l + h01 x_r + h11 step v_r has the stored values and velocities at both ends;
/// velocity and force are straight lines, for where they jump unsaid a cubic would overshoot.
void interpolate(const SampledTrajectory::Data& data, int left, double s, Samples& result, int row) {
  const auto& [x, v, f] = data.samples;
  const auto stored = static_cast<int>(x.rows());
  const double step = data.period / stored;
  const int l = (left + stored) % stored, r = (l + 1) % stored;
  const double h00 = (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), h10 = s * (1.0 - s) * (1.0 - s);
  const double h01 = s * s * (3.0 - 2.0 * s), h11 = s * s * (s - 1.0);
  result.x.row(row) = h00 * x.row(l) + h01 * x.row(r) + step * (h10 * v.row(l) + h11 * v.row(r));
  result.velocity.row(row) = (1.0 - s) * v.row(l) + s * v.row(r);
  result.force.row(row) = (1.0 - s) * f.row(l) + s * f.row(r);
}

}  // namespace

Samples SampledTrajectory::sample(int count) const {
  const auto stored = static_cast<int>(data_.samples.x.rows());
  const Eigen::Index contacts = data_.samples.x.cols();
  Samples result{Eigen::MatrixXd(count, contacts), Eigen::MatrixXd(count, contacts),
                 Eigen::MatrixXd(count, contacts)};
  const std::vector<double> jumps = jump_places(data_);
  // Jumps strictly between a stored instant and the next one.
  const auto jumps_after = [&](int left) {
    const double begin = (left + stored) % stored;
    const auto first = std::ranges::upper_bound(jumps, begin),
               last = std::ranges::lower_bound(jumps, begin + 1.0);
    return first < last ? std::span(first, last) : std::span<const double>{};
  };
  for (int i = 0; i < count; ++i) {
    // Whole numbers, so that an instant that is stored is met exactly.
    const long place = static_cast<long>(i) * stored;
    const auto left = static_cast<int>(place / count);
    const double s = static_cast<double>(place % count) / count;
    const auto inside = jumps_after(left);
    if (s == 0.0 || inside.empty()) {
      interpolate(data_, left, s, result, i);
    } else if (left + s < inside.front() && jumps_after(left - 1).empty()) {
      interpolate(data_, left - 1, 1.0 + s, result, i);
    } else if (left + s >= *std::prev(inside.end()) && jumps_after(left + 1).empty()) {
      interpolate(data_, left + 1, s - 1.0, result, i);
    } else {
      interpolate(data_, left, s, result, i);
    }
  }
  if (!jumps.empty()) result.force = result.force.cwiseMin(data_.samples.force.maxCoeff());
  return result;
}

SampledTrajectory delayed(const SampledTrajectory& motion, double share) {
  SampledTrajectory::Data data = motion.data();
  const Eigen::Index count = data.samples.x.rows();
  const auto late = static_cast<Eigen::Index>(std::lround(share * static_cast<double>(count))) % count;
  for (Eigen::MatrixXd* values : {&data.samples.x, &data.samples.velocity, &data.samples.force}) {
    for (auto column : values->colwise()) std::rotate(column.begin(), column.end() - late, column.end());
  }
  const double seconds = data.period * static_cast<double>(late) / static_cast<double>(count);
  delay(data.impulses, seconds, data.period);
  if (data.events) delay(*data.events, seconds, data.period);
  return SampledTrajectory(std::move(data));
}

SampledTrajectory repeated(const SampledTrajectory& motion, int periods) {
  const SampledTrajectory::Data& once = motion.data();
  SampledTrajectory::Data data = once;
  data.period = periods * once.period;
  data.samples = {once.samples.x.replicate(periods, 1), once.samples.velocity.replicate(periods, 1),
                  once.samples.force.replicate(periods, 1)};
  if (data.bandwidth) *data.bandwidth *= periods;
  repeat(data.impulses, periods, once.period);
  if (data.events) repeat(*data.events, periods, once.period);
  return SampledTrajectory(std::move(data));
}

std::string trajectory_defect(const Trajectory& trajectory, int contacts, double forcing_period) {
  if (trajectory.contact_count() != contacts) {
    return fmt::format("the trajectory has {} contacts, the scene {}", trajectory.contact_count(), contacts);
  }
  constexpr double kMostPeriods = 256.0;  // every one of them is sampled
  const double period = trajectory.period();
  if (std::isfinite(period) && period > (kMostPeriods + 0.5) * forcing_period)
    return fmt::format("the period {} s is more than {} forcing periods", period, kMostPeriods);
  if (whole_periods(period, forcing_period) == 0)
    return fmt::format("the period {} s is no whole multiple of the forcing period {} s", period,
                       forcing_period);
  return list_defect(trajectory.impulses(), trajectory.events(), contacts, trajectory.period());
}

std::string samples_defect(const Samples& samples, Eigen::Index count, Eigen::Index contacts) {
  for (const auto& [name, values] : {std::pair{"x", &samples.x}, std::pair{"velocity", &samples.velocity},
                                     std::pair{"force", &samples.force}}) {
    if (std::string defect = size_defect(name, *values, count, contacts); !defect.empty()) return defect;
  }
  return {};
}

std::string answer_digest(const Trajectory& answer) {
  constexpr int kInstants = 64;
  std::string bytes;
  const double period = answer.period();
  append(bytes, std::span(&period, 1));
  const Samples samples = answer.sample(kInstants);
  for (const Eigen::MatrixXd* values : {&samples.x, &samples.velocity, &samples.force})
    append(bytes, *values);
  for (const Impulse& impulse : answer.impulses()) {
    bytes += std::to_string(impulse.contact);
    append(bytes, std::span(&impulse.time, 1));
    append(bytes, std::span(&impulse.value, 1));
  }
  return short_digest(bytes);
}

TrajectorySamples samples_of(const Trajectory& trajectory, int count) {
  const Samples samples = trajectory.sample(count);
  TrajectorySamples result;
  for (int i = 0; i < count; ++i) result.t.push_back(i * trajectory.period() / count);
  result.x = columns(samples.x);
  result.velocity = columns(samples.velocity);
  result.force = columns(samples.force);
  result.impulses = trajectory.impulses();
  result.bandwidth = trajectory.bandwidth();
  result.events = trajectory.events();
  return result;
}

std::shared_ptr<const SampledTrajectory> trajectory_of(double period, const TrajectorySamples& samples) {
  SampledTrajectory::Data data;
  data.period = period;
  const std::size_t contacts = samples.x.size();
  data.samples.x = matrix(samples.x, samples.t.size(), contacts);
  data.samples.velocity = matrix(samples.velocity, samples.t.size(), contacts);
  data.samples.force = matrix(samples.force, samples.t.size(), contacts);
  data.impulses = samples.impulses;
  constexpr int kMostHarmonics = 1000000;
  if (samples.bandwidth && (*samples.bandwidth < 0 || *samples.bandwidth > kMostHarmonics))
    throw BadRecord("trajectory.bandwidth = {} (must be in 0..{})", *samples.bandwidth, kMostHarmonics);
  data.bandwidth = samples.bandwidth;
  data.events = samples.events;
  try {
    return std::make_shared<SampledTrajectory>(std::move(data));
  } catch (const std::invalid_argument& error) {
    throw BadRecord(error.what());
  }
}

std::shared_ptr<const SampledTrajectory> start_from_file(const std::string& path) {
  const auto refuse = [&](std::string_view requirement) {
    return UsageError("start = {} ({})", path, requirement);
  };
  const auto json = try_parse_json(read_file(path));
  if (json.is_discarded()) throw refuse("must be JSON as printed by solve --json --samples N");
  try {
    const Record record = record_from_json(json);
    if (!record.trajectory || !record.period)
      throw refuse("must hold a trajectory: print it with --samples N");
    return trajectory_of(*record.period, *record.trajectory);
  } catch (const BadRecord& error) {
    throw refuse(fmt::format("must be a record as printed by solve --json --samples N: {}", error.what()));
  }
}

}  // namespace signorini
