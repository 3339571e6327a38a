#pragma once
// Exact orbits of structures too large for a closed form, on what their contacts feel of them.

#include <functional>
#include <string>

#include "methods/orbit/reduced/corrected_orbit.hpp"
#include "methods/orbit/reduced/failed_attempts.hpp"
#include "methods/reduction/contact_space.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// Why the orbits of a reduced structure do not stand for those of a scene, one clause; empty if they do:
/// it is of the motion of contacts, of which only massless ones and springs keep their law in it
/// (march_obstacle), and the damping has to be proportional.
std::string reduction_obstacle(const Problem& problem);

/// Whether orbits of a scene are those of a reduced structure, corrected, rather than of a closed form of all
/// coordinates: of more than kMostInDenseFlow, or of more than 100 under ten springs and more, whose events
/// make many modes of contact; without a reduction_obstacle.
bool prefers_reduction(const Problem& problem);

/// An orbit of a whole structure.
struct ReducedOrbit {
  CorrectedOrbit corrected = {};  ///< with its bar, or why there is none; its orbit may be none at all
  std::string start = {};         ///< how the motion was found that it was read off
  long iterations = 0;            ///< Newton steps, of marching and of orbits
  FailedAttempts failed = {};     ///< of a search, those without a bar

  /// Why there is no bar, one clause.
  [[nodiscard]] std::string reason() const;
};

/// Another way to a motion near an orbit.
using OtherStart = std::function<Solution()>;

/// Marches `space.small()` to a periodic motion (`march_to_periodic_motion`, kMarchedPerPeriod nodes per
/// forcing period; where that leads to no orbit on 4 and 16 times as many, from the state on the grid
/// before), chooses the vectors that its force needs (`ContactSpace::solved_for`; not where the size of
/// `small` was given), reads an exact orbit off the force (`OrbitFinder`), and corrects it (`correct_orbit`).
/// Failures are outcomes of the orbit; its trajectory may then be empty. \param space  without an obstacle
/// \param harmonic_balance  asked for a motion before anything is marched; may be empty
ReducedOrbit find_reduced_orbit(const Problem& problem, const ContactSpace& space,
                                const OrbitCorrectionSettings& settings,
                                const OtherStart& harmonic_balance = {});

/// The same from a motion of the scene in place of the march: the orbit behind an answer.
ReducedOrbit polish_reduced_orbit(const Problem& problem, const ContactSpace& space, const Trajectory& motion,
                                  const OrbitCorrectionSettings& settings);

/// The same on the vectors that `space` solves on as they are, those of an orbit near the motion
/// (`CorrectedOrbit::space`), as of the frequency before in a response: seldom to be corrected.
ReducedOrbit continue_reduced_orbit(const Problem& problem, const ContactSpace& space,
                                    const Trajectory& motion, const OrbitCorrectionSettings& settings);

}  // namespace signorini
