#pragma once
// How far the contact force of an answer is from an orbit's, impulses and instants included.

#include <vector>

#include "harness/judge/measures/motion.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// Errors of the contact force, contact by contact, from the Fourier coefficients lambda_n of force and
/// impulses over the period common to both, s = n / order the harmonic of the load:
///
///     error_j = |lambda^a - lambda^b|_j,  size_j = |lambda^b|_j,  |lambda|_j^2 = sum_n w_n^2 |lambda_nj|^2.
///
/// w_n = 1 / (1 + s^2): what a mass on a spring, tuned to the load's frequency with the sign of its inertia
/// turned, feels of the force. An impulse that is late by a small share of the period is off by about as many
/// radians of the load; one that is too large by half, or split into two far apart, by that. A push that is
/// spread symmetrically costs the square of its width alone. Harmonics go up to 512 of the load, and of an
/// answer that resolves fewer (`resolved_harmonics`) to those.
///
/// The longer a contact pushes, the more its mean force is statics: of the square of its size that of the
/// mean counts for the share of the period without a push. The size is at least a tenth of the whole.
struct ForceErrors {
  std::vector<double> error = {};  ///< Nc [N]
  std::vector<double> size = {};   ///< Nc [N]

  /// Of the worst contact, in units of the largest size; empty where no contact of the orbit pushes [-].
  [[nodiscard]] Measure worst() const;
};
ForceErrors force_errors(const Motion& answer, const Motion& orbit);

/// Root mean square of the difference of both forces over that of the orbit's, in harmonics of the load up to
/// `harmonics`, all contacts together; empty where no contact of the orbit pushes [-].
Measure force_error_up_to(double harmonics, const Motion& answer, const Motion& orbit);

}  // namespace signorini
