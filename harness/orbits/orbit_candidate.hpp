#pragma once
// What a start of the search for orbits leads to, and where the search starts from.

#include <array>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/judge/orbit_solver.hpp"
#include "methods/catalogue.hpp"
#include "methods/flow/flow.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "problems/problem.hpp"

namespace signorini {

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

/// The names between processes.
template <>
struct EnumNames<OrbitCandidate::Origin> {
  /// In order.
  static constexpr std::array<std::string_view, 4> values{"rest", "method", "grid", "state"};
};

/// Options of a search that ends at the deadline.
SearchOptions search_until(Deadline deadline);

/// Keys `origin`, `source`, `order`, `near`, `reason` and, where there is one, `orbit`; numbers keep every
/// bit.
nlohmann::ordered_json to_json(const OrbitCandidate& candidate);
OrbitCandidate orbit_candidate_from_json(const nlohmann::ordered_json& json);  ///< \throws BadRecord

/// Work that a process of its own does: starts one or several searches, hands each result over at once, and
/// begins none after the deadline.
struct CandidateUnit {
  using Deliver = std::function<void(const OrbitCandidate& candidate)>;
  std::string name = {};
  std::function<void(const Deliver& deliver, Deadline deadline)> work = {};
};

/// A random state: displacements and velocities uniform within a magnitude that is log-uniform in 0.1 to 10
/// scales of the motion, at a random phase of the forcing; the same on every platform.
FlowState random_state(const EventFlow& flow, std::mt19937_64& generator);
/// The one of this number of a seed, which does not depend on which others are drawn.
FlowState random_state(const EventFlow& flow, unsigned seed, int number);

/// The flow that places states before the stops of which they are within 1e-10 of the scales of the motion.
EventFlow placing_flow(const ContactDynamics& dynamics);

/// Starts at period `order` forcing periods, in a fixed order:
///
/// 1. at order 1: marching from rest on the closed-form flow
/// 2. every method that applies, from cold starts with its defaults, its ladder and its further starts
/// 3. hat functions on coarse grids along other covering vectors
/// 4. `starts` random states, the same ones first whatever `starts` is
///
/// \param problem  must outlive the units
std::vector<CandidateUnit> candidate_units(const Problem& problem, int order, int starts, unsigned seed,
                                           std::span<const MethodEntry> catalogue = method_catalogue());

}  // namespace signorini
