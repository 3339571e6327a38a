#pragma once
// Newton's method on the equations of an orbit, and what is known of its answer.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "methods/orbit/admissibility.hpp"
#include "methods/orbit/exact_trajectory.hpp"

namespace signorini {

enum class OrbitOutcome {
  converged,       ///< an admissible orbit
  chatter,         ///< an admissible orbit with a complete chatter: infinitely many impacts, then contact
  grazing,         ///< an orbit with an impact too slow to tell from none: multipliers undefined
  not_admissible,  ///< the equations hold, the contact conditions do not
  events_merge,    ///< two events of the sequence come together: there is no orbit with it nearby
  no_convergence,  ///< Newton's method failed, or no sequence was found
};

/// Lower-case words for messages and records: "converged", "not admissible", ...
std::string describe(OrbitOutcome outcome);

struct PolishOptions {
  double tolerance = 1e-12;      ///< of the residual, relative to the scales of the motion [-]
  int max_iterations = 40;       ///< Newton steps
  double admissibility = 1e-11;  ///< penetration and tension allowed, in scales [-]
  double chatter = 1e-9;         ///< displacement that the summed rest of a chatter may leave out, over X [-]
  double grazing = 1e-7;         ///< approach speed over V below which an impact grazes [-]
  bool second_evaluation = false;  ///< evaluate once more, by Green's function or exponentials
};

/// A polished orbit, or why there is none.
struct ExactOrbit {
  OrbitOutcome outcome = OrbitOutcome::no_convergence;
  std::string reason;                                 ///< one clause
  std::string origin;                                 ///< of the sequence that led here
  std::shared_ptr<const ExactTrajectory> trajectory;  ///< where the equations were solved
  double residual = 0.0;                              ///< largest of the equations, in scales [-]
  double attainable = 0.0;                            ///< round-off of the residual [-]
  double error_bar = 0.0;  ///< of the motion, relative to X: |J^-1| times the residual and its noise [-]
  double condition = 1.0;  ///< estimate for J, in its scales; where there is a trajectory [-]
  int iterations = 0;      ///< Newton steps
  Eigen::VectorXcd multipliers;  ///< Floquet, 2 Nd; empty where undefined
  Admissibility admissibility;

  /// An orbit of the scene stands behind this.
  [[nodiscard]] bool certified() const {
    return outcome == OrbitOutcome::converged || outcome == OrbitOutcome::chatter;
  }
  [[nodiscard]] double largest_multiplier() const {
    return multipliers.size() == 0 ? 0.0 : multipliers.cwiseAbs().maxCoeff();
  }
};

/// Solves the orbit equations from a guess by Newton's method. Steps are shortened so that no interval
/// between events loses more than four fifths of its length, and halved until the residual falls.
///
/// Converged: residual <= tolerance, or at the round-off of its evaluation (`attainable`, 32 epsilon times
/// the largest state met). The error bar is the largest row sum of |J^-1|, rows of instants weighted with the
/// speed there, times residual plus `attainable`; with `second_evaluation` no less than
/// the distance to a second evaluation: of purely impulsive orbits the motion by the periodic Green's
/// function at 17 instants, else |J^-1 r'|, r' the residual by matrix exponentials. Failures are outcomes,
/// never exceptions.
ExactOrbit polish_sequence(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess,
                           const PolishOptions& options = {});

}  // namespace signorini
