#pragma once
// Whether a solution of the orbit equations is a motion of the scene.

#include <string>

#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

struct Admissibility {
  bool ok = true;
  std::string reason = {};      ///< which condition fails, where
  double penetration = 0.0;     ///< largest x_j - g_j of an open contact between events, relative to X [-]
  double tension = 0.0;         ///< largest lambda_j of a closed contact, in the scale of forces [-]
  double weakest_impact = 0.0;  ///< smallest approach speed of an impact, relative to V; 0 without one [-]
  double chatter_error = 0.0;   ///< displacement that the summed rest of a chatter leaves out, over X [-]
  bool chatter = false;         ///< an infinite sequence of impacts ends in sticking
  int impacts = 0;              ///< resolved
};

/// Checks an orbit as last evaluated: between events no open contact beyond its stop and no closed one
/// pulling (sampled at a sixteenth of the fastest period still alive in the guards, local maxima polished by
/// Newton's method, those between two samples found by where the rate turns), approach speeds positive,
/// impulses compressive, each impact by the scene's law. `tolerance` is relative to the scales of the motion.
/// A contact that stops with e > 0 is accepted as the limit of a chatter if the rest of the geometric
/// sequence displaces less than `chatter` X.
Admissibility check_admissible(const OrbitModel& model, const OrbitGuess& orbit,
                               const OrbitEquations& equations, double tolerance, double chatter);

}  // namespace signorini
