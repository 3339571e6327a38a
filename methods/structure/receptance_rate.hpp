#pragma once
// The structure as its contacts see it, with its derivative by the frequency of the load.

#include <Eigen/Core>
#include <vector>

#include "methods/structure/receptance.hpp"

namespace signorini {

/// C_n and x_f of a scene and their derivatives by the frequency of its load.
struct ReceptanceRate {
  ContactReceptance value;                   ///< at the scene's frequency omega
  std::vector<Eigen::MatrixXcd> receptance;  ///< dC_n / d omega, Nc x Nc, n = 0..H [m s/(N rad)]
  Eigen::MatrixXcd free_response;            ///< d free_n / d omega, (H+1) x Nc [m s/rad]
};

/// Both by the same factors of each Z_n: X = Z_n^{-1} [W, f_n] has the derivative -Z_n^{-1} Z_n' X. For the
/// undiscretised structure and for every scheme on a grid (`HatScheme`), whose step falls as 1 / omega, the
/// weight of M is of degree two in omega and that of D of degree one: Z_n' = (2 mass M + damping D) / omega.
/// \throws SingularStiffness
ReceptanceRate receptance_with_rate(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights);

}  // namespace signorini
