#pragma once
// Gauss' rules.

#include <Eigen/Core>

namespace signorini {

/// Nodes and weights on [-1, 1].
struct GaussRule {
  Eigen::VectorXd nodes;    ///< rising [-]
  Eigen::VectorXd weights;  ///< likewise; their sum is 2 [-]
};

/// Gauss' rule of so many nodes, exact for polynomials of degree 2 count - 1: the zeros of Legendre's
/// polynomial by Newton's method, O(count^2), once in a thread. \param count  at least 1
const GaussRule& gauss_rule(int count);

/// Nodes by which the integral of e^{i 2 z s} over -1 <= s <= 1 is right to rounding, 1e-13 (1 + z / 50): z,
/// and a part for the ends that grows as the cube root, 5 (1 + z^{1/3}), rounded up by a sixteenth at most.
/// Found by trial. \param z  at least 0 [-]
int gauss_nodes_for(double z);

}  // namespace signorini
