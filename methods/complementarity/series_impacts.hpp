#pragma once
// The impacts of a truncated series: a solution of the projected equations taken apart into impacts and
// contact that lasts, and the law of conservative impacts asked of the motion with all harmonics.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/contact_phases.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/structure/periodic_green_function.hpp"

namespace signorini {

/// A phase of contact (contact_phases): without a break, or with breaks that the series cannot tell from
/// none, shorter than 1 / H.
struct ContactEpisode {
  int contact = 0;                              ///< in [0, Nc)
  std::vector<ContactInterval> intervals = {};  ///< in rising order, at least one
  Eigen::VectorXcd lambda = {};                 ///< its part of lambda, n = 0..H [N]
  bool impact = false;  ///< whether it stands for an impact; what follows is of impacts
  double centre = 0.0;  ///< of the force, share of the period [-]
  double force = 0.0;   ///< its mean over the period, J / T > 0 [N]
  Jet load = {};        ///< y at the centre, the shift of the stop included, and its slope per period [N]

  /// Time between the first instant and the last, share of the period [-].
  [[nodiscard]] double width() const { return intervals.back().end - intervals.front().begin; }
  /// Half way between them [-].
  [[nodiscard]] double middle() const { return 0.5 * (intervals.back().end + intervals.front().begin); }
};

/// The episodes behind a solution.
struct ContactEpisodes {
  std::vector<ContactEpisode> impacts = {};  ///< contact by contact, in rising order
  std::vector<ContactEpisode> lasting = {};  ///< all others
  Eigen::MatrixXcd lasting_force = {};       ///< lambda outside impacts, (H+1) x Nc [N]
  double motion = 0.0;                       ///< root mean square of x over contacts and period [m]
  bool lasting_is_shifted = false;           ///< a stop is moved for a contact that is no impact
};

/// Takes a solution apart. An episode is an impact if it lasts for at most 2.5 / H of the period, and a
/// quarter of it, on a coordinate that answers like a mass beyond H.
///
/// \param response  of the structure, beyond H too
/// \param lambda  a solution with the stops at `shifts`, or near one, (H+1) x Nc [N]
/// \param samples  as of positive_intervals
ContactEpisodes contact_episodes(const ProjectedEquations& equations, const PeriodicGreenFunction& response,
                                 const Eigen::MatrixXcd& lambda, const StopShifts& shifts, int samples);

/// y = c (x - g) - alpha lambda of one contact, its stop in its place, n = 0..H [N].
Eigen::VectorXcd augmented_multiplier(const ProjectedEquations& equations, int contact,
                                      const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda);

/// When and how hard impacts are, a column for each: its instant, share of the period [-], and its mean force
/// over the period, J / T > 0 [N].
using Impacts = Eigen::Matrix2Xd;

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
  /// max(0, X - g) of one contact, the largest at `instants` equidistant times [m]. Impacts that solve the
  /// equations are those of a motion only where it is 0: nothing above asks that X stays before the stop
  /// between them.
  [[nodiscard]] double penetration(const Impacts& impacts, int contact, int instants) const;

 private:
  [[nodiscard]] int count() const { return static_cast<int>(impacts_.size()); }
  [[nodiscard]] int contact(int k) const { return impacts_[static_cast<std::size_t>(k)].contact; }

  const PeriodicGreenFunction& response_;
  const Eigen::VectorXd& gap_;
  const std::vector<ContactEpisode>& impacts_;
  Eigen::MatrixXcd lasting_motion_;
};

}  // namespace signorini
