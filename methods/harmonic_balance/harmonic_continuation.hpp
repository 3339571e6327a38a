#pragma once
// Continuation in harmonics: from a solution with few of them and a soft law to one with all.

#include <Eigen/Core>

#include "methods/complementarity/exact_projection.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/method.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// C_n and free response of the first harmonics alone.
ContactReceptance truncated(const ContactReceptance& receptance, int harmonics);

/// A point of the continuation.
struct ContinuationPoint {
  int harmonics = 0;              ///< 0: none [-]
  double stiffness_factor = 1.0;  ///< on the law's constant at so many harmonics (with_stiffness_factor) [-]
};

/// Where the continuation starts: at a sixteenth of the constant and with twenty harmonics; fewer, down to
/// five, where there are more than forty contacts; more where the load needs them. `harmonics` = 0 where that
/// is all of them already, so that there is nothing to continue.
ContinuationPoint continuation_start(const ContactReceptance& receptance);

/// Follows a solution of the exactly projected equations (project_exactly) from `start` to all harmonics of
/// `receptance` at the full constant. Each trial doubles the harmonics at the full constant; where Newton
/// does not follow, the trial moves half of the way back, on logarithmic scales of both (follow_path). A
/// solution so found costs a few solves of (2 H + 1) Nc unknowns where a path of pivots on the fine grid
/// costs thousands of updates (docs/decisions/0007).
///
/// \return with all harmonics and the law's own constant; not converged where it stalled. Its iterations are
///         all Newton steps, those of failed trials included
/// \param lambda  the solution at `start`, (start.harmonics + 1) x Nc [N]
/// \param tolerance  as of project_exactly
/// \param budget  its deadline alone counts
ExactProjection continue_in_harmonics(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                      const LawAt& law_at, const ContinuationPoint& start,
                                      Eigen::MatrixXcd lambda, double tolerance, const Start& budget);

}  // namespace signorini
