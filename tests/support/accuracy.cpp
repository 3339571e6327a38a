#include "tests/support/accuracy.hpp"

#include <cmath>

namespace signorini::test {

double relative_error(const Trajectory& trajectory, const std::function<double(double)>& exact, int contact,
                      int count) {
  const Samples samples = trajectory.sample(count);
  double error = 0.0;
  double norm = 0.0;
  for (int i = 0; i < count; ++i) {
    const double truth = exact(trajectory.period() * i / count);
    error += std::pow(samples.x(i, contact) - truth, 2);
    norm += truth * truth;
  }
  return std::sqrt(error / norm);
}

double relative_distance(const Trajectory& a, const Trajectory& b, int count) {
  const Eigen::MatrixXd xa = a.sample(count).x;
  return (xa - b.sample(count).x).norm() / xa.norm();
}

double observed_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  double mean_x = 0.0;
  double mean_y = 0.0;
  const auto count = static_cast<double>(steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    mean_x += std::log(steps[k]) / count;
    mean_y += std::log(errors[k]) / count;
  }
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    covariance += (std::log(steps[k]) - mean_x) * (std::log(errors[k]) - mean_y);
    variance += std::pow(std::log(steps[k]) - mean_x, 2);
  }
  return covariance / variance;
}

Samples GivenMotion::sample(int count) const {
  Samples samples{Eigen::MatrixXd(count, 1), Eigen::MatrixXd::Zero(count, 1),
                  Eigen::MatrixXd::Zero(count, 1)};
  for (int i = 0; i < count; ++i) {
    samples.x(i, 0) = x_(period_ * i / count);
    if (force_) samples.force(i, 0) = force_(period_ * i / count);
  }
  return samples;
}

}  // namespace signorini::test
