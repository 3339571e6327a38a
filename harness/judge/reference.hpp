#pragma once
// Orbits of a scene computed by the harness itself, to judge answers by.

#include <chrono>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/judge/motion.hpp"
#include "harness/records/record.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/method.hpp"

namespace signorini {

/// How an orbit is looked for.
struct OrbitRequest {
  double tolerance = 1e-11;                      ///< of the integration [-]
  bool shooting = false;                         ///< else marching
  std::shared_ptr<const Trajectory> guess = {};  ///< null: from rest
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Looks for a periodic motion of the problem under the problem's own law. Replaced in tests.
using OrbitSolver = std::function<Solution(const Problem& problem, const OrbitRequest& request)>;

/// The event-driven method. Where it does not apply, the solution says so.
OrbitSolver event_driven_orbits();

/// Tolerances of the two computations whose difference is an orbit's error bar.
inline constexpr double kOrbitTolerance = 1e-11;
inline constexpr double kTightOrbitTolerance = 1e-12;

/// An orbit, known exactly or at two tolerances.
struct CheckedOrbit {
  std::shared_ptr<const Trajectory> orbit = {};  ///< null: none
  std::string reason = {};                       ///< why there is none
  double error_bar = 0.0;                        ///< relative x_l2
  std::optional<double> residual = {};           ///< of the orbit solver's own equations [-]
  std::string source = {};                       ///< how it was found
  std::vector<OrbitEvent> events = {};           ///< exact orbits only, as is what follows
  std::optional<double> return_distance = {};    ///< of one period by CVODE, in the scales of the motion [-]
  std::optional<FloquetMultipliers> floquet = {};
  std::optional<bool> stable = {};
};

/// What is polished. `confirmed` are certificates of orbits of this problem that CVODE has followed for a
/// period already: an orbit with the events of one of them need not be followed again, which on a stiff
/// structure costs more than all else.
struct PolishRequest {
  const Problem& problem;
  const Trajectory& answer;
  std::span<const Certificate> confirmed = {};
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Polishes an answer to the exact orbit behind it, if there is one.
using OrbitPolisher = std::function<CheckedOrbit(const PolishRequest& request)>;

/// The harness's ways to orbits. Without a polisher, all is left to the solver at two tolerances.
struct OrbitTools {
  OrbitTools(OrbitSolver flow, OrbitPolisher polisher = {})
      : solver(std::move(flow)), polish(std::move(polisher)) {}
  OrbitSolver solver;
  OrbitPolisher polish;
};

/// Looks for an orbit at kOrbitTolerance as asked, then again by shooting from there at the tighter one (by
/// marching again if that fails and marching was asked for). An orbit whose two versions differ by more
/// than `largest_error_bar` is none.
CheckedOrbit find_orbit(const Problem& problem, const OrbitSolver& solver, OrbitRequest request,
                        double largest_error_bar);

/// What is known of a scene under one law before an answer is judged: the motion reached from rest, which is
/// what "the same orbit" in tables means, and the orbits confirmed so far.
struct Reference {
  std::shared_ptr<const SampledTrajectory> orbit = {};  ///< null: none
  std::string reason = {};                              ///< why there is none
  double error_bar = 0.0;                               ///< <= 1e-9
  std::optional<double> residual = {};
  std::string fingerprint = {};
  std::vector<Certificate> confirmed = {};  ///< of exact orbits, by CVODE; see PolishRequest
};

/// Marches at kOrbitTolerance and polishes what it comes to, if the polish stays with it; else by find_orbit.
Reference compute_reference(const Problem& problem, const OrbitTools& tools,
                            std::chrono::steady_clock::time_point deadline);

nlohmann::ordered_json to_json(const Reference& reference);
Reference reference_from_json(const nlohmann::ordered_json& json);  ///< \throws BadRecord

/// The problem under the law that a method represents; the scene's own where that is undetermined.
Problem under_law(const Problem& problem, const RepresentedLaw& law);

}  // namespace signorini
