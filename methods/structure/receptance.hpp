#pragma once
// Contact receptances of a scene, by the way that its size asks for.

#include "methods/discretisation/symbols.hpp"
#include "methods/structure/contact_receptance.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// C_n and free response for n = 0..H under the discretisation that gives harmonic n its weights.
/// Loads above harmonic H of the base frequency are dropped. The automatic choice is dense up to 32
/// coordinates; direct to 2000, and where the damping is not proportional or projection turns out to cost
/// more; else reduced, with an error of at most 1e-10 |C_n|_F. \throws SingularStiffness
ContactReceptance contact_receptance(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights,
                                     ReceptanceMethod method = ReceptanceMethod::automatic);

/// C_n and free response of the undiscretised structure for n = 0..H. \throws SingularStiffness
ContactReceptance fourier_receptance(const Problem& problem, int harmonics);

}  // namespace signorini
