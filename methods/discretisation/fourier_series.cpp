#include "methods/discretisation/fourier_series.hpp"

#include "methods/discretisation/real_fft.hpp"

namespace signorini {

Eigen::MatrixXd sample_series(const Eigen::MatrixXcd& coefficients, int count) {
  RealFft fft(count);
  Eigen::MatrixXcd folded = Eigen::MatrixXcd::Zero(fft.coefficients(), coefficients.cols());
  for (Eigen::Index n = 0; n < coefficients.rows(); ++n) {
    // Harmonics that the grid cannot tell apart from lower ones are folded onto them: n and -n appear at
    // these places; the half spectrum keeps those up to count / 2.
    const auto place = static_cast<int>(n % count);
    const int mirror = (count - place) % count;
    if (2 * place <= count) folded.row(place) += coefficients.row(n);
    if (n > 0 && 2 * mirror <= count) folded.row(mirror) += coefficients.row(n).conjugate();
  }
  Eigen::MatrixXd values(count, coefficients.cols());
  for (Eigen::Index c = 0; c < values.cols(); ++c) fft.inverse(folded.col(c), values.col(c));
  return values;
}

Eigen::MatrixXcd repeated(const Eigen::MatrixXcd& coefficients, int times) {
  Eigen::MatrixXcd result =
      Eigen::MatrixXcd::Zero(times * (coefficients.rows() - 1) + 1, coefficients.cols());
  for (Eigen::Index n = 0; n < coefficients.rows(); ++n) result.row(times * n) = coefficients.row(n);
  return result;
}

Eigen::VectorXd pack_harmonics(const Eigen::MatrixXcd& spectrum) {
  const Eigen::Index harmonics = spectrum.rows() - 1;
  const Eigen::Index stride = 2 * harmonics + 1;
  Eigen::VectorXd packed(stride * spectrum.cols());
  for (Eigen::Index c = 0; c < spectrum.cols(); ++c) {
    packed[c * stride] = spectrum(0, c).real();
    const auto waves = spectrum.col(c).tail(harmonics);
    packed(Eigen::seqN(c * stride + 1, harmonics, 2)) = std::numbers::sqrt2 * waves.real();
    packed(Eigen::seqN(c * stride + 2, harmonics, 2)) = std::numbers::sqrt2 * waves.imag();
  }
  return packed;
}

Eigen::MatrixXcd unpack_harmonics(const Eigen::VectorXd& packed, int harmonics) {
  const Eigen::Index stride = 2 * harmonics + 1;
  Eigen::MatrixXcd spectrum(harmonics + 1, packed.size() / stride);
  for (Eigen::Index c = 0; c < spectrum.cols(); ++c) {
    spectrum(0, c) = packed[c * stride];
    auto waves = spectrum.col(c).tail(harmonics);
    waves.real() = packed(Eigen::seqN(c * stride + 1, harmonics, 2)) / std::numbers::sqrt2;
    waves.imag() = packed(Eigen::seqN(c * stride + 2, harmonics, 2)) / std::numbers::sqrt2;
  }
  return spectrum;
}

}  // namespace signorini
