#include "harness/records/trajectory_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_fields.hpp"
#include "harness/records/record_json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

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

Json to_json(const TrajectorySamples& trajectory) { return write_fields(trajectory); }

TrajectorySamples trajectory_samples_from_json(const Json& json) {
  TrajectorySamples trajectory;
  read_fields(json, trajectory);
  return trajectory;
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
  data.bandwidth = samples.bandwidth;
  try {
    return std::make_shared<SampledTrajectory>(std::move(data));
  } catch (const std::invalid_argument& error) {
    throw BadRecord(error.what());
  }
}

std::shared_ptr<const SampledTrajectory> start_from_file(const std::string& path) {
  const auto refuse = [&](std::string_view requirement) {
    return UsageError(fmt::format("start = {} ({})", path, requirement));
  };
  const std::string text = read_file(path);
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
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
