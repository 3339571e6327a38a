#include "methods/discretisation/trajectories.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "methods/discretisation/real_fft.hpp"

namespace signorini {

namespace {

/// Sums a truncated Fourier series at `count` instants. Harmonics that the grid cannot tell apart from
/// lower ones are folded onto them, so that the values at the instants are exact for any count.
void sum_series(const Eigen::VectorXcd& coefficients, RealFft& fft, Eigen::Ref<Eigen::VectorXd> values) {
  const int count = fft.samples();
  Eigen::VectorXcd folded = Eigen::VectorXcd::Zero(fft.coefficients());
  for (Eigen::Index n = 0; n < coefficients.size(); ++n) {
    // Harmonics n and -n appear at these places; the half spectrum keeps those up to count / 2.
    const auto place = static_cast<int>(n % count);
    const int mirror = (count - place) % count;
    if (2 * place <= count) folded[place] += coefficients[n];
    if (n > 0 && 2 * mirror <= count) folded[mirror] += std::conj(coefficients[n]);
  }
  fft.inverse(folded, values);
}

}  // namespace

Samples FourierTrajectory::sample(int count) const {
  const Eigen::Index contacts = data_.x.cols();
  const double base = 2.0 * std::numbers::pi / data_.period;
  RealFft fft(count);
  Samples samples{Eigen::MatrixXd(count, contacts), Eigen::MatrixXd(count, contacts),
                  Eigen::MatrixXd::Zero(count, contacts)};
  Eigen::VectorXcd rate(data_.x.rows());
  Eigen::VectorXd lambda(count);
  for (Eigen::Index c = 0; c < contacts; ++c) {
    for (Eigen::Index n = 0; n < rate.size(); ++n) {
      rate[n] = std::complex<double>(0.0, static_cast<double>(n) * base) * data_.x(n, c);
    }
    sum_series(data_.x.col(c), fft, samples.x.col(c));
    sum_series(rate, fft, samples.velocity.col(c));
    if (data_.lambda.cols() == 0) continue;
    sum_series(data_.lambda.col(c), fft, lambda);
    Eigen::ArrayXd overlap = samples.x.col(c).array() - data_.gap[c];
    for (int i = 0; i < count && !data_.shifts.empty(); ++i) {
      const double t = static_cast<double>(i) / count;
      overlap[i] += shift_at(data_.shifts[static_cast<std::size_t>(c)], t).at(t);
    }
    samples.force.col(c) =
        -(data_.stiffness[c] * overlap - data_.multiplier_weight[c] * lambda.array()).max(0.0);
  }
  return samples;
}

StopShifts stop_shifts(const Trajectory& motion) {
  const auto* series = dynamic_cast<const FourierTrajectory*>(&motion);
  return series == nullptr ? StopShifts{} : series->data().shifts;
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
