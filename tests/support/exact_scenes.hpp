#pragma once
// Small scenes with more than one coordinate, or with spring stops, for the tests of exact flows and orbits.

#include "problems/problem.hpp"

namespace signorini::test {

/// Two masses, one stop on the second, dampers that share no modes with the springs.
Problem skew_damped_pair(double restitution, double frequency = 1.1);

/// m = k = F = 1, damping 0.1, omega = 2.2, gap 0.2 and a stop of stiffness `penalty`.
Problem penalty_oscillator(double penalty, double frequency = 2.2, double gap = 0.2);

/// A chain of unequal masses fixed at one end, driven at the other, with stops on the last `stops` masses.
Problem stopped_chain(int masses, double restitution, int stops = 1, double frequency = 0.7);

}  // namespace signorini::test
