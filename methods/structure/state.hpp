#pragma once
// Position and velocity of a structure.

#include <Eigen/Core>

namespace signorini {

/// State of the whole structure at one instant. Where contacts relax (CondensedStructure::relaxation), u is
/// followed by their xi: u holds Nd + Nc numbers then.
struct State {
  Eigen::VectorXd u;  ///< Nd [m]
  Eigen::VectorXd v;  ///< Nd [m/s]
};

}  // namespace signorini
