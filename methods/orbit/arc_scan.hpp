#pragma once
// Contact displacements and forces along an arc: samples close enough to miss no local maximum, and the
// maxima.

#include <cmath>
#include <span>
#include <vector>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

/// (x_j - offset) / unit, or (lambda_j - offset) / unit, along an arc; a negative unit turns minima into
/// maxima.
struct LimitedOutput {
  const LinearArc& arc;  ///< kept by the caller
  int contact;           ///< j
  bool of_force;         ///< lambda_j, else x_j
  double offset;         ///< [m] or [N]
  double unit;           ///< [m] or [N]

  /// order-th time derivative.
  [[nodiscard]] double value(double t, int order) const {
    return limited(of_force ? arc.force(contact, t, order) : arc.displacement(contact, t, order), order);
  }
  /// The same of an x_j or a lambda_j, or of their derivative.
  [[nodiscard]] double limited(double raw, int order) const {
    return (raw - (order == 0 ? offset : 0.0)) / unit;
  }
  /// Bound of the magnitude of its second derivative from a time on.
  [[nodiscard]] double curvature_bound(double t) const {
    return (of_force ? arc.force_bound(contact, t) : arc.displacement_bound(contact, t)) / std::abs(unit);
  }
};

/// A limited output at one instant.
struct LimitedSample {
  double time = 0.0;       ///< [s]
  double value = 0.0;      ///< of LimitedOutput
  double rate = 0.0;       ///< its first derivative
  double curvature = 0.0;  ///< its second
  bool maximum = false;    ///< a local maximum inside the arc; rate and curvature are left 0
};

/// Those of the outputs of one arc, all of contacts that act or all of open ones (OpenContacts), that may be
/// above zero between `begin` and `end`, by values alone at a sixteenth of the fastest period of all terms
/// that make more than 1e-7. Of most contacts most of the time this is known without resolving what is
/// smaller. Allowed for are eight times the estimate, by second differences, of what is between two samples,
/// and 1e-4; an arc has eight steps at least. Where that takes more than three quarters of the
/// instants of `largest`, all are returned.
///
/// \param terms  LinearArc::fading_rates of the arc, for `largest`
/// \throws std::runtime_error on an arc of more than 2^20 such instants, as `largest` does
std::vector<LimitedOutput> near_limit(const std::vector<LimitedOutput>& outputs, double begin, double end,
                                      const std::vector<FadingRate>& terms);

/// The largest value of each output from `begin` to `end`, both included, all of one arc: among samples at a
/// sixteenth of the fastest period still alive and, where they come near zero, the local maxima between them,
/// polished by Newton's method where the rate changes sign, found by where the rate turns where it is
/// positive only between two samples. The outputs are of contacts that act, or all of open ones.
/// Samples of all outputs are taken together: the modes are evaluated once for each instant.
///
/// \param terms  LinearArc::fading_rates of the arc
std::vector<LimitedSample> largest(std::span<const LimitedOutput> outputs, double begin, double end,
                                   const std::vector<FadingRate>& terms);

/// The values at both ends and the local extremes between them, in their order, with samples only where there
/// can be one: as long as |rate| / (bound of the curvature) the rate keeps its sign.
std::vector<LimitedSample> extremes(const LimitedOutput& f, double begin, double end,
                                    const std::vector<FadingRate>& terms);

}  // namespace signorini
