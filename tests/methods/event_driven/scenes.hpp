#pragma once
// Scenes and solves shared by the tests of event-driven.

#include <memory>
#include <vector>

#include "methods/event_driven/event_driven.hpp"
#include "methods/flow/event_trajectory.hpp"
#include "problems/problem.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

/// Two masses of 1 kg on springs of 1 N/m from a wall, stiffness-proportional damping D = 0.1 K, load
/// cos(w t) and a stop of gap 0.5 m on the second mass.
Problem two_masses(double frequency, double restitution);

/// A chain of `count` unit masses on unit springs between two walls, D = 0.05 K, load on the last, no
/// contact.
Problem free_chain(int count, double frequency);

Solution solve(const Problem& problem, const EventDriven::Options& options,
               const std::shared_ptr<const Trajectory>& guess = nullptr);

/// The trajectory of a solution as the method's own type; fails the test if there is none.
const EventTrajectory& trajectory_of(const Solution& solution);

/// The events that the trajectory of a solution lists; fails the test if there is none.
std::vector<ContactEvent> events_of(const Solution& solution);

/// x'_- of an impact of one mass, from its impulse -(1 + e) m x'_- [m/s].
double approach_speed(const ContactEvent& event, double restitution, double mass = 1.0);

/// A guess for a solve that holds nothing but the state at t = 0.
std::shared_ptr<const Trajectory> guess_from(const Problem& problem, const Eigen::VectorXd& u,
                                             const Eigen::VectorXd& v);

/// Largest difference of x between a trajectory and a closed-form orbit over `count` instants, at the best
/// shift of whole forcing periods [m].
double distance(const Trajectory& found, const SingleImpactOrbit& orbit, int count = 997);

}  // namespace signorini::test
