#pragma once
// The seeded population of one-mass scenes on which robustness is measured.

#include <vector>

#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

/// `count` oscillators m = k = F = 1 in contact: log10 d uniform in [-2.5, -0.5], g in [-0.5, 1], omega in
/// [0.4, 3], those kept whose contact-free amplitude exceeds g. Restitution is 1. The same on every
/// machine: the random numbers are drawn without the library's distributions, whose results vary.
std::vector<ImpactOscillator> contact_population(int count, unsigned long seed = 20151228);

/// The oscillators of `contact_population` with restitutions 0, 0.3, 0.5, 0.8 and 1 in turn, as scenes.
std::vector<Problem> restitution_population(int count, unsigned long seed = 20260101);

/// `count` chains of 2 to 5 masses fixed at one end: masses and springs in [0.5, 2], dampers of 10^[-2, -0.5]
/// times the springs, one harmonic load on a random mass, frequency in [0.3, 2.5]; stops on the last mass
/// and, in every other chain, on a second one, gaps between -0.1 and 0.9 of the contact-free amplitude there;
/// restitutions 0, 0.3, 0.5, 0.8 and 1 in turn.
std::vector<Problem> chain_population(int count, unsigned long seed = 20260102);

}  // namespace signorini::test
