#pragma once
// The motion of a scene that is reached from rest, computed by the harness itself.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/judge/orbit_solver.hpp"
#include "harness/records/record.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/method.hpp"

namespace signorini {

/// The largest error bar of a reference, relative [-]: of a motion followed through time and confirmed, and
/// of a large structure's orbit, whose rounding grows with the condition of K.
inline constexpr double kReferenceErrorBar = 1e-9;
inline constexpr double kLargeReferenceErrorBar = 1e-6;

/// What is known of a scene under one law before an answer is judged: the motion reached from rest, which is
/// what "the same orbit" in tables means, and the orbits confirmed so far.
struct Reference {
  std::shared_ptr<const SampledTrajectory> orbit = {};  ///< null: none
  std::string reason = {};                              ///< why there is none
  double error_bar = 0.0;                               ///< <= 1e-9, of a large structure <= 1e-6
  std::optional<double> residual = {};
  std::string fingerprint = {};
  std::vector<Certificate> confirmed = {};  ///< of exact orbits, by CVODE; see OrbitPolisher
};

/// Marches at kOrbitTolerance and polishes the motion that it reaches. Where there is no exact orbit, or none
/// known to 1e-9, the motion is confirmed at a second tolerance (`confirm_orbit`); where the exact orbit is
/// farther away than marching can have left it, marching has stopped too early and there is no reference.
/// Structures too large for a closed form begin with `tools.large`, and are followed through time only where
/// that leads to none known to kLargeReferenceErrorBar.
Reference compute_reference(const Problem& problem, const OrbitTools& tools, Deadline deadline);

/// The reference that an orbit of the problem makes, which must have a motion.
Reference as_reference(const Problem& problem, CertifiedOrbit orbit);

nlohmann::ordered_json to_json(const Reference& reference);
Reference reference_from_json(const nlohmann::ordered_json& json);  ///< \throws BadRecord

/// The problem under the law that a method represents; the scene's own where that is undetermined.
Problem under_law(const Problem& problem, const RepresentedLaw& law);

}  // namespace signorini
