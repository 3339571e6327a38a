#include "methods/aft_hbm/aft_residual.hpp"

#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "methods/kernels/harmonic_vector.hpp"
#include "methods/kernels/pivoting.hpp"

namespace signorini {

AftResidual::AftResidual(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                         const ProjectedLaw& law, int samples)
    : harmonics_(receptance.harmonics()),
      contacts_(receptance.contacts()),
      samples_(samples),
      root_(law.constant.cwiseSqrt()),
      free_(samples * contacts_),
      shift_(samples * contacts_),
      fft_(samples) {
  symbol_.reserve(receptance.receptance.size());
  for (const Eigen::MatrixXcd& c : receptance.receptance) {
    symbol_.emplace_back(root_.asDiagonal() * c * root_.asDiagonal());
    symbol_.back().diagonal() -= law.relief;
  }
  for (int c = 0; c < contacts_; ++c) {
    auto part = free_.segment(c * samples_, samples_);
    fft_.inverse(receptance.free_response.col(c), part);
    part = root_[c] * (part.array() - gap[c]);
    shift_.segment(c * samples_, samples_).setConstant(root_[c] / root_.maxCoeff());
  }
  shift_ = shift_.cwiseProduct(smooth_cover(samples_, contacts_));
  load_scale_ = std::sqrt(free_.cwiseMax(0.0).squaredNorm() / samples_);
}

Eigen::VectorXd AftResidual::gap_rate(const Eigen::VectorXd& v) {
  Eigen::MatrixXcd spectrum = unpack_harmonics(v, harmonics_);
  for (int n = 0; n <= harmonics_; ++n) {
    spectrum.row(n) = (symbol_[static_cast<std::size_t>(n)] * spectrum.row(n).transpose()).transpose().eval();
  }
  Eigen::VectorXd signal(samples_ * contacts_);
  for (int c = 0; c < contacts_; ++c) fft_.inverse(spectrum.col(c), signal.segment(c * samples_, samples_));
  return signal;
}

Eigen::VectorXd AftResidual::gap_function(const Eigen::VectorXd& lambda, double tau) {
  return free_ + gap_rate(lambda) - tau * shift_;
}

Eigen::VectorXd AftResidual::project(const Eigen::VectorXd& signal) {
  Eigen::MatrixXcd spectrum(harmonics_ + 1, contacts_);
  Eigen::VectorXcd full(fft_.coefficients());
  for (int c = 0; c < contacts_; ++c) {
    fft_.forward(signal.segment(c * samples_, samples_), full);
    spectrum.col(c) = full.head(harmonics_ + 1);
  }
  return pack_harmonics(spectrum);
}

Eigen::VectorXd AftResidual::residual(const Eigen::VectorXd& lambda, std::vector<char>& contact) {
  const Eigen::VectorXd y = gap_function(lambda, 0.0);
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

void AftResidual::prepare_preconditioner(const std::vector<char>& contact) {
  Eigen::VectorXcd ratio(contacts_);
  for (int c = 0; c < contacts_; ++c) {
    int closed = 0;
    for (int i = 0; i < samples_; ++i) closed += contact[static_cast<std::size_t>(c * samples_ + i)];
    ratio[c] = static_cast<double>(closed) / samples_;
  }
  preconditioner_.resize(symbol_.size());
  for (std::size_t n = 0; n < symbol_.size(); ++n) {
    Eigen::MatrixXcd block = ratio.asDiagonal() * symbol_[n];
    block.diagonal().array() += 1.0;
    // Nc x Nc only; where the mean Jacobian is singular by accident, the identity serves as well.
    const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(block);
    preconditioner_[n] = lu.inverse();
    if (!preconditioner_[n].allFinite()) preconditioner_[n].setIdentity();
  }
}

Eigen::VectorXd AftResidual::precondition(const Eigen::VectorXd& v) const {
  Eigen::MatrixXcd spectrum = unpack_harmonics(v, harmonics_);
  for (int n = 0; n <= harmonics_; ++n) {
    spectrum.row(n) =
        (preconditioner_[static_cast<std::size_t>(n)] * spectrum.row(n).transpose()).transpose().eval();
  }
  return pack_harmonics(spectrum);
}

Eigen::MatrixXcd AftResidual::coefficients(const Eigen::VectorXd& lambda) const {
  return unpack_harmonics(lambda, harmonics_) * root_.asDiagonal();
}

Eigen::VectorXd AftResidual::unknowns_of(const Eigen::MatrixXcd& coefficients) const {
  return pack_harmonics(coefficients * root_.cwiseInverse().asDiagonal());
}

}  // namespace signorini
