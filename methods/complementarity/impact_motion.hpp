#pragma once
// The motion with all harmonics behind impacts, and the equations that impacts of a given restitution solve.

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The impacts of a period.
struct PeriodicImpacts {
  std::vector<int> contacts = {};                           ///< of each, K, in [0, Nc)
  Eigen::Matrix2Xd moments = Eigen::Matrix2Xd::Zero(2, 0);  ///< 2 x K: instant t_k, share of the period [-],
                                                            ///< and mean force J_k / T > 0 over it [N]

  /// K.
  [[nodiscard]] int count() const { return static_cast<int>(contacts.size()); }
};

/// Impacts that solve their equations.
struct SettledImpacts {
  PeriodicImpacts impacts = {};  ///< instants and mean forces
  int steps = 0;                 ///< of Newton's method
  double defect = 0.0;           ///< largest residual left [m]
};

/// The motion of the contacts with all harmonics behind impacts of impulse J_l at t_l,
///
///     X(t) = x_f(t) - sum_l J_l G(t - t_l),                                        x_f the contact-free
///     motion,
///
/// and the equations of Newton's law of impact, X'_+ = -e X'_-, for it. An impulse J_k takes J_k / m_k off
/// the velocity of its contact, 1 / m_k = (W^T M^-1 W)_kk, so that the law says X'_- = J_k / (m_k (1 + e)),
/// or of the mean of both sides
///
///     X(t_k) = g,        mean X'(t_k) = kappa_k J_k,        kappa_k = (1 - e) / (2 (1 + e) m_k),
///
/// 2 K equations for the 2 K instants and impulses. Beyond harmonic L the response is that of a mass and a
/// damper, C_n = -a / n^2 - i b / n^3 with a and b extrapolated from C_L/2 and C_L, and summed in closed form
/// by Bernoulli's polynomials: what is neglected of X is of third order in 1/L. With m_k taken from the same
/// a the jump of X' obeys the law to rounding.
///
/// Two impacts at one instant are right only where neither contact moves when the other is struck,
/// (W^T M^-1 W)_kl = 0: else a law of joint impact is needed (`are_separate`).
class ImpactMotion {
 public:
  static constexpr int kSettlingSteps = 50;  ///< of Newton's method, more than any motion has needed

  /// Refers to `response` and `gap`.
  /// \param response     C_n, n = 0..L, L >= 1
  /// \param free         x_f, n = 0..L at most, Nc columns [m]
  /// \param gap          g, Nc [m]
  /// \param restitution  e in [0, 1] [-]
  ImpactMotion(const ContactReceptance& response, const Eigen::MatrixXcd& free, const Eigen::VectorXd& gap,
               double restitution);

  /// X(t_k) - g and (mean X'(t_k) - kappa_k J_k) T / (2 pi), alternating, 2 K [m].
  [[nodiscard]] Eigen::VectorXd residual(const PeriodicImpacts& impacts) const;
  /// Impacts that solve the equations to `tolerance`, or to 1e-9 where Newton's method does not get that far,
  /// both relative to `size`; nothing if it does not get there either, or not in so many steps. Impulses stay
  /// positive.
  [[nodiscard]] std::optional<SettledImpacts> settle(const PeriodicImpacts& from, double tolerance,
                                                     int max_steps = kSettlingSteps) const;
  /// Whether no two impacts whose contacts depend on each other fall on one instant, to 1e-9 of the period.
  [[nodiscard]] bool are_separate(const PeriodicImpacts& impacts) const;
  /// Velocity of an impact's contact per period before (first) and after it, X'_- and X'_+ [m].
  [[nodiscard]] std::pair<double, double> velocities(const PeriodicImpacts& impacts, int impact) const;
  /// max(0, X - g), the largest over all contacts and 8 L or more equidistant instants [m]. Nothing above
  /// asks that X stays before its stops between the impacts.
  [[nodiscard]] double overshoot(const PeriodicImpacts& impacts) const;
  /// Root mean square of X over contacts and period [m].
  [[nodiscard]] double size(const PeriodicImpacts& impacts) const;

 private:
  friend class ImpactMotionSystem;

  /// What an impulse and the mass behind it make of the law: pi a (1 - e) / (1 + e) [m / N].
  [[nodiscard]] double loss(int contact) const;
  /// T G of contact `row` a time turn T after a unit impulse on `column`, the mean of both sides at 0.
  [[nodiscard]] Jet answer(int row, int column, double turn) const;
  /// X_n without what lies beyond L, n = 0..L.
  [[nodiscard]] Eigen::VectorXcd spectrum(const PeriodicImpacts& impacts, int contact, bool enriched) const;

  const ContactReceptance& response_;
  Eigen::MatrixXcd free_;
  InertialLimit limit_;  // of the response
  const Eigen::VectorXd& gap_;
  double lost_;  // (1 - e) / (1 + e)
};

}  // namespace signorini
