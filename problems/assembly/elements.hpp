#pragma once
// What the matrices of structures are made of: equal finite elements in a row along x, first free at both
// ends, then clamped at x = 0; and how their mass is spread, and contact coordinates freed of it.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "problems/structure.hpp"

namespace signorini {

/// Entries of a matrix; those at the same place add up.
using Entries = std::vector<Eigen::Triplet<double>>;

/// The square matrix of these entries, size x size.
SparseMatrix from_entries(const Entries& entries, Eigen::Index size);

/// Sum of `elements` copies of one symmetric element matrix (2 d x 2 d: the d coordinates of its left node,
/// then those of its right one) along elements + 1 nodes: d (elements + 1) square, node by node from x = 0.
SparseMatrix sum_of_elements(int elements, const Eigen::MatrixXd& element);

/// The square matrices one after the other along the diagonal: structures side by side.
SparseMatrix block_diagonal(const std::vector<SparseMatrix>& parts);

/// A without its first `coordinates` rows and columns: these are held at rest.
SparseMatrix clamped(const SparseMatrix& A, int coordinates);

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
