#pragma once
// The orbits that are known in closed form as guesses of an orbit with its sequence of events.

#include "methods/orbit/orbit_equations.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::test {

/// A closed-form orbit, its section the given share of the period before the impact.
inline OrbitGuess closed_form_guess(const SingleImpactOrbit& orbit, double before) {
  const double section = orbit.impact_time - before * orbit.period;
  return {.start = {.time = section,
                    .state = {.u = Eigen::VectorXd::Constant(1, orbit.x(section)),
                              .v = Eigen::VectorXd::Constant(1, orbit.velocity(section))},
                    .closed = {false}},
          .events = {{.kind = ContactEvent::Kind::impact,
                      .contact = 0,
                      .time = orbit.impact_time,
                      .pushed = {0},
                      .restitution = {orbit.oscillator.restitution},
                      .closed = {false}}},
          .origin = "the closed form"};
}

}  // namespace signorini::test
