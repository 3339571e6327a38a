#pragma once
// Which families of impacting orbits begin where an orbit grazes rigid or damped stops.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// A contact that touches its stop without a speed, on an orbit without that impact.
struct GrazingTouch {
  int contact = 0;
  double phase = 0.0;  ///< after the section [rad]
  double rate =
      1.0;  ///< of its penetration along the orbits without impact, over that of the first touch [-]
};

/// A pattern of impacts in `periods` periods of the orbit that grazes. With K touches in a period, passage
/// number q is that of touch q % K in period q / K.
struct GrazingFamily {
  int periods = 1;           ///< n
  std::vector<int> hits;     ///< which of the n K passages strike, ascending
  bool beyond = true;        ///< on the side where the first touch, continued, would penetrate
  Eigen::VectorXd impulses;  ///< J of the hits per unit of penetration of the first touch, > 0
};

/// All periodic patterns of up to given periods, to first order in the penetration delta of the orbit without
/// impact. Its monodromy M_b over one period from touch b, (0, M^-1 W_b) =: w_b, and the displacement
/// h_a^T of touch a after the state at touch b give
///
///     G_n(a, b, k) = h_a^T M_b^k (I - M_b^n)^-1 w_b,
///
/// the displacement of touch a, k periods after the passage that follows periodic unit impulses at b; with C
/// the matrix of these between all passages, patterns solve
///
///     J >= 0,    C J - delta >= 0,    J . (C J - delta) = 0,
///
/// for delta = +- the rates of the touches. Restitution does not enter. A damped stop that is touched to a
/// depth p takes the impulse p / G, G = C_jj / beta, and its face is left behind by p: w_b has the column of
/// C over beta too, which moves the face, and h_a is of the face. Found by enumerating supports, up to
/// kMostPassages passages, primitive ones, one of each class of rotations.
///
/// The indices of the solutions, sign det C_SS, with 1 for the orbit without impact where it clears all
/// stops, have equal sums on both sides: the fixed points of the return map cannot vanish one by one.
///
/// \param base     the orbit without the grazing impacts, at its least period, no rigid stop pressed
/// \param touches  phases ascending
/// \return empty where a response to the own impulse vanishes: to first order nothing can be said
std::optional<std::vector<GrazingFamily>> grazing_families(OrbitFamily& family, const SequencedOrbit& base,
                                                           const std::vector<GrazingTouch>& touches,
                                                           int most_periods);

/// More passages are not combined [-]
inline constexpr int kMostPassages = 14;

/// C over n K passages for the same arguments; empty where I - M^n is singular or a response to the own
/// impulse vanishes.
Eigen::MatrixXd grazing_response(OrbitFamily& family, const SequencedOrbit& base,
                                 const std::vector<GrazingTouch>& touches, int periods);

/// The patterns of a given C. \param rates  of the K touches
std::vector<GrazingFamily> impact_patterns(const Eigen::MatrixXd& response, const Eigen::VectorXd& rates);

}  // namespace signorini
