#include "harness/records/sampled_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace signorini {

namespace {

std::string size_defect(const char* name, const Eigen::MatrixXd& values, Eigen::Index count,
                        Eigen::Index contacts) {
  if (values.rows() != count || values.cols() != contacts) {
    return fmt::format("{} has {} x {} samples, {} x {} were asked for", name, values.rows(), values.cols(),
                       count, contacts);
  }
  if (!values.allFinite()) return fmt::format("{} has values that are not finite", name);
  return {};
}

std::string impulses_defect(const std::vector<Impulse>& impulses, int contacts, double period) {
  for (const Impulse& impulse : impulses) {
    if (impulse.contact < 0 || impulse.contact >= contacts) {
      return fmt::format("an impulse acts at contact {} of {}", impulse.contact, contacts);
    }
    if (!std::isfinite(impulse.value) || !(impulse.time >= 0.0) || !(impulse.time <= period)) {
      return fmt::format("an impulse of {} N s acts at {} s, outside the period", impulse.value,
                         impulse.time);
    }
  }
  return {};
}

std::string events_defect(const std::optional<std::vector<ContactEvent>>& events, int contacts,
                          double period) {
  double last = 0.0;
  for (const ContactEvent& event : events.value_or(std::vector<ContactEvent>{})) {
    const std::string_view kind = name_of(event.kind);
    if (event.contact < 0 || event.contact >= contacts)
      return fmt::format("the event {} is at contact {} of {}", kind, event.contact, contacts);
    if (!std::isfinite(event.impulse) || !(event.time >= 0.0) || !(event.time <= period))
      return fmt::format("the event {} of {} N s is at {} s, outside the period", kind, event.impulse,
                         event.time);
    if (event.time < last)
      return fmt::format("the event {} at {} s comes after one at {} s", kind, event.time, last);
    last = event.time;
  }
  return {};
}

/// Adds `seconds` to the times of impulses or events, modulo the period.
template <class Timed>
void delay(std::vector<Timed>& items, double seconds, double period) {
  for (Timed& one : items) {
    one.time += seconds;
    if (one.time >= period) one.time -= period;
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const Timed& a, const Timed& b) { return a.time < b.time; });
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

}  // namespace

SampledTrajectory::SampledTrajectory(Data data) : data_(std::move(data)) {
  const Eigen::Index count = data_.samples.x.rows();
  std::string defect = samples_defect(data_.samples, count, data_.samples.x.cols());
  if (count < 1) defect = "there are no samples";
  if (!(data_.period > 0.0) || !std::isfinite(data_.period)) defect = "the period is not positive";
  if (defect.empty()) defect = impulses_defect(data_.impulses, contact_count(), data_.period);
  if (defect.empty()) defect = events_defect(data_.events, contact_count(), data_.period);
  if (!defect.empty()) throw std::invalid_argument(fmt::format("trajectory = unusable ({})", defect));
}

SampledTrajectory::SampledTrajectory(const Trajectory& source, int count)
    : SampledTrajectory(Data{source.period(), source.sample(count), source.impulses(), source.bandwidth()}) {}

Samples SampledTrajectory::sample(int count) const {
  const auto stored = static_cast<int>(data_.samples.x.rows());
  const Eigen::Index contacts = data_.samples.x.cols();
  Samples result{Eigen::MatrixXd(count, contacts), Eigen::MatrixXd(count, contacts),
                 Eigen::MatrixXd(count, contacts)};
  const double step = data_.period / stored;
  const auto& [x, v, f] = data_.samples;
  for (int i = 0; i < count; ++i) {
    // Whole numbers, so that an instant that is stored is met exactly.
    const long place = static_cast<long>(i) * stored;
    const auto left = static_cast<int>(place / count);
    const double s = static_cast<double>(place % count) / count;
    if (s == 0.0) {
      result.x.row(i) = x.row(left);
      result.velocity.row(i) = v.row(left);
      result.force.row(i) = f.row(left);
      continue;
    }
    const int right = (left + 1) % stored;
    const double h00 = (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s);
    const double h10 = s * (1.0 - s) * (1.0 - s);
    const double h01 = s * s * (3.0 - 2.0 * s);
    const double h11 = s * s * (s - 1.0);
    result.x.row(i) =
        h00 * x.row(left) + h01 * x.row(right) + step * (h10 * v.row(left) + h11 * v.row(right));
    result.velocity.row(i) = (1.0 - s) * v.row(left) + s * v.row(right);
    result.force.row(i) = (1.0 - s) * f.row(left) + s * f.row(right);
  }
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
  const double ratio = trajectory.period() / forcing_period;
  if (!std::isfinite(ratio) || ratio < 0.5 || std::abs(ratio - std::round(ratio)) > 1e-6 * ratio) {
    return fmt::format("the period {} s is no whole multiple of the forcing period {} s", trajectory.period(),
                       forcing_period);
  }
  const std::string defect = impulses_defect(trajectory.impulses(), contacts, trajectory.period());
  return defect.empty() ? events_defect(trajectory.events(), contacts, trajectory.period()) : defect;
}

std::string samples_defect(const Samples& samples, Eigen::Index count, Eigen::Index contacts) {
  for (const auto& [name, values] : {std::pair{"x", &samples.x}, std::pair{"velocity", &samples.velocity},
                                     std::pair{"force", &samples.force}}) {
    if (std::string defect = size_defect(name, *values, count, contacts); !defect.empty()) return defect;
  }
  return {};
}

}  // namespace signorini
