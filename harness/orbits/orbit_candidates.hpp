#pragma once
// Where the search for all orbits of a scene starts from.

#include <chrono>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "methods/catalogue.hpp"
#include "methods/orbit/exact_orbit.hpp"

namespace signorini {

using SteadyTime = std::chrono::steady_clock::time_point;

/// One start of a search and what it led to.
struct OrbitCandidate {
  enum class Origin {
    rest,    ///< marched from rest: the orbit that tables mean by "same"
    method,  ///< a method's cold start under the scene's own law
    grid,    ///< a coarse grid pivoted along another covering vector
    state    ///< a random state on the section
  };
  Origin origin = Origin::state;
  std::string source = {};  ///< "hat-lcp[samples=64]", "random state 7", ...
  int order = 1;            ///< forcing periods after which the orbit closes, not always its least
  bool near = false;        ///< the orbit lies within kNearOrbit of the method's answer
  std::optional<OrbitGuess> orbit = {};  ///< solution of the orbit equations, admissible
  std::string reason = {};               ///< why there is none
};

nlohmann::ordered_json to_json(const OrbitCandidate& candidate);
OrbitCandidate orbit_candidate_from_json(const nlohmann::ordered_json& json);  ///< \throws BadRecord

/// Work that a process of its own does: starts one or several searches, hands each result over at once, and
/// begins none after the deadline.
struct CandidateUnit {
  using Deliver = std::function<void(const OrbitCandidate& candidate)>;
  std::string name = {};
  std::function<void(const Deliver& deliver, SteadyTime deadline)> work = {};
};

/// Starts at period `order` forcing periods, in a fixed order:
///
/// 1. at order 1: marching from rest on the closed-form flow
/// 2. every method of the catalogue that supports the scene and represents its law, with its default options
///    and each step of its ladder; exact-orbit on further grids
/// 3. hat functions on two coarse grids along waved covering vectors (HatSettings::cover_amplitude)
/// 4. `starts` random states: log-uniform magnitudes of 0.1 to 10 scales of the motion, random phase of the
///    forcing, followed for 0 to 20 periods before the search takes over; each by a generator of its own
///    seeded with (seed, order, number), so that the same ones come first whatever `starts` is
///
/// \param problem  must outlive the units
std::vector<CandidateUnit> candidate_units(const Problem& problem, int order, int starts, unsigned seed,
                                           std::span<const MethodEntry> catalogue = method_catalogue());

}  // namespace signorini
