#pragma once
// All branches of a method of hat functions that hang together with its answers at both ends.

#include "methods/curve.hpp"
#include "methods/hat_functions/continuation/hat_tracer.hpp"

namespace signorini {

/// Follows, from both ends of the interval, the contact-free motion where nothing touches and the method's
/// own answer on the grid of the family, into the interval. Where a contact-free motion grazes, also the
/// motions of more periods, up to the largest order, of which one passage presses and the others open: those
/// that the complementarity conditions allow beside the grazing. What lies on a branch already followed is
/// left out. Doublings are not looked for.
///
/// \param scene   over the frequency of its load
/// \param method  itself, on the nodes of the family
BranchDiagram hat_diagram(const HatFamily& family, const ParametrisedScene& scene, const Method& method,
                          const CurveLimits& limits);

}  // namespace signorini
