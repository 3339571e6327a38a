#pragma once
// From a solution with few harmonics and a soft constant to one with all of them.

#include <Eigen/Core>
#include <functional>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/method.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The law that a method imposes on a structure of so many harmonics: its constant may grow with them.
using LawAt = std::function<ProjectedLaw(const ContactReceptance&)>;

/// C_n and free response of the first harmonics alone.
ContactReceptance truncated(const ContactReceptance& receptance, int harmonics);

/// The same law in continuous time with `softness` times its constant: y = s c (x - g) - (1 - s (1 - relief))
/// lambda. After projection the contact is s^{-1/2} times as long, and fewer samples resolve it.
ProjectedLaw softened(const ProjectedLaw& law, double softness);

/// The solution in which each contact presses at all times or never: which ones press, the mean of the load
/// says (one small complementarity problem); their forces come from one small solve per harmonic. `converged`
/// if they press throughout and the others stay open.
ExactProjection permanent_contact(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                  const ProjectedLaw& law, double tolerance);

/// The place where a climb begins: few harmonics, enough for every load, and a soft constant.
struct ClimbFoot {
  int harmonics = 0;      ///< 0: nothing to climb [-]
  double softness = 1.0;  ///< share of the constant of the law to begin with [-]
};

/// Twenty harmonics, fewer (down to five) where there are more than ten contacts, more where the load needs
/// them. Nothing to climb (harmonics = 0) if that is all.
ClimbFoot climb_foot(const ContactReceptance& receptance);

/// What a climb came to.
struct HarmonicClimb {
  int iterations = 0;   ///< Newton steps, those of failed attempts included
  ExactProjection top;  ///< with all harmonics and the law's own constant; not converged where it got stuck
};

/// Follows a solution of the exactly projected equations (project_exactly) from `foot` to all harmonics of
/// `receptance` at the full constant, doubling harmonics and stiffening in steps that are halved where
/// Newton does not follow. A solution so found costs a few dense solves of (2 H + 1) Nc unknowns where a path
/// of pivots on the fine grid costs thousands of updates.
/// \param lambda  the solution at the foot, (foot.harmonics + 1) x Nc [N]
HarmonicClimb climb_harmonics(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                              const LawAt& law_at, const ClimbFoot& foot, Eigen::MatrixXcd lambda,
                              double tolerance, const Start& start);

}  // namespace signorini
