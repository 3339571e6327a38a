#pragma once
// Where an orbit grazes stops that halt its contacts: the starts of the branches that begin there.

#include <optional>
#include <string>
#include <vector>

#include "methods/orbit/continuation/switching.hpp"
#include "methods/orbit/starts/grazing_families.hpp"

namespace signorini {

/// An orbit that grazes stops, rigid or damped, without the impacts.
struct GrazingOrbit {
  SequencedOrbit base = {};                ///< at its least period
  std::vector<GrazingTouch> touches = {};  ///< phases ascending
  OrbitMark mark = {};                     ///< of it
  std::string obstacle = {};  ///< why nothing is known of what begins there, one clause; else empty
};

/// The orbit behind the end of a curve by a guard that `is_grazing`, without all the impacts, or contacts
/// with damped stops, that fade there.
std::optional<GrazingOrbit> grazing_orbit(OrbitFamily& family, const TracedCurve& curve);

/// The orbit without impact, on the side where it clears the stop that it touches first.
std::optional<CurveStart> start_clear(OrbitFamily& family, const GrazingOrbit& grazing);

/// Families of impacting orbits that begin at a grazing, each on the side where its impacts grow; empty where
/// the first order does not tell.
std::optional<std::vector<CurveStart>> start_impacting(OrbitFamily& family, const GrazingOrbit& grazing,
                                                       int max_order);

}  // namespace signorini
