#pragma once
// All branches of a method of hat functions that hang together with its answers at both ends.

#include <functional>
#include <memory>

#include "methods/curve.hpp"
#include "methods/hat_functions/continuation/hat_tracer.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Follows, from both ends of the interval, the contact-free motion where nothing touches and the method's
/// own answer on the grid of the family, into the interval. Where a contact-free motion grazes, also the
/// motions of more periods, up to the largest order, of which one passage presses and the others open: those
/// that the complementarity conditions allow beside the grazing. What lies on a branch already followed is
/// left out. Doublings are not looked for.
///
/// \param prepare  the method itself for a scene at one frequency, on the nodes of the family
BranchDiagram hat_diagram(const HatFamily& family, double from, double to,
                          const std::function<std::unique_ptr<PreparedMethod>(const Problem&)>& prepare,
                          const CurveLimits& limits);

}  // namespace signorini
