#pragma once
// The Fourier functions of the source paper [shi2015], in its own order.

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace signorini::test {

/// phi(t) = [1/sqrt 2, cos wt, .., cos Mwt, sin wt, .., sin Mwt] and its derivatives (eq. 11-13).
inline Eigen::RowVectorXd phi(int harmonics, double w, double t, int derivative = 0) {
  Eigen::RowVectorXd row(2 * harmonics + 1);
  row[0] = derivative == 0 ? 1.0 / std::numbers::sqrt2 : 0.0;
  for (int n = 1; n <= harmonics; ++n) {
    const double rate = std::pow(n * w, derivative);
    const double angle = n * w * t + 0.5 * std::numbers::pi * derivative;
    row[n] = rate * std::cos(angle);
    row[harmonics + n] = rate * std::sin(angle);
  }
  return row;
}

/// Integral of phi^T (d/dt)^derivative phi over a period, by a sum that is exact for it (eq. 17-19).
inline Eigen::MatrixXd gram(int harmonics, double w, int derivative) {
  const int samples = 4 * harmonics + 4;
  const double step = 2.0 * std::numbers::pi / w / samples;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2 * harmonics + 1, 2 * harmonics + 1);
  for (int i = 0; i < samples; ++i) {
    sum += step * phi(harmonics, w, i * step).transpose() * phi(harmonics, w, i * step, derivative);
  }
  return sum;
}

}  // namespace signorini::test
