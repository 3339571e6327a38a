#pragma once
// Scenes whose contact coordinates carry no mass, and the static contact problem that closes them.

#include <Eigen/Core>
#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// Mass 1 kg on springs of 1 N/m to the wall and of `spring` to a massless node with a stop; damping 0.1,
/// load cos(2.2 t) on the mass.
Problem massless_node(double gap = 0.2, double spring = 20.0);

/// Four masses and three massless coordinates, all coupled by springs drawn from `seed`; three contacts, each
/// on all massless coordinates; loads on both kinds, of harmonics 0 to 2.
Problem coupled_massless_scene(unsigned seed);

/// A massless ring tied to a disc (the rotor of oracle 1i, unbalance 0.1 m at `speed`) by `spring`, in a
/// polygon of `facets` rigid stops at 0.3 m.
Problem ring_in_polygon(int facets, double speed, double spring);

/// What the contact coordinates do under the others: displacement and force of every contact.
struct StaticContact {
  Eigen::VectorXd x;       ///< Nc [m]
  Eigen::VectorXd lambda;  ///< Nc [N]
};

/// K_bb u_b = f_b(time) - K_bi u_i + W_b lambda under Signorini's conditions, b the coordinates in
/// `massless`, by trying all sets of closed contacts, each a dense solve in u_b and lambda together. Shares
/// no code with the library. \throws std::runtime_error if no set satisfies the conditions
StaticContact static_contact(const Problem& problem, const std::vector<int>& massless, double time,
                             const Eigen::VectorXd& u_with_mass);

}  // namespace signorini::test
