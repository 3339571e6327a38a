#include "methods/aft_hbm/aft_residual.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "methods/discretisation/free_penetration.hpp"
#include "methods/discretisation/harmonic_vector.hpp"

namespace signorini {

AftResidual::AftResidual(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                         const ProjectedLaw& law, int samples)
    : symbol_(receptance, law),
      samples_(samples),
      free_(free_penetration(receptance.free_response, gap, symbol_.root(), samples)),
      fft_(samples) {
  load_scale_ = std::sqrt(free_.cwiseMax(0.0).squaredNorm() / samples_);
}

Eigen::VectorXd AftResidual::gap_rate(const Eigen::VectorXd& v) {
  const Eigen::MatrixXcd spectrum = symbol_.rate(v);
  Eigen::VectorXd signal(samples_ * contacts());
  for (int c = 0; c < contacts(); ++c) fft_.inverse(spectrum.col(c), signal.segment(c * samples_, samples_));
  return signal;
}

Eigen::VectorXd AftResidual::project(const Eigen::VectorXd& signal) {
  Eigen::MatrixXcd spectrum(symbol_.harmonics() + 1, contacts());
  Eigen::VectorXcd full(fft_.coefficients());
  for (int c = 0; c < contacts(); ++c) {
    fft_.forward(signal.segment(c * samples_, samples_), full);
    spectrum.col(c) = full.head(symbol_.harmonics() + 1);
  }
  return pack_harmonics(spectrum);
}

Eigen::VectorXd AftResidual::residual(const Eigen::VectorXd& lambda, std::vector<char>& contact) {
  const Eigen::VectorXd y = free_ + gap_rate(lambda);
  contact.resize(static_cast<std::size_t>(y.size()));
  for (Eigen::Index i = 0; i < y.size(); ++i) contact[static_cast<std::size_t>(i)] = y[i] > 0.0 ? 1 : 0;
  return lambda + project(y.cwiseMax(0.0));
}

Eigen::VectorXd AftResidual::product(const std::vector<char>& contact, const Eigen::VectorXd& v) {
  Eigen::VectorXd signal = gap_rate(v);
  for (Eigen::Index i = 0; i < signal.size(); ++i) {
    if (contact[static_cast<std::size_t>(i)] == 0) signal[i] = 0.0;
  }
  return v + project(signal);
}

LastingContactInverse AftResidual::lasting_inverse(const std::vector<char>& contact) const {
  Eigen::VectorXd duty(contacts());
  for (int c = 0; c < contacts(); ++c) {
    const auto first = contact.begin() + static_cast<std::ptrdiff_t>(c) * samples_;
    duty[c] = static_cast<double>(std::count(first, first + samples_, 1)) / samples_;
  }
  return {symbol_, duty};
}

Eigen::MatrixXcd AftResidual::coefficients(const Eigen::VectorXd& lambda) const {
  return unpack_harmonics(lambda, symbol_.harmonics()) * symbol_.root().asDiagonal();
}

Eigen::VectorXd AftResidual::unknowns_of(const Eigen::MatrixXcd& coefficients) const {
  return pack_harmonics(coefficients * symbol_.root().cwiseInverse().asDiagonal());
}

}  // namespace signorini
