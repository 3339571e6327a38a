#pragma once
// Orbits of a scene computed by the harness itself, to judge answers by.

#include <chrono>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "harness/motion.hpp"
#include "harness/sampled_trajectory.hpp"
#include "methods/method.hpp"

namespace signorini {

/// How an orbit is looked for.
struct OrbitRequest {
  double tolerance = 1e-11;                      ///< of the integration [-]
  bool shooting = false;                         ///< else marching
  std::shared_ptr<const Trajectory> guess = {};  ///< null: from rest
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Looks for a periodic motion of the problem under the problem's own law. Replaced in tests, and by the
/// exact-orbit kernel once there is one.
using OrbitSolver = std::function<Solution(const Problem& problem, const OrbitRequest& request)>;

/// The event-driven method; for massless contacts on the condensed scene. Where it does not apply, the
/// solution says so.
OrbitSolver event_driven_orbits();

/// Tolerances of the two computations whose difference is an orbit's error bar.
inline constexpr double kOrbitTolerance = 1e-11;
inline constexpr double kTightOrbitTolerance = 1e-12;

/// An orbit known at two tolerances.
struct CheckedOrbit {
  std::shared_ptr<const Trajectory> orbit = {};  ///< at the tighter tolerance; null: none
  std::string reason = {};                       ///< why there is none
  double error_bar = 0.0;                        ///< relative x_l2 of the two
  std::optional<double> residual = {};           ///< of the orbit solver's own equations [-]
};

/// Looks for an orbit at kOrbitTolerance as asked, then again by shooting from there at the tighter one (by
/// marching again if that fails and marching was asked for). An orbit whose two versions differ by more
/// than `largest_error_bar` is none.
CheckedOrbit find_orbit(const Problem& problem, const OrbitSolver& solver, OrbitRequest request,
                        double largest_error_bar);

/// The motion of a scene reached from rest under one law: what "the same orbit" in tables means.
struct Reference {
  std::shared_ptr<const SampledTrajectory> orbit = {};  ///< null: none
  std::string reason = {};                              ///< why there is none
  double error_bar = 0.0;                               ///< <= 1e-9
  std::optional<double> residual = {};
  std::string fingerprint = {};
};

Reference compute_reference(const Problem& problem, const OrbitSolver& solver,
                            std::chrono::steady_clock::time_point deadline);

nlohmann::ordered_json to_json(const Reference& reference);
Reference reference_from_json(const nlohmann::ordered_json& json);  ///< \throws BadRecord

/// The problem under the law that a method represents; the scene's own where that is undetermined.
Problem under_law(const Problem& problem, const RepresentedLaw& law);

}  // namespace signorini
