#pragma once
// The identity of a periodic orbit: its events and its fingerprint.

#include <span>
#include <string>
#include <vector>

#include "harness/judge/measures/motion.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// Events of one period, ordered in time: each listed impulse as an impact with its value; where a force
/// begins and ends, close and open, placed linearly between the grid's instants.
std::vector<OrbitEvent> orbit_events(const Motion& motion);

/// The largest |impulse| of the events [N s]; 0 where none has one.
double largest_impulse(std::span<const OrbitEvent> events);

/// Eight hexadecimal digits that hash invariants rounded to four digits: least order, impacts per period
/// above a thousandth of the largest, impulse per forcing period and contact, root mean square of x about its
/// mean; of contacts that have these in common, of their sum too, unless they move together or opposite.
/// Equal for equal orbits, those shifted by whole forcing periods, written over several of their periods or
/// told from another origin included.
std::string fingerprint(const Motion& motion);

/// True if the motions are one orbit: x agrees to 1e-6 of its norm after some shift by whole forcing periods
/// (where b has no norm, if a has none either).
bool same_orbit(const Motion& a, const Motion& b);

}  // namespace signorini
