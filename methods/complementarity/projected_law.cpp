#include "methods/complementarity/projected_law.hpp"

#include <algorithm>
#include <cmath>

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
double penalty_multiple(const Problem& problem, int harmonics) {
  constexpr double kBase = 10.0;
  if (!std::holds_alternative<Massless>(problem.law)) return kPenaltyMultiple;
  return kPenaltyMultiple * std::max(1.0, std::pow(harmonics / kBase, 1.5));
}

}  // namespace

Eigen::VectorXd highest_dynamic_stiffness(const ContactReceptance& receptance) {
  const int highest = receptance.harmonics();
  const int lowest = (highest + 1) / 2;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(receptance.contacts());
  for (int n = lowest; n <= highest; ++n) {
    // The mean of |C_n| rather than of its inverse: antiresonances must not count.
    mean += receptance.receptance[static_cast<std::size_t>(n)].diagonal().cwiseAbs() / (highest - lowest + 1);
  }
  return mean.cwiseInverse();
}

ProjectedLaw with_stiffness_factor(const ProjectedLaw& law, double factor) {
  return {factor * law.constant, (1.0 - factor * (1.0 - law.multiplier_weight.array())).matrix()};
}

ProjectedLaw lipschitz_law(const Problem& problem, const std::optional<double>& c,
                           const ContactReceptance& receptance) {
  ProjectedLaw law;
  law.constant = c ? Eigen::VectorXd(*c * contact_stiffness_scale(problem))
                   : Eigen::VectorXd(kConstantMultiple * highest_dynamic_stiffness(receptance));
  law.multiplier_weight = Eigen::VectorXd::Ones(law.constant.size());
  if (const auto* stop = std::get_if<Penalty>(&problem.law)) {
    for (Eigen::Index j = 0; j < law.constant.size(); ++j) {
      law.multiplier_weight[j] -= law.constant[j] / stop->stiffness[static_cast<std::size_t>(j)];
    }
  }
  return law;
}

ProjectedLaw penalty_law(const Problem& problem, const std::optional<Scaled>& penalty,
                         const ContactReceptance& receptance) {
  ProjectedLaw law;
  const auto* stop = std::get_if<Penalty>(&problem.law);
  if (penalty) {
    law.constant = contact_stiffness_scale(problem);
    for (double& stiffness : law.constant) stiffness = penalty->in_units_of(stiffness);
  } else if (stop != nullptr) {
    law.constant = Eigen::Map<const Eigen::VectorXd>(stop->stiffness.data(), problem.contact_count());
  } else {
    law.constant = penalty_multiple(problem, receptance.harmonics()) * highest_dynamic_stiffness(receptance);
  }
  law.multiplier_weight = Eigen::VectorXd::Zero(problem.contact_count());
  return law;
}

RepresentedLaw projected_method_law(const Problem& problem, const std::optional<Scaled>& penalty) {
  if (std::holds_alternative<Restitution>(problem.law)) return Restitution{1.0};
  if (penalty && std::holds_alternative<Penalty>(problem.law)) {
    Penalty asked;
    for (const double scale : contact_stiffness_scale(problem))
      asked.stiffness.push_back(penalty->in_units_of(scale));
    return asked;
  }
  return as_represented(problem.law);
}

}  // namespace signorini
