#pragma once
// Comparison of the orbits that a new search finds with those that were kept.

#include <string>
#include <vector>

#include "harness/orbits/orbit_file.hpp"

namespace signorini {

/// Instants may differ by this many times the sum of both error bars, plus kInstantFloor, in periods;
/// impulses by as much relative to the largest, amplitudes and multipliers relative to themselves (a
/// multiplier below 1 to 1).
inline constexpr double kErrorBars = 100.0;
inline constexpr double kInstantFloor = 1e-8;
/// The weak impacts before a complete chatter, below this share of the largest impulse, are not compared.
inline constexpr double kWeakEvent = 1e-3;

struct OrbitDifferences {
  std::vector<std::string> differences = {};  ///< what was kept and is not so any more, one line each
  std::vector<std::string> fresh = {};        ///< orbits that were not kept
};

/// Every orbit kept must be there again: order, fingerprint, events, amplitude, multipliers, stability, and
/// whether it is the one from rest. Events are compared after the shift by whole forcing periods that
/// brings them nearest. Another scene file or law is one difference, and nothing else is compared then.
OrbitDifferences compare_orbits(const OrbitFile& kept, const OrbitFile& now);

}  // namespace signorini
