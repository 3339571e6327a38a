#pragma once
// Answers of harmonic balance whose impacts obey the scene's own restitution: impact closure.

#include <optional>
#include <string>

#include "methods/closed_hbm/closure_setup.hpp"
#include "methods/complementarity/impact_motion.hpp"
#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// What the contact force of a motion tells of its impacts.
struct ImpactSeeds {
  PeriodicImpacts impacts = {};  ///< instants and mean forces of all contacts that are short
  bool lasting = false;          ///< some contact is not
};

/// Reads impacts off a motion: those that it lists; else the phases of its force, which on a grid of nodes
/// are short if they have at most three of them, and in a series of H harmonics up to 2.5/H of the period.
ImpactSeeds impact_seeds(const Trajectory& motion);

/// The end of an impact closure.
struct ClosedAnswer {
  std::optional<Solution> answer = {};  ///< under the scene's restitution; without its work
  std::string reason = {};              ///< why there is none, one sentence; else why attempts before failed
  /// Whether more harmonics may change that: not where a contact lasts, or no impacts are found that obey the
  /// law, which is asked of all harmonics whatever H.
  bool harmonics_may_help = false;
};

/// A periodic motion of the scene under the restitution e of `closure`, 0 <= e <= 1, as a series of H
/// harmonics. In turn from
///
///   1. the guess;
///   2. the motion without contact, or with contacts that press throughout: there no impact is;
///   3. the scene on hat functions with restitution e, on 256, 1024 and 4096 nodes (on 256 alone where
///      `max_iterations` limits pivots and steps),
///
/// instants and impulses of impacts are read off (`impact_seeds`), settled on the motion X with all harmonics
/// (ImpactMotion), and X judged: no impact pulls, X passes no stop by more than 1e-6 of its size, no two
/// impacts that depend on each other coincide. Only then is the series found that acts as these impacts do
/// (close_impacts), under eight times the law's constant or, failing that or where the user chose it, the
/// constant itself. So an answer cannot be of another restitution: X'_+ = -e X'_- holds in X at every impact.
///
/// Contacts that last, or stick, are not closed, nor impacts on contacts that do not answer like a mass
/// beyond H, or nearer than the series resolves.
ClosedAnswer close_answer(const HarmonicSetup& setup, ClosureSetup& closure, const Start& start, Work& work);

/// The same from a converged series of the projected equations, whose impacts have restitution 1, as
/// `closure` must ask for. A series in which each contact presses throughout or never is the answer as it
/// stands.
ClosedAnswer close_series(const HarmonicSetup& setup, const ClosureSetup& closure, const Solution& series,
                          const Start& start, Work& work);

}  // namespace signorini
