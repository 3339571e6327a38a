#pragma once
// The states that return after a period of a structure's free motion.

#include <Eigen/Core>

#include "methods/linear_flow/linear_flow.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

/// X for the positions and V for the velocities of a state of the flow, Ns.
Eigen::VectorXd state_units(const LinearFlow& flow, const MotionScales& scales);

/// I - Phi(T) in these units, Ns x Ns.
Eigen::MatrixXd scaled_closure(const LinearFlow& flow, const Eigen::VectorXd& units, double period);

/// I - Phi(T), Phi the transition of a flow over a period: what load and impulses of one period make of a
/// structure at rest, d, belongs to the periodic motion that begins at y_0 = (I - Phi(T))^-1 d.
class PeriodicClosure {
 public:
  /// \param scales  units X and V in which a vanishing pivot is told
  PeriodicClosure(const LinearFlow& flow, const MotionScales& scales, double period);

  /// False where a free motion returns by itself, as at a resonance without damping: the least pivot is below
  /// 1e-12. The condition number would not tell, for where all motions return I - Phi(T) is rounding
  /// altogether.
  [[nodiscard]] bool unique() const;
  /// y_0 of d, both (u, xi, v), Ns. Precondition: unique().
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& d) const;

 private:
  Eigen::VectorXd units_;  // X and V, Ns
  CompleteLuFactors lu_;
};

}  // namespace signorini
