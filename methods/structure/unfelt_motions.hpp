#pragma once
// Rigid motions that no contact feels: two bodies that only a contact between them ties together fly on as
// one.

#include <Eigen/Core>
#include <optional>

#include "problems/problem.hpp"

namespace signorini {

/// A scene without the rigid motions R of it that nothing feels, and its coordinates q.
struct WithoutUnfeltMotions {
  Problem problem;      ///< on q: u = Q q, with R^T M Q = 0
  Eigen::MatrixXd of;   ///< q = of u, for all u: what is left of u without its part along R
  bool driven = false;  ///< the load moves the structure along R, to and fro
};

/// Leaves out the rigid motions R with K R = 0, D R = 0 and W^T R = 0: between the rest and them there is no
/// force, R^T M u'' = R^T f, so that contacts do exactly the same, while deviations along R neither grow nor
/// fade. One coordinate of each motion, with mass, is expressed by the others. Nothing where there is no such
/// motion; where the mean load moves the structure along one, R^T f_0 != 0, and it flies away; where stops
/// move; and beyond 400 coordinates.
std::optional<WithoutUnfeltMotions> without_unfelt_motions(const Problem& problem);

}  // namespace signorini
