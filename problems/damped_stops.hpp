#pragma once
// Stops that are a spring and a damper side by side (Kelvin and Voigt's model): each has a face, a coordinate
// without mass.

#include <utility>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// A stop that is a spring and a damper side by side.
struct DampedStop {
  int contact = 0;  ///< that it stops
  std::vector<std::pair<int, double>> normal =
      {};                  ///< of the structure that it stops, (dof, coefficient [-])
  double stiffness = 0.0;  ///< k > 0 [N/m]
  double damping = 0.0;    ///< c > 0 [N s/m]
};

/// Gives the stops of some contacts a spring k_j and a damper c_j side by side, compressed by s_j >= 0:
///
///     k_j s_j + c_j s_j' = -lambda_j,    w_j^T u - s_j <= g_j,   lambda_j <= 0,   complementary.
///
/// A stop that is touched pushes with k_j (x - g) + c_j x' of x = w_j^T u and never pulls: the contact opens
/// when that is zero, with the stop still compressed, and the stop then goes back by itself with the time c_j
/// / k_j, where a contact that comes too soon meets it. The face, y_j = w_j^T u - s_j, becomes a coordinate
/// of its own, and contact j is then Signorini's at y_j <= g_j,
///
///     K + sum k_j n_j n_j^T,   D + sum c_j n_j n_j^T,   n_j = (w_j, -1) of (u, y_j),
///
/// without mass, hence without an impact law: Massless is its law. Nothing is approximated. Faces are the
/// last coordinates, in the order of the stops.
///
/// \param problem  its contacts on the structure
/// \param stops    by contact, their normals those of the contacts
/// \throws InvalidProblem for constants that are not positive and for normals that are zero or name a
/// coordinate twice
void damp_stops(Problem& problem, const std::vector<DampedStop>& stops);

/// Takes the faces out of the contacts of a scene with damped stops, for those who tell or draw it: its
/// contacts as the structure meets them. Without stops the contacts are left as they are.
std::vector<Contact> contacts_of_structure(std::vector<Contact> contacts,
                                           const std::vector<DampedStop>& stops);

}  // namespace signorini
