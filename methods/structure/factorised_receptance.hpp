#pragma once
// Contact receptances from one factorisation per harmonic.

#include "methods/structure/contact_receptance.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// `contact_receptance` by factorising Z_n for every n = 0..H, O(Nd^3) each if `dense`, else as sparse LU
/// allows. Right-hand sides are solved for a few at a time, so that memory is that of the factors.
/// \throws SingularStiffness
ContactReceptance factorised_receptance(const Problem& problem, int harmonics,
                                        const WeightsOfHarmonic& weights, bool dense);

}  // namespace signorini
