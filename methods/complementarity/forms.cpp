#include "methods/complementarity/forms.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "methods/discretisation/block_circulant.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/discretisation/symbols.hpp"

namespace signorini {

namespace {

std::complex<double> shift_of(const NodalStops& stops, int n, int samples) {
  return restitution_shift(stops.restitution, 2.0 * std::numbers::pi * n / samples);
}

/// 1 / sqrt(|a_cc[0]|) per contact, a_cc[0] = (1/N) sum_n (A_n)_cc the diagonal of A: scaled by it on both
/// sides, the diagonal is of order one, which tolerances on w and z rely on.
Eigen::VectorXd unit_of(const ContactReceptance& receptance, const NodalStops& stops, int samples) {
  Eigen::VectorXd lag = stops.compliance;
  for (int n = 0; n <= samples / 2; ++n) {
    const bool single = n == 0 || 2 * n == samples;  // its own mirror image
    const std::complex<double> shift = shift_of(stops, n, samples);
    const auto& block = receptance.receptance[static_cast<std::size_t>(n)];
    lag += (single ? 1.0 : 2.0) / samples * (shift * block.diagonal()).real();
  }
  double largest = lag.cwiseAbs().maxCoeff();
  if (!(largest > 0.0)) largest = 1.0;
  // A contact whose own lag vanishes by accident borrows the scale of the others.
  return lag.cwiseAbs().cwiseMax(1e-3 * largest).cwiseSqrt().cwiseInverse();
}

}  // namespace

Eigen::VectorXd free_penetration(const Eigen::MatrixXcd& free_response, const Eigen::VectorXd& gap,
                                 const Eigen::VectorXd& scale, int samples) {
  Eigen::VectorXd penetration(samples * free_response.cols());
  RealFft fft(samples);
  for (Eigen::Index c = 0; c < free_response.cols(); ++c) {
    auto part = penetration.segment(c * samples, samples);
    fft.inverse(free_response.col(c), part);
    part = scale[c] * (part.array() - gap[c]);
  }
  return penetration;
}

Lcp projected_lcp(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                  int samples) {
  const ContactSymbol rate(receptance, law);
  std::vector<Eigen::MatrixXcd> symbol;
  symbol.reserve(receptance.receptance.size());
  // w = z - y, and y answers to lambda = -P z by B_n: w_n = (1 + B_n) z_n, but w_n = z_n beyond H, where P
  // leaves nothing of z.
  for (int n = 0; n <= rate.harmonics(); ++n) {
    symbol.push_back(rate.block(n));
    symbol.back().diagonal().array() += 1.0;
  }
  return periodic_lcp(BlockCirculant(samples, symbol, 1.0),
                      -free_penetration(receptance.free_response, gap, rate.root(), samples));
}

Eigen::VectorXd augmented_multiplier(const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                     int samples) {
  const auto& [receptance, gap, law] = equations;
  // y = c ((x - alpha lambda / c) - g), in units of sqrt(c).
  const Eigen::VectorXd weight = law.multiplier_weight.cwiseQuotient(law.constant);
  return free_penetration(contact_motion(receptance, lambda) - lambda * weight.asDiagonal(), gap,
                          law.constant.cwiseSqrt(), samples);
}

Eigen::MatrixXcd force_coefficients(const ProjectedLaw& law, const Eigen::VectorXd& z_scaled, int samples,
                                    int harmonics) {
  RealFft fft(samples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  Eigen::MatrixXcd lambda(harmonics + 1, law.constant.size());
  for (Eigen::Index c = 0; c < lambda.cols(); ++c) {
    fft.forward(z_scaled.segment(c * samples, samples), spectrum);
    lambda.col(c) = -std::sqrt(law.constant[c]) * spectrum.head(lambda.rows());
  }
  return lambda;
}

NodalStops nodal_stops(const Problem& problem, const std::optional<double>& restitution) {
  NodalStops stops{contact_gaps(problem), Eigen::VectorXd::Zero(problem.contact_count()), restitution};
  if (const auto* stop = std::get_if<Penalty>(&problem.law)) {
    stops.compliance =
        Eigen::Map<const Eigen::VectorXd>(stop->stiffness.data(), stops.compliance.size()).cwiseInverse();
  }
  return stops;
}

Eigen::VectorXd HatForm::pressure(const Eigen::VectorXd& z) const {
  return (z.reshaped(lcp.samples, unit.size()) * unit.asDiagonal()).reshaped();
}

Eigen::VectorXd HatForm::scaled(const Eigen::VectorXd& pressure) const {
  return (pressure.reshaped(lcp.samples, unit.size()).array().rowwise() / unit.transpose().array())
      .reshaped();
}

HatForm hat_form(const ContactReceptance& receptance, const NodalStops& stops, int samples) {
  Eigen::VectorXd unit = unit_of(receptance, stops, samples);
  std::vector<Eigen::MatrixXcd> symbol;
  symbol.reserve(receptance.receptance.size());
  Eigen::MatrixXcd free(receptance.free_response.rows(), receptance.contacts());
  for (int n = 0; n <= receptance.harmonics(); ++n) {
    const std::complex<double> shift = shift_of(stops, n, samples);
    symbol.emplace_back(
        shift * (unit.asDiagonal() * receptance.receptance[static_cast<std::size_t>(n)] * unit.asDiagonal()));
    symbol.back().diagonal() += (stops.compliance.array() * unit.array().square()).matrix();
    free.row(n) = shift * receptance.free_response.row(n);
  }
  Lcp lcp = periodic_lcp(BlockCirculant(samples, symbol), -free_penetration(free, stops.gap, unit, samples));
  return {std::move(lcp), std::move(unit)};
}

}  // namespace signorini
