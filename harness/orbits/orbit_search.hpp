#pragma once
// All certified orbits of a scene under its own law.

#include <map>
#include <string>
#include <vector>

#include "harness/judge/measures/motion.hpp"
#include "harness/judge/orbit_solver.hpp"
#include "harness/orbits/orbit_candidate.hpp"

namespace signorini {

/// Extent and limits of a search.
struct OrbitSearchOptions {
  int starts = 48;         ///< random states at each order
  int subharmonics = 3;    ///< orders 1..this are searched [forcing periods]
  unsigned seed = 1;       ///< of the random states
  double timeout = 600.0;  ///< processor time of the whole search, its two processes together [s]
};

/// Orders searched unless told otherwise: 3, or the scene's own subharmonic if that is higher.
int default_subharmonics(const Problem& problem);

/// One orbit, with all that the harness knows of it.
struct FoundOrbit {
  CertifiedOrbit certified = {};       ///< over the least period; events in [0, period)
  std::string fingerprint = {};        ///< equal for equal orbits
  int order = 1;                       ///< least period in forcing periods
  double period = 0.0;                 ///< [s]
  double amplitude = 0.0;              ///< half of largest minus least x, the largest over contacts [m]
  int starts = 0;                      ///< searches that ended here
  std::vector<std::string> cold = {};  ///< methods whose cold start is within kNearOrbit of it
  bool from_rest = false;              ///< it is the one that marching from rest reaches

  /// Impacts in one period; contact phases: closings in one period, 1 for a contact that never opens.
  [[nodiscard]] int impacts() const;
  [[nodiscard]] int contact_phases() const;
  /// Largest absolute value of a Floquet multiplier; empty where they are undefined.
  [[nodiscard]] std::optional<double> largest_multiplier() const;
};

/// The orbits that a search of a scene found, and what became of all its starts.
struct SceneOrbits {
  std::vector<FoundOrbit> orbits = {};       ///< by order, stable ones first, then by amplitude, larger first
  int searches = 0;                          ///< starts that reported back
  std::map<std::string, int> failures = {};  ///< why starts led to no certified orbit, and how many
  /// Processes that ended before their work did: how, and the names of those that ended so.
  std::map<std::string, std::vector<std::string>> losses = {};
  bool expired = false;      ///< the time limit cut the search short
  bool interrupted = false;  ///< SIGINT did
};

/// Searches order by order: every start of `candidate_units` in a process of its own, two at a time; each
/// admissible orbit found is compared with those known (`same_orbit`: shifts by forcing periods and
/// repetitions at multiples of an order are the same, and the members of a family in which free parts may be
/// anywhere), brought to its least period, and certified by `polish` (exact, confirmed by CVODE). What is not
/// certified is not listed, but counted in `failures`. Of structures too large for a closed form the orbit of
/// `reduced_orbits` comes first; those too large to be followed through time have no others.
///
/// Deterministic for given options, scene and program as long as no time limit strikes (10 s for a method's
/// solve, 2 s for a random state, that of the options for all).
SceneOrbits find_all_orbits(const Problem& problem, const OrbitSearchOptions& options,
                            const OrbitPolisher& polish = {});

/// An orbit of least period `order` forcing periods, with what its motion tells.
/// \param checked  with a motion
FoundOrbit describe_orbit(const Problem& problem, int order, CertifiedOrbit checked);

/// Orders orbits as a search returns them: by order, stable ones first, then by falling amplitude.
void sort_orbits(std::vector<FoundOrbit>& orbits);

/// Polishes and certifies an orbit anew from nothing but its events as they were kept. Empty if they lead to
/// no certified orbit before the deadline, as where a contact is pressed for ever, which is no event. \param
/// confirmed  orbits that CVODE need not follow again, see OrbitPolisher
std::optional<FoundOrbit> certify_again(const Problem& problem, const FoundOrbit& kept, Deadline deadline,
                                        const OrbitPolisher& polish = {},
                                        std::span<const Certificate> confirmed = {});

}  // namespace signorini
