#pragma once
// Which families of impacting orbits begin where an orbit grazes a rigid stop.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// A pattern of impacts in `periods` periods of the orbit that grazes.
struct GrazingFamily {
  int periods = 1;           ///< n
  std::vector<int> hits;     ///< which of the n passages strike, ascending, 0 the first of them
  bool beyond = true;        ///< on the side where the grazing orbit, continued, would penetrate
  Eigen::VectorXd impulses;  ///< J of the hits per unit of penetration, > 0
};

/// All periodic patterns of up to given periods, to first order in the penetration delta of the orbit without
/// impact. Its monodromy M over one period from the grazing, b = (0, M^-1 W_j) and h the displacement of the
/// contact give G_n(k) = h^T M^k (I - M^n)^-1 b, the displacement k periods after periodic unit impulses;
/// with C the circulant matrix of G_n, patterns solve
///
///     J >= 0,    C J - delta >= 0,    J . (C J - delta) = 0,
///
/// for delta > 0 or delta < 0. Restitution does not enter. Found by enumerating supports, primitive ones, one
/// of each class of rotations.
///
/// The indices of the solutions, sign det C_SS, with 1 for the orbit without impact where delta < 0, have
/// equal sums on both sides where n is 1: the fixed points of the return map cannot vanish one by one.
///
/// \param base   the orbit without the grazing impact, at its smallest period, no contact closed
/// \param phase  of the grazing after its section
/// \return empty where G_n(0) vanishes for some n: to first order nothing can be said
std::optional<std::vector<GrazingFamily>> grazing_families(OrbitFamily& family, const SequencedOrbit& base,
                                                           int contact, double phase, int most_periods);

/// G_n(k), k = 0 .. n-1, for the same arguments; empty where I - M^n is singular or G_n(0) vanishes.
Eigen::VectorXd grazing_response(OrbitFamily& family, const SequencedOrbit& base, int contact, double phase,
                                 int periods);

/// The patterns of a given response G_n.
std::vector<GrazingFamily> impact_patterns(const Eigen::VectorXd& response);

}  // namespace signorini
