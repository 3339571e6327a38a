#pragma once
// The seeded populations of scenes on which robustness is measured.

#include <vector>

#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

/// `count` oscillators m = k = F = 1 in contact: log10 d uniform from `least_damping` to -0.5, g in [-0.5,
/// 1], omega in [0.4, 3], those kept whose contact-free amplitude exceeds g. Restitution is 1. The same on
/// every machine: the random numbers are drawn without the library's distributions, whose results vary.
std::vector<ImpactOscillator> contact_population(int count, unsigned long seed = 20151228,
                                                 double least_damping = -2.5);

/// Oscillators damped down to a ratio of 1e-4 (log10 d uniform from -3.7), with restitutions 0, 0.3, 0.5, 0.8
/// and 1 in turn: the population of docs/decisions/0014.
std::vector<ImpactOscillator> hard_population(int count);

/// The oscillators of `contact_population` with restitutions 0, 0.3, 0.5, 0.8 and 1 in turn, as scenes.
std::vector<Problem> restitution_population(int count, unsigned long seed = 20260101);

/// `count` chains of 2 to 5 masses fixed at one end: masses and springs in [0.5, 2], dampers of 10^[-2, -0.5]
/// times the springs, one harmonic load on a random mass, frequency in [0.3, 2.5]; stops on the last mass
/// and, in every other chain, on a second one, gaps between -0.1 and 0.9 of the contact-free amplitude there;
/// restitutions 0, 0.3, 0.5, 0.8 and 1 in turn.
std::vector<Problem> chain_population(int count, unsigned long seed = 20260102);

/// `count` scenes of wide parameters for the judge: one mass in every other scene, with one stop, else a
/// chain of two to four masses fixed at one end with one to three stops on distinct masses, facing either
/// way. Masses and springs in [0.5, 2] (one mass: 1), all modes of one damping ratio 10^[-3, log 0.2], one
/// unit load on a random mass, frequency in [0.4, 3], gaps of -0.5 to 1 of the static deflection under that
/// load; kept where the contact-free motion reaches a stop; restitutions 0, 0.3, 0.5, 0.8 and 1 in turn.
std::vector<Problem> mixed_population(int count, unsigned long seed);

/// `count` cantilever beams of 20 elements, in units of their length, mass and bending stiffness, driven at
/// the tip between 0.4 and 7 times the first eigenfrequency: 1 to 10 stops in turn on distinct deflections of
/// the outer 15 nodes, gaps of 0 to 0.8 of the contact-free amplitude there, the same modal damping ratio
/// 10^[log 0.005, log 0.1] in all modes; restitutions 0, 0.3, 0.5, 0.8 and 1 in turn.
std::vector<Problem> beam_population(int count, unsigned long seed = 20260103);

}  // namespace signorini::test
