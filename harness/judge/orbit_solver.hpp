#pragma once
// How the harness finds the orbits that it judges answers by, and what it knows of one that it has found.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/plan/deadline.hpp"
#include "harness/records/record.hpp"
#include "methods/method.hpp"
#include "methods/periodic_motion/periodic_motion.hpp"
#include "methods/reduction/kept_space.hpp"

namespace signorini {

/// A periodic orbit whose error is known: exact, or found at two tolerances.
struct CertifiedOrbit {
  std::shared_ptr<const Trajectory> motion = {};  ///< null: none was found
  std::string reason = {};                        ///< why there is none
  /// Where there is none: a motion that solves the equations of one, and that `reason` keeps from being known
  /// to be one, as where CVODE does not come back to it or it grazes a stop; null: none either.
  std::shared_ptr<const Trajectory> unconfirmed = {};
  double error_bar = 0.0;                      ///< relative x_l2 [-]
  std::optional<double> residual = {};         ///< of the orbit solver's own equations [-]
  std::string source = {};                     ///< how it was found
  std::vector<OrbitEvent> events = {};         ///< exact orbits only, as is what follows
  std::optional<double> return_distance = {};  ///< of one period by CVODE, in the scales of the motion [-]
  std::optional<FloquetMultipliers> floquet = {};
  std::optional<bool> stable = {};
  std::string stability = {};  ///< stability_word
  std::string undefined = {};  ///< why there are no multipliers
  std::vector<OrderOfImpacts> orders = {};
};

/// Follows the flow of a problem under its own law to a periodic motion, as `find_periodic_motion` does.
/// Replaced in tests.
using OrbitSolver =
    std::function<Solution(const Problem& problem, const PeriodicMotionOptions& options, const Start& start)>;

/// `find_periodic_motion` with CVODE. Where a structure cannot be followed through time (`flow_obstacle`),
/// the message says why.
OrbitSolver flow_orbits();

/// Polishes an answer to the exact orbit behind it, if there is one. `confirmed` are certificates of orbits
/// of the same problem that CVODE has followed for a period already: an orbit with the events of one of them
/// need not be followed again, which on a stiff structure costs more than all else.
using OrbitPolisher =
    std::function<CertifiedOrbit(const Problem& problem, const Trajectory& answer,
                                 std::span<const Certificate> confirmed, Deadline deadline)>;

/// The orbit of a structure too large for a closed form of all its coordinates, from rest; a reason without a
/// motion where the scene is none of these, or has none with an error bar.
using LargeOrbitFinder = std::function<CertifiedOrbit(const Problem& problem, Deadline deadline)>;

/// The harness's ways to orbits. Without a polisher, everything is left to the solver at two tolerances;
/// without a finder for large structures, these are followed through time as all others are.
struct OrbitTools {
  OrbitTools(OrbitSolver flow, OrbitPolisher polisher = {}, LargeOrbitFinder finder = {},
             std::shared_ptr<KeptSpace> kept = std::make_shared<KeptSpace>())
      : solver(std::move(flow)),
        polish(std::move(polisher)),
        large(std::move(finder)),
        spaces(std::move(kept)) {}
  OrbitSolver solver;
  OrbitPolisher polish;
  LargeOrbitFinder large;
  std::shared_ptr<KeptSpace> spaces;  ///< of large structures: what is found and measured on them
};

/// Tolerances of the two computations whose difference is an orbit's error bar.
inline constexpr double kOrbitTolerance = 1e-11;
inline constexpr double kTightOrbitTolerance = 1e-12;

/// Options of a search for orbits at kOrbitTolerance: by marching, up to 20 000 periods, or by shooting, up
/// to 50 Newton steps.
PeriodicMotionOptions marching_options();
PeriodicMotionOptions shooting_options();

/// Confirms what `solver` found with `options` from `start`: computes it again from there by shooting at the
/// tighter tolerance (by marching from `start` again if that fails and marching was asked for). The error bar
/// is the distance of the two; an orbit whose error bar exceeds `largest_error_bar` is none.
CertifiedOrbit confirm_orbit(const Problem& problem, const OrbitSolver& solver,
                             const PeriodicMotionOptions& options, const Start& start, const Solution& found,
                             double largest_error_bar);

/// Searches with `solver`, then confirms what it found.
CertifiedOrbit find_orbit(const Problem& problem, const OrbitSolver& solver,
                          const PeriodicMotionOptions& options, const Start& start, double largest_error_bar);

}  // namespace signorini
