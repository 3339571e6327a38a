#pragma once
// Coordinates without mass, which follow the others statically.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// A scene in its coordinates with mass i. With b those without, K_bb positive definite and no damping at b,
///
///     u_b = K_bb^-1 (f_b - K_bi u_i + W_b lambda),
///
/// so that the others move as a structure with contact directions N, whose stops are compliant:
///
///     M_ii u_i'' + D_ii u_i' + (K_ii - K_ib K_bb^-1 K_bi) u_i = f_i - K_ib K_bb^-1 f_b + N lambda,
///     x = N^T u_i + s(t) + C lambda,   N = W_i - K_ib K_bb^-1 W_b,   C = W_b^T K_bb^-1 W_b,
///     s = W_b^T K_bb^-1 f_b.
///
/// Where every contact acts on massless coordinates, x <= g, lambda <= 0, lambda (x - g) = 0 is a linear
/// complementarity problem in C, which has one solution x for every u_i and one lambda where the columns of
/// W_b are independent: lambda is a Lipschitz function of (u_i, t), and no impact law is needed
/// [khenous2008]. A scene without massless coordinates is left as it is: N = W, C = 0, s = 0.
struct CondensedStructure {
  std::string obstacle;                 ///< why this cannot be done, one clause; the rest is then empty
  std::vector<int> kept;                ///< i, ascending: coordinates of the scene
  SparseMatrix mass;                    ///< Nd x Nd, Nd = |i| [kg]
  SparseMatrix damping;                 ///< Nd x Nd [N s/m]
  SparseMatrix stiffness;               ///< Nd x Nd [N/m]
  SparseMatrix normals;                 ///< N, Nd x Nc [-]
  Eigen::MatrixXd massless_compliance;  ///< C, by which a force moves the contacts at once, Nc x Nc [m/N]
  /// h omega of the harmonics in the load, ascending, 0 always the first [rad/s].
  std::vector<double> rates;
  Eigen::MatrixXcd load;   ///< of e^{i h omega t}, its real part to be taken; Nd x Nh [N]
  Eigen::MatrixXcd shift;  ///< s likewise, Nc x Nh [m]
};

/// Coordinates beyond which no motion is followed through time: the steps are as short as the fastest mode
/// asks, which a fine mesh makes faster still, and each costs a solve.
inline constexpr int kMostInTime = 10000;

/// Sparse throughout, but for C and the columns of load and shift. More than `kMostInTime` coordinates are an
/// obstacle.
CondensedStructure condense(const Problem& problem);

/// Why a scene's motion between events is no ordinary differential equation of second order; empty if it is
/// one. Damping at coordinates without mass, which makes an equation of first order there, is not done.
std::string flow_obstacle(const Problem& problem);

}  // namespace signorini
