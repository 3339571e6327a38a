#pragma once
// Truncated Fourier series: at an instant, on a grid of them, and as a real vector.

#include <Eigen/Core>
#include <complex>
#include <numbers>

namespace signorini {

/// Value and derivatives with respect to time, counted in periods.
struct Jet {
  double value = 0.0;      ///< y
  double slope = 0.0;      ///< y'
  double curvature = 0.0;  ///< y''
};

/// The jet of y(t) = sum_{|n| <= H} y_n e^{2 pi i n t}, by the powers of e^{2 pi i t}. \param y  n = 0..H
inline Jet trigonometric_jet(const Eigen::Ref<const Eigen::VectorXcd>& y, double t) {
  const std::complex<double> unit = std::polar(1.0, 2.0 * std::numbers::pi * t);
  std::complex<double> phase = 1.0;
  Jet jet{y[0].real(), 0.0, 0.0};
  for (Eigen::Index n = 1; n < y.size(); ++n) {
    phase *= unit;
    const std::complex<double> term = 2.0 * y[n] * phase;
    const double rate = 2.0 * std::numbers::pi * static_cast<double>(n);
    jet.value += term.real();
    jet.slope -= rate * term.imag();
    jet.curvature -= rate * rate * term.real();
  }
  return jet;
}

/// Real functions of the period's time at `count` equidistant instants, count x k, from their coefficients
/// n = 0..H, (H+1) x k; exact whatever the count.
Eigen::MatrixXd sample_series(const Eigen::MatrixXcd& coefficients, int count);

/// The same functions in harmonics of `times` >= 1 of their periods, (times H + 1) x k.
Eigen::MatrixXcd repeated(const Eigen::MatrixXcd& coefficients, int times);

/// Per contact (s_0, sqrt(2) Re s_1, sqrt(2) Im s_1, ..., sqrt(2) Im s_H), contacts one after another.
/// \param spectrum (H+1) x Nc; the imaginary part of s_0 is dropped
Eigen::VectorXd pack_harmonics(const Eigen::MatrixXcd& spectrum);

/// The inverse; size (2 H + 1) Nc.
Eigen::MatrixXcd unpack_harmonics(const Eigen::VectorXd& packed, int harmonics);

}  // namespace signorini
