#pragma once
// How the mass of a finite-element structure is spread, and how contact coordinates are freed of it.

#include <utility>
#include <vector>

#include "problems/sparse_matrix.hpp"

namespace signorini {

enum class ContactMass {
  consistent,  ///< the mass matrix of the shape functions
  lumped,      ///< a diagonal mass matrix
  massless     ///< the consistent one, redistributed so that no contact coordinate carries mass
};

/// A coordinate whose mass is to move as others do: u[dof] stands for sum of weight * u[leader].
struct Follower {
  int dof = 0;                                  ///< the coordinate that follows
  std::vector<std::pair<int, double>> leaders;  ///< (dof, weight [-]), none of them a follower
};

/// P^T M P, where P replaces every follower by what its leaders say. Rows and columns of followers are empty;
/// the result is positive semi-definite if M is. For all motions a, b that the followers' rule reproduces
/// (P a = a), a^T M b is kept: with a rule exact for translations and rotations these are the total mass, its
/// first and its second moments, the conditions of mass redistribution (khenous2008); to extrapolate mass
/// into the structure instead of minimising the change of M goes back to [hager2008].
SparseMatrix redistributed(const SparseMatrix& mass, const std::vector<Follower>& followers);

/// The two nodes without contact that a contact node follows: the nearest on either side, else the nearest
/// two on one side. `second` is -1 if there is only one, both are if there is none. `contact[i]`: node i has
/// a contact.
std::pair<int, int> nearest_free_nodes(const std::vector<bool>& contact, int node);

}  // namespace signorini
