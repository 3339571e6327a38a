#pragma once
// Contacts and load of a scene on its coordinates with mass, those without mass following statically.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// With i the coordinates with mass and b those without, K_bb positive definite,
///
///     N = W_i - K_ib K_bb^-1 W_b,   C = W_b^T K_bb^-1 W_b,
///     f - K_ib K_bb^-1 f_b on i,    s = W_b^T K_bb^-1 f_b
///
/// are what the elimination of u_b makes of contact directions and load (`CondensedStructure` has the
/// equations). A scene without massless coordinates is left as it is: N = W, C = 0, s = 0.
struct MasslessElimination {
  std::string obstacle;       ///< why this cannot be done, one clause; all but kept and massless is empty
  std::vector<int> kept;      ///< i, ascending: coordinates of the scene
  std::vector<int> massless;  ///< b, ascending
  SparseMatrix normals;       ///< N, |i| x Nc [-]
  SparseMatrix following;     ///< K_bb^-1 W_b, |b| x Nc [m/N]
  Eigen::MatrixXd massless_compliance;  ///< C, by which a force moves the contacts at once or, relaxing, in
                                        ///< the end, Nc x Nc [m/N]
  /// h omega of the harmonics in the load, ascending, 0 always the first [rad/s].
  std::vector<double> rates;
  Eigen::MatrixXcd load;   ///< of e^{i h omega t}, its real part to be taken; |i| x Nh [N]
  Eigen::MatrixXcd shift;  ///< s likewise, Nc x Nh [m]
};

/// Any number of coordinates; the factors are those of K_bb.
MasslessElimination eliminate_massless(const Problem& problem);

/// The 0/1 matrix that picks coordinates, size x |picked|.
SparseMatrix coordinate_selection(const std::vector<int>& picked, Eigen::Index size);

}  // namespace signorini
