#pragma once
// Harmonic balance whose impacts are compensated, and what to do where they cannot be.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/impact_compensation.hpp"
#include "methods/method.hpp"
#include "methods/resolutions.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The exactly projected equations of a scene.
struct ProjectedEquations {
  const ContactReceptance& receptance;  ///< n = 0..H
  const Eigen::VectorXd& gap;           ///< Nc [m]
  const ProjectedLaw& law;              ///< of each contact
  double tolerance;                     ///< as of project_exactly
};

/// How far compensation goes.
struct CompensationSettings {
  bool second_starts = true;  ///< hat functions are asked where impacts cannot be compensated
  double hardening = 1.0;     ///< factor on the law's constant once they are, see hardening_of [-]
};

/// What stands by a solve whose impacts are to be compensated.
///
/// The equations of few harmonics may be solved by a motion that rattles and is near no orbit: its impacts
/// then cannot be compensated. So the motion of the same scene on hat functions, which come to their answer
/// by another way, is a second place to start from, and where that does not lead to compensated impacts
/// either, the witness that an answer must agree with (docs/decisions/0014).
class CompensatedSolve {
 public:
  /// `problem` must outlive it.
  CompensatedSolve(const Problem& problem, ImpactCompensation compensation,
                   const CompensationSettings& settings);

  /// That of the scene.
  [[nodiscard]] const ImpactCompensation& compensation() const { return compensation_; }
  /// Null where none are wanted, or the scene has too many contacts for as many nodes.
  [[nodiscard]] Resolutions* second_starts() { return grids_ ? &*grids_ : nullptr; }
  /// As of its settings.
  [[nodiscard]] double hardening() const { return hardening_; }

 private:
  ImpactCompensation compensation_;
  double hardening_;
  std::optional<Resolutions> grids_;
};

/// For a scene whose impacts can be compensated (impact_compensation); null for any other.
std::shared_ptr<CompensatedSolve> compensated_solve(const Problem& problem,
                                                    const ContactReceptance& receptance,
                                                    const CompensationSettings& settings);

/// The answer of `solve` with its impacts compensated, and the work of both. A guess with compensated impacts
/// is taken up by Newton's method first. Compensated impacts are then made shorter by a harder law, where
/// Newton's method follows and the motion stays the same. Where the answer's impacts cannot be compensated,
/// hat functions give a second start; where that does not serve either, the answer stays what it is, and is
/// claimed only if the motion on hat functions is near it. With a limit on pivots and steps in all (0: none)
/// only the answer itself is compensated, within it. The message says which. `compensated` null: the answer
/// of `solve` alone. `solve` gives a FourierTrajectory under the law of `equations` where it converges, and
/// adds to the work handed to it.
Solution solve_compensated(CompensatedSolve* compensated, const ProjectedEquations& equations, long limit,
                           const Start& start, Work work, const std::function<Solution(Work&)>& solve);

}  // namespace signorini
