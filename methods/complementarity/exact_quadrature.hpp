#pragma once
// The projected contact equations with the contact integral taken exactly, not sampled.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/stop_shift.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// Intervals of one period on which a trigonometric polynomial is positive, as fractions of the period:
/// from `begin` in [0, 1) to `end` in (begin, begin + 1].
struct ContactInterval {
  double begin = 0.0;  ///< [-]
  double end = 0.0;    ///< [-]
};

/// Where y(t) = scale * shift(t) + sum_{|n| <= H} y_n e^{2 pi i n t} > 0. Sign changes are bracketed on
/// `samples` equidistant instants and the extrema near zero between them, so that contacts shorter than a
/// sample are seen too, and polished to rounding. \param y n = 0..H  \param samples at least 8 H to tell
/// every extremum  \param shifts  shift(t) of one contact, see stop_shift.hpp
std::vector<ContactInterval> positive_intervals(const Eigen::VectorXcd& y, int samples,
                                                const std::vector<StopShift>& shifts = {},
                                                double scale = 1.0);

/// Fourier coefficients n = 0..count of the intervals' indicator function.
Eigen::VectorXcd indicator_spectrum(const std::vector<ContactInterval>& intervals, int count);

/// Fourier coefficients n = 0..count of the shift of one contact's stop, restricted to an interval in which
/// one instant of `shifts` counts [m].
Eigen::VectorXcd shift_spectrum(const ContactInterval& interval, const std::vector<StopShift>& shifts,
                                int count);

/// The indicator function chi of intervals of contact, as polynomials of degree H meet it.
class ContactIndicator {
 public:
  /// Of the union of the intervals, to meet polynomials of degree H = `harmonics`.
  ContactIndicator(const std::vector<ContactInterval>& intervals, int harmonics);

  /// chi_n, n = 0..2 H.
  [[nodiscard]] const Eigen::VectorXcd& spectrum() const { return spectrum_; }
  /// Share of the period that the intervals cover [-].
  [[nodiscard]] double duty() const { return spectrum_[0].real(); }
  /// Coefficients n = 0..H of P[chi s] for a polynomial s, n = 0..H: the exact integral of s over the
  /// intervals, (chi s)_n = sum_{|m| <= H} chi_{n-m} s_m, in O(H log H).
  [[nodiscard]] Eigen::VectorXcd restrict(const Eigen::VectorXcd& s) const;

 private:
  Eigen::VectorXcd spectrum_;
  Eigen::VectorXd values_;  // of the spectrum, on a grid that tells products of degree 3 H from their mirrors
};

/// What project_exactly came to.
struct ExactProjection {
  bool converged = false;  ///< the residual is below the tolerance
  int iterations = 0;      ///< Newton steps
  double residual = 0.0;   ///< |R|_2 / |lambda|_2, or of rounding where that is larger [-]
  std::optional<double> condition =
      {};                   ///< estimate for the Jacobian of the last step; empty: none taken [-]
  Eigen::MatrixXcd lambda;  ///< (H+1) x Nc [N]
};

/// Solves lambda + P max(0, y) = 0, y = c (x - g) - relief lambda, x = x_f + C lambda, with P exact, by
/// Newton from a sampled solution `lambda`. With exact P the contact force does no net work at every
/// contact, to rounding, whatever H and c (docs/theory.md); sampling leaves O(N^-2) of it, irregularly.
/// The edges of contact move with lambda, where y = 0: the residual is continuously differentiable, and
/// Newton converges quadratically where no contact is born or lost. Steps by a dense factorisation of the
/// (2 H + 1) Nc unknowns up to a few hundred of them, beyond by GMRES with products of O(H log H Nc + H
/// Nc^2), preconditioned by LastingContactInverse. \param samples instants on which sign changes are
/// bracketed  \param start  whose deadline ends it between steps  \param shifts  the stops stand at g -
/// shift(t); while that is constant during each contact, the contact still does no net work, and with a speed
/// it does speed J / T of it on the structure
ExactProjection project_exactly(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                const ProjectedLaw& law, const Eigen::MatrixXcd& lambda, int samples,
                                double tolerance, const StopShifts& shifts = {}, const Start& start = {});

}  // namespace signorini
