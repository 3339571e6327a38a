#pragma once
// One start of a search for orbits and the orbit that it led to, as it crosses from one process to another.

#include <array>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "harness/judge/orbit_solver.hpp"
#include "methods/orbit/exact_orbit.hpp"

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

/// Takes over the orbit of a search, or the reason why it found none.
void take_search(const OrbitSearch& search, OrbitCandidate& candidate);

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

}  // namespace signorini
