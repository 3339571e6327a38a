#include "methods/discretisation/trajectories.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "methods/discretisation/fourier_series.hpp"

namespace signorini {

Samples FourierTrajectory::sample(int count) const {
  const Eigen::Index contacts = data_.x.cols();
  const double base = 2.0 * std::numbers::pi / data_.period;
  Eigen::MatrixXcd rate(data_.x.rows(), contacts);
  for (Eigen::Index n = 0; n < rate.rows(); ++n)
    rate.row(n) = std::complex<double>(0.0, static_cast<double>(n) * base) * data_.x.row(n);
  Samples samples{sample_series(data_.x, count), sample_series(rate, count),
                  Eigen::MatrixXd::Zero(count, contacts)};
  if (data_.lambda.cols() == 0) return samples;
  const Eigen::MatrixXd lambda = sample_series(data_.lambda, count);
  for (Eigen::Index c = 0; c < contacts; ++c) {
    Eigen::ArrayXd penetration = samples.x.col(c).array() - data_.gap[c];
    for (int i = 0; i < count && !data_.shifts.empty(); ++i) {
      const double t = static_cast<double>(i) / count;
      penetration[i] += shift_at(data_.shifts[static_cast<std::size_t>(c)], t).at(t);
    }
    samples.force.col(c) =
        -(data_.stiffness[c] * penetration - data_.multiplier_weight[c] * lambda.col(c).array()).max(0.0);
  }
  return samples;
}

Samples NodalTrajectory::sample(int count) const {
  const auto nodes = static_cast<int>(x_.rows());
  const Eigen::Index contacts = x_.cols();
  const double step = period_ / nodes;
  Samples samples{Eigen::MatrixXd(count, contacts), Eigen::MatrixXd(count, contacts),
                  Eigen::MatrixXd(count, contacts)};
  for (int i = 0; i < count; ++i) {
    const double place = static_cast<double>(i) * nodes / count;
    const int left = std::min(static_cast<int>(place), nodes - 1);
    const int right = (left + 1) % nodes;
    const double weight = place - left;
    samples.x.row(i) = (1.0 - weight) * x_.row(left) + weight * x_.row(right);
    samples.velocity.row(i) = (x_.row(right) - x_.row(left)) / step;
    samples.force.row(i) = (1.0 - weight) * force_.row(left) + weight * force_.row(right);
  }
  return samples;
}

}  // namespace signorini
