#include "methods/aft_hbm/aft_residual.hpp"

#include <algorithm>
#include <cmath>

#include "methods/discretisation/free_penetration.hpp"
#include "methods/discretisation/harmonic_vector.hpp"

namespace signorini {

AftResidual::AftResidual(const ProjectedEquations& equations, int samples)
    : symbol_(equations.receptance, equations.law),
      samples_(samples),
      free_(free_penetration(equations.receptance.free_response, equations.gap, symbol_.root(), samples)),
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

Eigen::VectorXd AftResidual::residual(const Eigen::VectorXd& lambda) {
  const Eigen::VectorXd y = free_ + gap_rate(lambda);
  in_contact_ = y.array() > 0.0;
  return lambda + project(y.cwiseMax(0.0));
}

Eigen::VectorXd AftResidual::product(const Eigen::VectorXd& v) {
  Eigen::VectorXd signal = gap_rate(v);
  signal = in_contact_.select(signal, 0.0);
  return v + project(signal);
}

LastingContactInverse AftResidual::lasting_inverse() const {
  Eigen::VectorXd duty(contacts());
  for (int c = 0; c < contacts(); ++c) {
    duty[c] = static_cast<double>(in_contact_.segment(c * samples_, samples_).count()) / samples_;
  }
  return {symbol_, duty};
}

KrylovSolve AftResidual::solve_jacobian(const Eigen::VectorXd& r) {
  constexpr double kLinearTolerance = 1e-12;
  const LastingContactInverse lasting = lasting_inverse();
  return solve_by_gmres([this](const Eigen::VectorXd& v) { return product(v); },
                        [&lasting](const Eigen::VectorXd& v) { return lasting * v; }, r, kLinearTolerance);
}

double AftResidual::scale(const Eigen::VectorXd& lambda, const Eigen::VectorXd& r) const {
  return std::max(load_scale_, (r - lambda).norm());
}

Eigen::MatrixXcd AftResidual::coefficients(const Eigen::VectorXd& lambda) const {
  return unpack_harmonics(lambda, symbol_.harmonics()) * symbol_.root().asDiagonal();
}

Eigen::VectorXd AftResidual::unknowns_of(const Eigen::MatrixXcd& coefficients) const {
  return pack_harmonics(coefficients * symbol_.root().cwiseInverse().asDiagonal());
}

}  // namespace signorini
