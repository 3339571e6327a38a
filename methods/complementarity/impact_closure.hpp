#pragma once
// The series of H harmonics behind given impacts: a bordered Newton method for the projected equations whose
// stops are moved.

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/impact_motion.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/contact_phases.hpp"

namespace signorini {

/// Over H: the longest share of the period that the contact of an impact takes in a series.
inline constexpr double kLongestContact = 2.5;

/// The end of a closure.
struct ImpactClosure {
  bool converged = false;         ///< the series has one contact for each impact, and no other
  std::string_view failure = {};  ///< why not, a few words
  int steps = 0;                  ///< of the bordered Newton method
  double residual = 0.0;          ///< of the projected equations with the stops there, as project_exactly's
  std::optional<double> condition = {};  ///< estimate for the bordered matrix of the last step [-]
  Eigen::MatrixXcd lambda = {};          ///< (H+1) x Nc [N]
  StopShifts shifts = {};                ///< how the stops stand
  double largest = 0.0;                  ///< largest distance of a stop from its place at an impact [m]
};

/// Finds the series of H harmonics whose contacts act as the impacts do: a solution of
///
///     lambda = -P z,    z = max(0, y_k) near impact k,    y_k = c (x + s_k - g) - alpha lambda,    x = x_f +
///     C lambda,
///
/// with the stop of impact k moved by s_k = a_k + b_k (t - t_k), so far that the force has the impact's
/// impulse and centre,
///
///     integral z_k = J_k / T,        integral z_k (t - t_k) = 0        (t as share of the period),
///
/// in the unknowns lambda, a_k, b_k. With t_k and J_k given, the structure far from the impacts is settled:
/// what is left to be found is how each contact is shaped, a local question, whose linear system knows no
/// resonance.
///
/// A contact lasts for a fraction of 1/H, in which no polynomial of degree H can bend much: z is known by its
/// values at a dozen of Gauss' nodes (contact_nodes.hpp), to rounding. Newton's step solves for these and the
/// moved stops with the edges of contact fixed, a dense system of some 15 K unknowns whatever H; then
/// the edges are where the new y_k vanishes. A step costs O(K^2 H + K^3). Steps end where the edges move by
/// less than the root of the tolerance, for the residual is of second order in that.
///
/// The answer is judged as any series is: the residual of the projected equations over the whole period, its
/// contacts looked for anew (ProjectedResidual), must be below the tolerance with K contacts. A stop is moved
/// from 3/H before its impact on: earlier a stop that approaches would cut into the motion. It stays moved
/// until half way to the next impact if it recedes, behind which nothing can be met, else for 3/H.
///
/// Fails where a contact lasts for more than 2.5/H, two impacts on one contact are too near for the series,
/// or the series touches elsewhere.
///
/// \param impacts   settled (ImpactMotion::settle), on contacts that answer like a mass beyond H
/// \param settings  as of project_exactly
/// \param most      steps at most
ImpactClosure close_impacts(const ProjectedEquations& equations, const PeriodicImpacts& impacts,
                            const ExactProjectionSettings& settings, int most = 40);

}  // namespace signorini
