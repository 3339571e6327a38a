#pragma once
// Coordinates without mass, which follow the others statically.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "methods/structure/bases/massless_elimination.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Contacts that stay open in a motion: they act on nothing, and are looked at,
/// x_o = N_o^T u_i + xi_o, beta xi_o' + xi_o = s_o(t) + C_oj lambda_j.
struct OpenContacts {
  std::vector<int> contacts;   ///< of the scene, No
  Eigen::MatrixXd normals;     ///< N_o, Nd x No [-]
  Eigen::MatrixXd compliance;  ///< C_oj, by which the forces of the others move them, No x Nc [m/N]
  Eigen::MatrixXcd shift;      ///< s_o, No x Nh [m]
  Eigen::VectorXd relaxation;  ///< beta of each, No [s]
};

/// A scene in its coordinates with mass i. With b those without, K_bb positive definite and the damping there
/// proportional to the stiffness, D_b. = beta K_b. with beta >= 0, a diagonal matrix whose entries differ
/// only between coordinates that K_bb does not couple, as faces of damped stops,
///
///     (1 + beta d/dt) (K_bi u_i + K_bb u_b) = f_b + W_b lambda,
///
/// so that the others move as a structure with contact directions N, and the contacts by u_i and a part xi of
/// their own that relaxes:
///
///     M u_i'' + D u_i' + S u_i = f_i - K_ib K_bb^-1 f_b + N lambda,
///     M = M_ii,   S = K_ii - K_ib K_bb^-1 K_bi,   D = D_ii - K_ib K_bb^-1 beta K_bi,
///     x = N^T u_i + xi,   beta xi' + xi = s(t) + C lambda,
///     N = W_i - K_ib K_bb^-1 W_b,   C = W_b^T K_bb^-1 W_b,   s = W_b^T K_bb^-1 f_b.
///
/// Without damping at b, beta = 0, the massless coordinates follow statically, xi = s + C lambda: where every
/// contact acts on them, x <= g, lambda <= 0, lambda (x - g) = 0 is a linear complementarity problem in C,
/// which has one solution x for every u_i and one lambda where the columns of W_b are independent, and lambda
/// is a Lipschitz function of (u_i, t). With beta > 0 the same is true of the speeds: lambda jumps where a
/// contact closes, by -C_jj^-1 beta x'_-, and x is continuous. No impact law is needed in either case
/// [khenous2008]. A scene without massless coordinates is left as it is: N = W, C = 0, s = 0, beta = 0.
///
/// With an obstacle all else is empty.
struct CondensedStructure : MasslessElimination {
  SparseMatrix mass;       ///< Nd x Nd, Nd = |i| [kg]
  SparseMatrix damping;    ///< Nd x Nd [N s/m]
  SparseMatrix stiffness;  ///< Nd x Nd [N/m]
  /// beta of each contact, the time in which its xi relaxes to s + C lambda; 0 where it follows at once, or
  /// is none. Of contacts whose beta differ C is 0. Nc [s]
  Eigen::VectorXd relaxation = {};
  /// The contacts of the scene that the Nc columns are of, ascending; empty: all of them, in order.
  std::vector<int> acting = {};
  OpenContacts open = {};  ///< the others
};

/// Coordinates beyond which no motion is followed through time: the steps are as short as the fastest mode
/// asks, which a fine mesh makes faster still, and each costs a solve.
inline constexpr int kMostInTime = 10000;
/// The same where contacts relax: damping that grows with the stiffness makes a fine mesh stiff, and each
/// step of an implicit integrator a dense solve.
inline constexpr int kMostRelaxing = 1000;

/// Sparse throughout, but for C and the columns of load and shift. Obstacles: more than `most` coordinates;
/// at massless ones, damping that is not proportional to the stiffness, or an unsymmetric stiffness; contacts
/// on such as relax in different times, or some of which relax and others follow at once.
CondensedStructure condense(const Problem& problem, int most = kMostInTime);

/// The same structure with some of its contacts, the others staying open. A contact without a force changes
/// nothing for the others: what it costs a motion is to be looked at.
/// \param all     with all contacts of the scene
/// \param acting  those that may close, ascending
CondensedStructure with_open_contacts(CondensedStructure all, const std::vector<int>& acting);

/// Why the spring of a contact on damped coordinates without mass is not followed through time: its x would
/// be one state more, with a time of its own.
std::string spring_on_relaxing(int contact);

/// Why a scene's motion is not followed through time, one clause; empty if it is.
std::string flow_obstacle(const Problem& problem);

}  // namespace signorini
