#include "methods/complementarity/projected_law.hpp"

#include <algorithm>
#include <cmath>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/structure/mean_balance.hpp"
#include "problems/linear_algebra/complex_lu.hpp"

namespace signorini {

namespace {

// Multiples of the highest dynamic stiffness kept. Larger ones are more accurate (docs/decisions/0006) and
// leave fewer samples in contact; from about a hundred on the exact contact integral is no longer met
// from a sampled one.
constexpr double kConstantMultiple = 4.0;
constexpr double kPenaltyMultiple = 8.0;

// The dynamic stiffness of a contact with mass grows as H^2, that of a massless one stays. On
// bar20-massless the error of x is least at 8, 100 and 500 times it for H = 10, 40 and 160, and hardly grows
// beyond.
double penalty_multiple(const ContactLaw& law, int harmonics) {
  constexpr double kBase = 10.0;
  if (!std::holds_alternative<Massless>(law)) return kPenaltyMultiple;
  return kPenaltyMultiple * std::max(1.0, std::pow(harmonics / kBase, 1.5));
}

/// The spring that a stop is; null of others.
const Spring* spring_of(const Problem& problem, Eigen::Index contact) {
  return std::get_if<Spring>(&problem.contacts[static_cast<std::size_t>(contact)].law);
}

/// Row n of the result is blocks[n] times row n of the packed spectrum.
Eigen::MatrixXcd multiplied(const std::vector<Eigen::MatrixXcd>& blocks, const Eigen::VectorXd& packed) {
  Eigen::MatrixXcd spectrum = unpack_harmonics(packed, static_cast<int>(blocks.size()) - 1);
  for (Eigen::Index n = 0; n < spectrum.rows(); ++n) {
    const Eigen::VectorXcd row = spectrum.row(n).transpose();
    spectrum.row(n).transpose().noalias() = blocks[static_cast<std::size_t>(n)] * row;
  }
  return spectrum;
}

/// The mean of |C_n - own| over H/2 <= n <= H, per contact [m/N]. Of compliances rather than of stiffnesses:
/// antiresonances must not count.
Eigen::VectorXd dynamic_compliance(const ContactReceptance& receptance, const Eigen::VectorXd& own) {
  const int highest = receptance.harmonics();
  const int lowest = (highest + 1) / 2;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(receptance.contacts());
  for (int n = lowest; n <= highest; ++n) {
    const Eigen::VectorXcd of_contacts = receptance.receptance[static_cast<std::size_t>(n)].diagonal();
    mean += (of_contacts - own).cwiseAbs() / (highest - lowest + 1);
  }
  return mean;
}

/// How far a contact without mass gives way to a unit force while all else stands; 0 of others [m/N].
Eigen::VectorXd massless_compliance(const Problem& problem) {
  Eigen::VectorXd own = Eigen::VectorXd::Zero(problem.contact_count());
  const SparseMatrix W = contact_directions(problem), held = problem.stiffness() * W;
  for (int j = 0; j < problem.contact_count(); ++j) {
    const double stiffness = held.col(j).dot(W.col(j));
    const bool massless = std::holds_alternative<Massless>(problem.contacts[static_cast<std::size_t>(j)].law);
    if (massless && stiffness > 0.0) own[j] = std::pow(W.col(j).squaredNorm(), 2) / stiffness;
  }
  return own;
}

}  // namespace

Eigen::VectorXd highest_dynamic_stiffness(const ContactReceptance& receptance) {
  return dynamic_compliance(receptance, Eigen::VectorXd::Zero(receptance.contacts())).cwiseInverse();
}

ProjectedLaw with_stiffness_factor(const ProjectedLaw& law, double factor) {
  return {factor * law.constant, (1.0 - factor * (1.0 - law.multiplier_weight.array())).matrix()};
}

ProjectedLaw on_springs(const ProjectedLaw& law, double r) {
  const double share = r / (1.0 + r);
  return {share * law.constant, share * law.multiplier_weight};
}

ProjectedLaw lipschitz_law(const Problem& problem, const std::optional<double>& c,
                           const ContactReceptance& receptance) {
  const Eigen::VectorXd stop = stop_compliance(problem);
  ProjectedLaw law;
  if (c) {
    law.constant = *c * contact_stiffness_scale(problem);
  } else {
    // A larger constant than the stiffness of what has no mass, before a contact or behind it, would have y
    // made of the truncated part of lambda.
    const Eigen::VectorXd own = massless_compliance(problem);
    law.constant = (dynamic_compliance(receptance, own) / kConstantMultiple + own + stop).cwiseInverse();
  }
  law.multiplier_weight = (1.0 - law.constant.array() * stop.array()).matrix();
  return law;
}

ProjectedLaw penalty_law(const Problem& problem, const StopPenalty& penalty,
                         const ContactReceptance& receptance) {
  Eigen::VectorXd scale;
  if (penalty.asked || penalty.rigid) scale = contact_stiffness_scale(problem);
  ProjectedLaw law{.constant = highest_dynamic_stiffness(receptance),
                   .multiplier_weight = Eigen::VectorXd::Zero(problem.contact_count())};
  for (Eigen::Index j = 0; j < law.constant.size(); ++j) {
    const auto* spring = spring_of(problem, j);
    if (penalty.asked)
      law.constant[j] = penalty.asked->in_units_of(scale[j]);
    else if (spring != nullptr)
      law.constant[j] = spring->stiffness;
    else if (penalty.rigid)
      law.constant[j] = penalty.rigid->in_units_of(scale[j]);
    else
      law.constant[j] *=
          penalty_multiple(problem.contacts[static_cast<std::size_t>(j)].law, receptance.harmonics());
  }
  return law;
}

RepresentedLaw projected_method_law(const Problem& problem, const std::optional<Scaled>& penalty) {
  if (!penalty || !has_springs(problem)) return with_restitution(problem, 1.0);
  const Eigen::VectorXd scale = contact_stiffness_scale(problem);
  Problem asked = problem;
  for (Eigen::Index j = 0; j < scale.size(); ++j) {
    ContactLaw& law = asked.contacts[static_cast<std::size_t>(j)].law;
    if (std::holds_alternative<Spring>(law)) law = Spring{penalty->in_units_of(scale[j])};
  }
  return with_restitution(asked, 1.0);
}

ContactSymbol::ContactSymbol(const ContactReceptance& receptance, const ProjectedLaw& law)
    : root_(law.constant.cwiseSqrt()) {
  blocks_.reserve(receptance.receptance.size());
  for (const Eigen::MatrixXcd& c : receptance.receptance) {
    blocks_.emplace_back(root_.asDiagonal() * c * root_.asDiagonal());
    blocks_.back().diagonal() -= law.multiplier_weight;
  }
  if (receptance.rigid_count() == 0) return;
  const MeanBalance balance(receptance);
  Eigen::MatrixXd mean = root_.asDiagonal() * balance.moved * root_.asDiagonal();
  mean.diagonal() -= law.multiplier_weight;
  mean += (law.multiplier_weight.cwiseQuotient(root_)).asDiagonal() * balance.share * root_.asDiagonal();
  blocks_.front() = mean.cast<std::complex<double>>();
}

Eigen::MatrixXcd ContactSymbol::rate(const Eigen::VectorXd& packed) const {
  return multiplied(blocks_, packed);
}

LastingContactInverse::LastingContactInverse(const ContactSymbol& symbol, const Eigen::VectorXd& duty) {
  std::vector<int> lasting;
  for (int c = 0; c < symbol.contacts(); ++c) {
    if (duty[c] > 0.5) lasting.push_back(c);
  }
  if (lasting.empty()) return;
  inverses_.reserve(static_cast<std::size_t>(symbol.harmonics()) + 1);
  for (Eigen::Index n = 0; n <= symbol.harmonics(); ++n) {
    Eigen::MatrixXcd block = Eigen::MatrixXcd::Identity(symbol.contacts(), symbol.contacts());
    for (const int c : lasting) block.row(c) += symbol.block(n).row(c);
    inverses_.push_back(inverse(block));
    // Nc x Nc only; where that is singular by accident, the identity serves as well.
    if (!inverses_.back().allFinite()) inverses_.back().setIdentity();
  }
}

Eigen::VectorXd LastingContactInverse::operator*(const Eigen::VectorXd& packed) const {
  return inverses_.empty() ? packed : pack_harmonics(multiplied(inverses_, packed));
}

}  // namespace signorini
