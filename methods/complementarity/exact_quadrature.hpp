#pragma once
// Integrals over contact, taken exactly between the instants where it begins and ends.

#include <Eigen/Core>
#include <vector>

#include "methods/discretisation/contact_phases.hpp"

namespace signorini {

/// Samples per harmonic that tell every extremum of a polynomial of that degree.
inline constexpr int kResolvingSamples = 16;

/// Where y(t) = scale * shift(t) + sum_{|n| <= H} y_n e^{2 pi i n t} > 0. Sign changes are bracketed on
/// `samples` equidistant instants and the extrema near zero between them, so that contacts shorter than a
/// sample are seen too, and polished to rounding.
///
/// \param y  n = 0..H
/// \param samples  at least 8 H to tell every extremum
/// \param shifts  shift(t) of one contact, see contact_phases.hpp
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
  /// Takes the union of the intervals, for polynomials of degree H = `harmonics`.
  ContactIndicator(const std::vector<ContactInterval>& intervals, int harmonics);
  /// From chi_n, n = 0..2 H, which may be those of a sampled function.
  explicit ContactIndicator(Eigen::VectorXcd spectrum);

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

}  // namespace signorini
