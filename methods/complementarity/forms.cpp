#include "methods/complementarity/forms.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "methods/discretisation/block_circulant.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/discretisation/symbols.hpp"
#include "methods/solvers/lcp/bordered_lcp.hpp"
#include "methods/structure/mean_balance.hpp"

namespace signorini {

namespace {

/// 1 / sqrt(|a_cc[0]|) per contact, a_cc[0] = (1/N) sum_n (A_n)_cc the diagonal of A: scaled by it on both
/// sides, the diagonal is of order one, which tolerances on w and z rely on.
Eigen::VectorXd unit_of(const ContactReceptance& receptance, const NodalStops& stops, int samples) {
  Eigen::VectorXd lag = stops.compliance;
  for (int n = 0; n <= samples / 2; ++n) {
    const bool single = n == 0 || 2 * n == samples;  // its own mirror image
    const auto& block = receptance.receptance[static_cast<std::size_t>(n)];
    lag += (single ? 1.0 : 2.0) / samples * stops.shift(n, samples).cwiseProduct(block.diagonal()).real();
  }
  double largest = lag.cwiseAbs().maxCoeff();
  if (!(largest > 0.0)) largest = 1.0;
  // A contact whose own lag vanishes by accident borrows the scale of the others.
  return lag.cwiseAbs().cwiseMax(1e-3 * largest).cwiseSqrt().cwiseInverse();
}

/// With the means of rigid motions among the unknowns, and their balance: sum over the samples of
/// E^T (unit z) = N R^T f_0. Border and balance are scaled to columns of length about one.
Lcp with_rigid_motions(const Lcp& lcp, const ContactReceptance& receptance, const Eigen::VectorXd& unit) {
  const Eigen::Index m = receptance.rigid_count();
  if (m == 0) return lcp;
  const RigidBorder border = rigid_border(receptance, unit, lcp.samples);
  Eigen::MatrixXd columns(lcp.offset.size(), m);
  for (Eigen::Index c = 0; c < unit.size(); ++c)
    columns.middleRows(c * lcp.samples, lcp.samples).rowwise() = border.entries.row(c);
  return bordered_lcp(lcp, std::move(columns), border.balance);
}

}  // namespace

RigidBorder rigid_border(const ContactReceptance& receptance, const Eigen::VectorXd& unit, int samples) {
  RigidBorder border{.entries = unit.asDiagonal() * receptance.rigid, .unit = {}, .balance = {}};
  border.unit =
      (std::sqrt(samples) * border.entries.colwise().lpNorm<Eigen::Infinity>()).transpose().cwiseInverse();
  border.entries = border.entries * border.unit.asDiagonal();
  border.balance = samples * receptance.rigid_load.cwiseProduct(border.unit);
  return border;
}

Eigen::RowVectorXd rigid_mean(const ContactReceptance& receptance, const Lcp& lcp,
                              const Eigen::VectorXd& unit, const Eigen::VectorXd& z) {
  if (lcp.free == 0) return Eigen::RowVectorXd::Zero(receptance.contacts());
  const Eigen::VectorXd a =
      free_unknowns(lcp, z).cwiseProduct(rigid_border(receptance, unit, lcp.samples).unit);
  return (receptance.rigid * a).transpose();
}

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
  ContactReceptance held;  // answers to lambda: the balance stands beside it
  const bool balanced = receptance.rigid_count() > 0;
  if (balanced) held = receptance;
  held.rigid.resize(receptance.contacts(), 0);
  const ContactSymbol rate(balanced ? held : receptance, law);
  std::vector<Eigen::MatrixXcd> symbol;
  symbol.reserve(receptance.receptance.size());
  // w = z - y, and y answers to lambda = -P z by B_n: w_n = (1 + B_n) z_n, but w_n = z_n beyond H, where P
  // leaves nothing of z.
  for (int n = 0; n <= rate.harmonics(); ++n) {
    symbol.push_back(rate.block(n));
    symbol.back().diagonal().array() += 1.0;
  }
  return with_rigid_motions(
      periodic_lcp(BlockCirculant(samples, symbol, 1.0),
                   -free_penetration(receptance.free_response, gap, rate.root(), samples)),
      receptance, rate.root());
}

Eigen::VectorXd augmented_multiplier(const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                     int samples) {
  const auto& [receptance, gap, law] = equations;
  // y = c ((x - alpha lambda / c) - g), in units of sqrt(c).
  const Eigen::VectorXd weight = law.multiplier_weight.cwiseQuotient(law.constant);
  const Eigen::VectorXd root = law.constant.cwiseSqrt();
  const Eigen::VectorXd y = free_penetration(
      carried_motion(receptance, lambda) - balanced_force(receptance, lambda) * weight.asDiagonal(), gap,
      root, samples);
  if (receptance.rigid_count() == 0) return y;
  const double rate = 2.0 * std::numbers::pi / receptance.period;
  const Eigen::VectorXd a = receptance.rigid.transpose() * lambda.row(0).real().transpose() / (rate * rate);
  const Eigen::VectorXd unknown = a.cwiseQuotient(rigid_border(receptance, root, samples).unit);
  Eigen::VectorXd all(y.size() + 2 * a.size());
  all << y, unknown, -unknown;
  return all;
}

Eigen::MatrixXcd carried_coefficients(const ProjectedEquations& equations, const Lcp& lcp,
                                      const Eigen::VectorXd& z) {
  const auto& [receptance, gap, law] = equations;
  const Eigen::MatrixXcd lambda = force_coefficients(law, z, lcp.samples, receptance.harmonics());
  return carried_force(receptance, lambda, rigid_mean(receptance, lcp, law.constant.cwiseSqrt(), z));
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

NodalRestitution scene_restitution(const Problem& problem) {
  NodalRestitution restitution;
  for (const Contact& contact : problem.contacts) {
    const auto* law = std::get_if<Restitution>(&contact.law);
    restitution.push_back(law != nullptr ? std::optional(law->e) : std::nullopt);
  }
  return restitution;
}

Eigen::VectorXcd NodalStops::shift(int n, int samples) const {
  Eigen::VectorXcd shift(gap.size());
  for (Eigen::Index c = 0; c < shift.size(); ++c)
    shift[c] =
        restitution_shift(restitution[static_cast<std::size_t>(c)], 2.0 * std::numbers::pi * n / samples);
  return shift;
}

NodalStops nodal_stops(const Problem& problem, NodalRestitution restitution) {
  restitution.resize(problem.contacts.size());
  return {contact_gaps(problem), stop_compliance(problem), std::move(restitution)};
}

Eigen::VectorXd HatForm::pressure(const Eigen::VectorXd& z) const {
  return (z.head(lcp.contact_unknowns()).reshaped(lcp.samples, unit.size()) * unit.asDiagonal()).reshaped();
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
    const Eigen::VectorXcd shift = stops.shift(n, samples);
    symbol.emplace_back(
        shift.asDiagonal() *
        (unit.asDiagonal() * receptance.receptance[static_cast<std::size_t>(n)] * unit.asDiagonal()));
    symbol.back().diagonal() += (stops.compliance.array() * unit.array().square()).matrix();
    free.row(n) = receptance.free_response.row(n) * shift.asDiagonal();
  }
  Lcp lcp = periodic_lcp(BlockCirculant(samples, symbol), -free_penetration(free, stops.gap, unit, samples));
  lcp = with_rigid_motions(lcp, receptance, unit);
  return {std::move(lcp), std::move(unit)};
}

}  // namespace signorini
