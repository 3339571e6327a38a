#pragma once
// The direction in which Lemke's method relaxes a complementarity problem.

#include <Eigen/Core>

#include "methods/solvers/lcp.hpp"

namespace signorini {

/// Covering vector with one smooth wave per period, d_{c,i} = 1 + amplitude * cos(2 pi i / N + phase), and
/// an irregular part of size 1e-9 that separates the ties of symmetric problems, where pivoting could cycle.
/// With amplitude 0 it does not depend on how the unknowns divide into samples and contacts.
/// \param amplitude  in [0, 1) [-]
/// \param phase      [rad]
/// \return d > 0, samples * contacts [-]
Eigen::VectorXd smooth_cover(int samples, int contacts, double amplitude = 0.0, double phase = 0.0);

/// The d for which max(0, guess) solves w = q + tau d + A z at tau = 1: there w = 0 wherever the guess is
/// positive, and w at least a thousandth of max |q| elsewhere, so that no other index is near its bound.
/// \param guess  z of a nearby problem, size of q
Eigen::VectorXd cover_through(const Lcp& lcp, const Eigen::VectorXd& guess);

}  // namespace signorini
