#pragma once
// The seeded population of one-mass scenes on which robustness is measured.

#include <vector>

#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

/// `count` oscillators m = k = F = 1 in contact: log10 d uniform in [-2.5, -0.5], g in [-0.5, 1], omega in
/// [0.4, 3], those kept whose contact-free amplitude exceeds g. Restitution is 1. The same on every
/// machine: the random numbers are drawn without the library's distributions, whose results vary.
std::vector<ImpactOscillator> contact_population(int count, unsigned long seed = 20151228);

}  // namespace signorini::test
