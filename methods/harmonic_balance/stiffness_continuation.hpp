#pragma once
// Continuation from soft stops to the law's own.

#include <Eigen/Core>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/projected_law.hpp"

namespace signorini {

/// Follows a solution of the exactly projected equations (project_exactly) from stops on springs to the stops
/// of `equations`: behind each stands a spring of stiffness r c (on_springs), r rising from as soft as
/// Newton's method needs, from `lambda`, to infinity. On springs a motion near the rigid one is a good start:
/// there y = c (x - g) - alpha lambda is mostly the displacement, which a series has right where a truncated
/// contact force swings about its own. r rises by up to sixteen times; where Newton's method does not follow,
/// by the root of that (follow_path). Each solve takes at most fifteen steps.
///
/// \param lambda    a force near the solution, (H+1) x Nc [N]
/// \param settings  of the last solve, `most` apart; those before are to 1e-6
/// \return the solution at the stops of `equations`; not converged, without a force and of infinite residual,
///         where it stalled or time was up. Its iterations are all Newton steps, of failed trials too
ExactProjection continue_in_stiffness(const ProjectedEquations& equations, Eigen::MatrixXcd lambda,
                                      const ExactProjectionSettings& settings);

}  // namespace signorini
