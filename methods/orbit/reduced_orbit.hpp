#pragma once
// Exact orbits of structures too large for a closed form, on what their contacts feel of them.

#include <memory>
#include <string>

#include "methods/orbit/exact_orbit.hpp"
#include "methods/structure/contact_reduction.hpp"

namespace signorini {

/// Why the orbits of a reduced structure do not stand for those of a scene, one clause; empty if they do:
/// only massless contacts and springs keep their law in it (march_obstacle), the damping has to be
/// proportional, and springs on damped coordinates without mass are not followed (flow_obstacle).
std::string reduction_obstacle(const Problem& problem);

/// Two reductions of a scene, of which one has half as many vectors again.
struct ReducedPair {
  /// \param vectors  of the coarse one, ReductionSettings::vectors; 0: as many as it takes by itself
  /// \throws std::runtime_error with the obstacle of the reduction
  explicit ReducedPair(const Problem& problem, int vectors = 0);

  ContactReduction coarse;  ///< of so many vectors
  ContactReduction fine;    ///< of half as many again
};

/// An orbit of the finer reduction.
struct ReducedOrbit {
  ExactOrbit orbit = {};  ///< polished in the finer reduction: its error bar is that of the reduced structure
  std::string start = {};  ///< how the motion was found that it was read off
  /// max |x - x_coarse| / max |x| over all contacts and 1024 instants, x_coarse of the orbit of the coarse
  /// reduction: what the last vectors changed. No bound of what further ones would [-].
  double change = 0.0;
  long iterations = 0;  ///< Newton steps, of marching and of orbits
};

/// Marches the coarse reduction to a periodic motion (`march_to_periodic_motion`, 256 nodes per forcing
/// period), reads an exact orbit off its force (`OrbitFinder`), and polishes that in the finer one. Failures
/// are outcomes of `orbit`; its trajectory may then be empty.
ReducedOrbit find_reduced_orbit(const Problem& problem, const ReducedPair& pair,
                                const SearchOptions& options);

}  // namespace signorini
