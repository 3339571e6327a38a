#pragma once
// The structure's answer to an impulse in every period, from its receptances.

#include <Eigen/Core>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The T-periodic Green's function at the contacts,
///
///     G(tau) = (1/T) sum_n C_n e^{2 pi i n tau / T},
///
/// with all its harmonics: those up to L as given, those beyond as of a mass and a damper,
/// C_n = -a / n^2 - i b / n^3, through C_L. These are summed in closed form; what is neglected is of relative
/// size (omega_0 / (L omega))^2, omega_0 the highest eigenfrequency that the contact sees.
/// (`ModalGreenFunction` finds the same by modes, for small structures whose modes are known.)
class PeriodicGreenFunction {
 public:
  /// \param receptance  C_n, n = 0..L, L >= 1
  explicit PeriodicGreenFunction(ContactReceptance receptance);

  /// T G of contact `row` a time tau = turn T after a unit impulse on contact `column`, and its derivatives
  /// with respect to turn; at turn = 0, where the slope jumps, the mean of both sides, and the curvature
  /// without its impulse [m / N].
  [[nodiscard]] Jet at(int row, int column, double turn) const;
  /// The receptances that it was made of, n = 0..L.
  [[nodiscard]] const ContactReceptance& receptance() const { return receptance_; }
  /// Whether the contact answers like a mass beyond harmonic H: there C_n n^2 is -a within a half of it.
  [[nodiscard]] bool is_mass_beyond(int contact, int harmonics) const;

 private:
  ContactReceptance receptance_;
  Eigen::MatrixXd inertance_;  // a
  Eigen::MatrixXd drag_;       // b
};

}  // namespace signorini
