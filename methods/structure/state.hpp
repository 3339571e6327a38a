#pragma once
// Position and velocity of a structure.

#include <Eigen/Core>

namespace signorini {

/// State of the whole structure at one instant.
struct State {
  Eigen::VectorXd u;  ///< Nd [m]
  Eigen::VectorXd v;  ///< Nd [m/s]
};

}  // namespace signorini
