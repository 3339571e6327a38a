#pragma once
// The modes of a structure with springs and dashpots to the ground, from those without.

#include <Eigen/Core>
#include <optional>

#include "methods/linear_flow/modes/weak_coupling.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// Each pushes with -(k_j w_j^T q + c_j w_j^T q') along w_j.
struct GroundedSprings {
  Eigen::MatrixXd directions;  ///< w_j, Nr x m [-]
  Eigen::VectorXd stiffness;   ///< k_j > 0, m [N/m]
  Eigen::VectorXd damping;     ///< c_j, m [N s/m]
};

/// The modes of M q'' + (D + sum c_j w_j w_j^T) q' + (K + sum k_j w_j w_j^T) q = f from those of (M, D, K):
/// the undamped modes spring by spring (`add_rank_one`), to rounding of each frequency, and the damping of
/// the springs as a weak coupling. A tenth of the work of `complex_modes`. None where the damping of (M, D,
/// K) is not alpha M + beta K, the springs couple modes strongly, or two frequencies nearly agree. \param
/// without  complex_modes of (M, D, K) \param rate  of the energy [rad/s]
std::optional<ComplexModes> modes_with_springs(const ComplexModes& without, const SparseMatrix& mass,
                                               const GroundedSprings& springs, double rate);

}  // namespace signorini
