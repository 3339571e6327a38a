#pragma once
// The law of conservative impacts, asked of a motion with all harmonics.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/complementarity/contact_episodes.hpp"
#include "methods/structure/periodic_green_function.hpp"

namespace signorini {

/// When and how hard impacts are.
struct Impacts {
  Eigen::VectorXd time;   ///< of each, share of the period [-]
  Eigen::VectorXd force;  ///< mean over the period, J / T > 0 [N]
};

/// Instants and impulses of the impacts as the series has them.
Impacts impacts_of(const std::vector<ContactEpisode>& episodes);

/// For the motion with all harmonics behind impacts at t_l with impulses J_l,
///
///     X(t) = x_f(t) + C lambda_lasting - sum_l J_l G(t - t_l),
///
/// the equations X(t_k) = g and X'(t_k) = 0 of every impact k, X' being the mean of both sides:
/// restitution 1.
class ImpactEquations {
 public:
  /// Refers to all but `lasting_motion`; the episodes must all be impacts.
  /// \param lasting_motion  x_f + C lambda_lasting, (H+1) x Nc [m]
  ImpactEquations(const PeriodicGreenFunction& response, const Eigen::VectorXd& gap,
                  const std::vector<ContactEpisode>& impacts, Eigen::MatrixXcd lasting_motion);

  /// X(t_k) - g and X'(t_k) T / (2 pi), alternating [m].
  [[nodiscard]] Eigen::VectorXd residual(const Impacts& impacts) const;
  /// Its derivative by time and force of each impact, alternating [m], [m/N].
  [[nodiscard]] Eigen::MatrixXd jacobian(const Impacts& impacts) const;
  /// Impacts that solve the equations to `tolerance` [m], or to `rounding` [m] where Newton's method does not
  /// get that far; nothing if it does not get there either. Forces stay positive.
  [[nodiscard]] std::optional<Impacts> solve(const Impacts& from, double tolerance, double rounding) const;

 private:
  [[nodiscard]] int count() const { return static_cast<int>(impacts_.size()); }
  [[nodiscard]] int contact(int k) const { return impacts_[static_cast<std::size_t>(k)].contact; }

  const PeriodicGreenFunction& response_;
  const Eigen::VectorXd& gap_;
  const std::vector<ContactEpisode>& impacts_;
  Eigen::MatrixXcd lasting_motion_;
};

}  // namespace signorini
