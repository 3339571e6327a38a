#pragma once
// Impacts of a truncated series made to satisfy the law of impact with all harmonics.

#include <Eigen/Core>
#include <optional>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/contact_phases.hpp"
#include "methods/structure/periodic_green_function.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The end of a compensation.
struct CompensatedImpacts {
  bool converged = false;       ///< the impact law holds; true where there is no impact
  bool exact = false;           ///< the projected equations have a solution near the one handed in
  int impacts = 0;              ///< per period
  int iterations = 0;           ///< Newton steps on the projected equations, all of them
  double largest = 0.0;         ///< largest distance of a stop from its place while an impact acts [m]
  ExactProjection series = {};  ///< of the projected equations with the stops there; none unless converged
  StopShifts shifts = {};       ///< empty where nothing is shifted
};

/// Moves the stops that a truncated series meets, so that its motion obeys the law of impact.
///
/// A series of H harmonics rounds the kink of an impact off and spreads its impulse J over 1/H of the period.
/// From some distance in time both are invisible: the motion is that of an impulse J at the centre t_k of the
/// force. Near by they are not: the series stays short of the kink's tip by about (2 J / T) sum_{n > H}
/// |C_n|, and stopping the series at the gap is what limits harmonic balance to an error of 1/H
/// (docs/theory.md). So the impact law is asked of the motion with all harmonics instead,
///
///     X(t) = x_f(t) + C lambda_lasting - sum_l J_l G(t - t_l),   X(t_k) = g,   X'(t_k) = 0,
///
/// X' being the mean of both sides and lambda_lasting the force outside impacts. The stop that the series
/// meets at impact k is moved, x <= g - distance - speed (t - t_k), until these equations hold. With a
/// penalty spring for a rigid stop the same takes back the penetration of the spring. The answer remains a
/// series of H harmonics: its error is that of the best one of so many, but for terms of second order in the
/// duration of the force. In X the contact does no net work; in the series it does what the harmonics beyond
/// H dissipate, of order 1/H and of the damping.
///
/// What counts as an impact is in series_impacts.hpp: contact that lasts longer, is compliant, or has modes
/// beyond H behind it is left alone.
///
/// Begins at a solution `lambda` of the exactly projected equations with the stops at `shifts`, or near
/// one. Each round solves X(t_k) = g, X'(t_k) = 0 for instants and impulses (ImpactEquations), takes the
/// series' contacts there with stops that let each keep its shape, and solves the projected equations anew
/// (project_exactly). Not converged where an impact comes or goes on the way, the projected equations have
/// no solution near by, or X passes a stop between the impacts.
///
/// \param settings  as of project_exactly; its tolerance is also that of the law of impact, relative to the
///        motion
/// \param response  of the structure with C_n for n = 0..L, L > H; L = 2 H will do
CompensatedImpacts compensate_impacts(const PeriodicGreenFunction& response,
                                      const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                      const StopShifts& shifts, const ExactProjectionSettings& settings);

/// The response to impacts of a scene whose impacts can be compensated, n = 0..L; nothing where none can:
/// the stops are compliant or no contact has mass (the force is then a function of time), or none answers
/// like a mass from H to L. \param receptance  of the scene, n = 0..H \param beyond  L > H
std::optional<PeriodicGreenFunction> response_to_impacts(const Problem& problem,
                                                         const ContactReceptance& receptance, int beyond);

}  // namespace signorini
