#pragma once
// The periodic motion of a reduced structure against its stops, by marching and Newton's method.

#include <Eigen/Core>
#include <string_view>

#include "methods/deadline.hpp"
#include "methods/marching/contact_march.hpp"

namespace signorini {

/// How hard a periodic motion is looked for.
struct PeriodicMarchSettings {
  double tolerance = 1e-10;       ///< on PeriodicMarch::residual, above the rounding of a period [-]
  int periods = 15;               ///< marched before Newton's method is tried, >= 0 [-]
  int further_periods = 60;       ///< marched where it fails, before it is tried again, >= 0 [-]
  int accelerated_periods = 150;  ///< of Anderson's acceleration where it fails again, >= 0 [-]
  /// The end of the time budget.
  Deadline deadline = {};
};

/// What led to a periodic motion.
enum class MarchedBy {
  newton,        ///< Newton's method after the first periods
  more_periods,  ///< Newton's method after more of them
  anderson,      ///< Anderson's acceleration of the period map
  free_start,    ///< Newton's method from the motion without contact
  nothing,       ///< none of these
};

/// In words.
std::string_view describe(MarchedBy by);

/// A fixed point Y = P(Y) of the period map of a ContactMarch.
struct PeriodicMarch {
  MarchedBy by = MarchedBy::nothing;  ///< nothing: what follows is the last iterate
  double residual = 0.0;              ///< |P(Y) - Y|_2 / |Y|_2 in units of energy [-]
  Eigen::VectorXd state;              ///< Y, as ContactMarch has it
  Eigen::MatrixXd motion;             ///< x at nodes 0..N-1, N x Nc [m]
  Eigen::MatrixXd force;              ///< lambda likewise, N x Nc [N]
  int newton_steps = 0;               ///< of all attempts [-]
  MarchWork work;                     ///< of all attempts

  /// Whether Y is a fixed point to the tolerance.
  [[nodiscard]] bool found() const { return by != MarchedBy::nothing; }
};

/// Marches from rest, then solves P(Y) - Y = 0 by Newton's method with the active sets of the last period
/// frozen, GMRES to 1e-3 and step halving on the norm of the residual [kelley1995]; where that fails, the
/// attempts of MarchedBy in their order, then Newton's method from 24 states of the march, and four times as
/// many accelerated periods. Of the states of a march Newton's method takes the one that a period changed
/// least. An attractor is found wherever marching comes near it; Newton's method may also end at an unstable
/// motion. Deterministic. Linear in N and in the contacts that are closed.
PeriodicMarch march_to_periodic_motion(ContactMarch& march, const PeriodicMarchSettings& settings = {});

/// The same from a state, as that of a coarser grid (`size()` does not depend on N): without marching first.
PeriodicMarch march_from(ContactMarch& march, const Eigen::VectorXd& state,
                         const PeriodicMarchSettings& settings = {});

}  // namespace signorini
