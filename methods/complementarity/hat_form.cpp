#include "methods/complementarity/hat_form.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "methods/discretisation/block_circulant.hpp"
#include "methods/discretisation/free_penetration.hpp"
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

NodalStops nodal_stops(const Problem& problem, const std::optional<double>& restitution) {
  NodalStops stops{contact_gaps(problem), Eigen::VectorXd::Zero(problem.contact_count()), restitution};
  if (const auto* stop = std::get_if<Penalty>(&problem.law)) {
    stops.compliance =
        Eigen::Map<const Eigen::VectorXd>(stop->stiffness.data(), stops.compliance.size()).cwiseInverse();
  }
  return stops;
}

Eigen::VectorXd HatForm::pressure(const Eigen::VectorXd& z) const {
  Eigen::VectorXd result = z;
  for (Eigen::Index c = 0; c < unit.size(); ++c) result.segment(c * lcp.samples, lcp.samples) *= unit[c];
  return result;
}

Eigen::VectorXd HatForm::scaled(const Eigen::VectorXd& pressure) const {
  Eigen::VectorXd z = pressure;
  for (Eigen::Index c = 0; c < unit.size(); ++c) z.segment(c * lcp.samples, lcp.samples) /= unit[c];
  return z;
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
