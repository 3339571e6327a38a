#include "methods/discretisation/harmonic_vector.hpp"

#include <complex>
#include <numbers>

namespace signorini {

Eigen::VectorXd pack_harmonics(const Eigen::MatrixXcd& spectrum) {
  const Eigen::Index harmonics = spectrum.rows() - 1;
  const Eigen::Index stride = 2 * harmonics + 1;
  Eigen::VectorXd packed(stride * spectrum.cols());
  for (Eigen::Index c = 0; c < spectrum.cols(); ++c) {
    packed[c * stride] = spectrum(0, c).real();
    for (Eigen::Index n = 1; n <= harmonics; ++n) {
      packed[c * stride + 2 * n - 1] = std::numbers::sqrt2 * spectrum(n, c).real();
      packed[c * stride + 2 * n] = std::numbers::sqrt2 * spectrum(n, c).imag();
    }
  }
  return packed;
}

Eigen::MatrixXcd unpack_harmonics(const Eigen::VectorXd& packed, int harmonics) {
  const Eigen::Index stride = 2 * harmonics + 1;
  Eigen::MatrixXcd spectrum(harmonics + 1, packed.size() / stride);
  for (Eigen::Index c = 0; c < spectrum.cols(); ++c) {
    spectrum(0, c) = packed[c * stride];
    for (Eigen::Index n = 1; n <= harmonics; ++n) {
      const std::complex<double> value(packed[c * stride + 2 * n - 1], packed[c * stride + 2 * n]);
      spectrum(n, c) = value / std::numbers::sqrt2;
    }
  }
  return spectrum;
}

}  // namespace signorini
